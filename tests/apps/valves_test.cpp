// SPDX-License-Identifier: MIT
// camopt valves, and the lobe table of export.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace camopt {
namespace valves_test {

using test::ProgramRun;
using test::run_camopt;
using Json = nlohmann::json;

class ValvesCommand : public ::testing::Test {
 protected:
    test::TemporaryFolder folder_;

    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    [[nodiscard]] std::string solved(const std::string& scene) const {
        const ProgramRun run =
            run_camopt("solve " + test::scene(scene) + " --set spline.segments=12 --out " + path(scene));
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        return path(scene);
    }
};

TEST_F(ValvesCommand, SaysOverlapAndClearance) {
    const std::string both = "valves " + solved("valve_intake") + " " + solved("valve_exhaust");
    const ProgramRun data = run_camopt(both + " --gap-mm 3 --included-deg 24 --json");
    ASSERT_EQ(data.exit_code, 0) << data.errors;
    const Json found = Json::parse(data.output);
    EXPECT_NEAR(found["lobe_separation_deg"].get<double>(), 110.0, 1e-9);
    EXPECT_GT(found["clearance_mm"].get<double>(), 0.0);
    bool at_checking_height = false;
    for (const Json& one : found["overlap"])
        if (std::abs(one["height_mm"].get<double>() - 0.15) < 1e-9) {
            at_checking_height = true;
            EXPECT_NEAR(one["overlap_crank_deg"].get<double>(), 26.0, 1e-9);  // 16 before to 10 after
        }
    EXPECT_TRUE(at_checking_height);
    const ProgramRun words = run_camopt(both + " --units in");
    EXPECT_NE(words.output.find("16 BTDC"), std::string::npos) << words.output;
    EXPECT_NE(words.output.find("0.050 in"), std::string::npos) << words.output;
    const ProgramRun touch = run_camopt(both + " --gap-mm 0.05 --included-deg 24");
    EXPECT_EQ(touch.exit_code, 1);
    EXPECT_NE(touch.output.find("THE VALVES TOUCH"), std::string::npos) << touch.output;
}

TEST_F(ValvesCommand, RefusesOtherMotions) {
    const ProgramRun run =
        run_camopt("valves " + test::scene("drd_cubic_12") + " " + test::scene("drd_cubic_12"));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.errors.find("intake: found no motion of type \"valve\""), std::string::npos) << run.errors;
    const ProgramRun lobe =
        run_camopt("export " + test::scene("drd_cubic_12") + " --lobe mm --out " + path("out"));
    EXPECT_EQ(lobe.exit_code, 2);
    EXPECT_NE(lobe.errors.find("--lobe: found no valve lobe"), std::string::npos) << lobe.errors;
}

TEST_F(ValvesCommand, LobeTableReadsBack) {
    const std::string result = solved("valve_intake");
    ASSERT_EQ(
        run_camopt("export " + result + " --lobe in --step-deg 2 --digits 8 --out " + path("cam")).exit_code,
        0);
    const std::string table = read_text_file(path("cam/lobe.csv"));
    EXPECT_TRUE(table.starts_with(
        "theta_deg,crank_angle_deg,s_in,valve_in,v_in_deg,a_in_deg2,j_in_deg3\n-180,-252,0,0,"))
        << table.substr(0, 120);
    EXPECT_NE(table.find("\n0,108,0.38188976,0.37401575,"), std::string::npos) << table;
    EXPECT_EQ(run_camopt("export " + result + " --lobe in --step-deg 0.7 --out " + path("no")).exit_code, 2);
    const ProgramRun alone = run_camopt("export " + result + " --digits 3 --dxf --out " + path("no"));
    EXPECT_NE(alone.errors.find("--digits: found without a table"), std::string::npos) << alone.errors;
    // As a measured cam of the same lobe it deviates, once aligned, by its digits.
    const ProgramRun seen = run_camopt("inspect " + result + " " + path("cam/lobe.csv") + " --json");
    ASSERT_EQ(seen.exit_code, 0) << seen.errors;
    EXPECT_LT(std::abs(Json::parse(seen.output)["deviations"][1]["largest_um"].get<double>()), 1e-3);
}

}  // namespace valves_test
}  // namespace camopt

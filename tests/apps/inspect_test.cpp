// SPDX-License-Identifier: MIT
// camopt inspect: a cam's own table, one out of tolerance, and what is refused.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace camopt {
namespace inspect_test {

using test::ProgramRun;
using test::run_camopt;
using Json = nlohmann::json;

class InspectCommand : public ::testing::Test {
 protected:
    test::TemporaryFolder folder_;

    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    [[nodiscard]] ProgramRun inspect(const std::string& table, const std::string& options) const {
        return run_camopt("inspect " + test::scene("prescribed_tappet") + " " + path(table) + " " + options);
    }
};

TEST_F(InspectCommand, OwnTableIsInTolerance) {
    ASSERT_EQ(
        run_camopt("export " + test::scene("prescribed_tappet") + " --csv --out " + path("cam")).exit_code,
        0);
    const ProgramRun run = inspect("cam/table.csv", "--tolerance-um 0.001 --json --out " + path("out"));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Json found = Json::parse(run.output);
    EXPECT_EQ(found["in_tolerance"], true);
    EXPECT_LT(std::abs(found["deviations"][0]["largest_um"].get<double>()), 1e-6);
    EXPECT_EQ(run.output, read_text_file(path("out/inspection.json")));
    for (const char* const name : {"inspection.csv", "inspection.svg", "inspection.html"})
        EXPECT_TRUE(std::filesystem::exists(path(std::string("out/") + name))) << name;
    const std::string rows = read_text_file(path("out/inspection.csv"));
    EXPECT_TRUE(rows.starts_with("line,theta_deg,measured_mm,nominal_mm,raw_um,aligned_um,"))
        << rows.substr(0, 99);
}

TEST_F(InspectCommand, ResultFolderIsUsedUnchanged) {
    ASSERT_EQ(run_camopt("solve " + test::scene("drd_cubic_12") + " --out " + path("result")).exit_code, 0);
    const std::string words = "inspect " + path("result") + " " + path("result/motion.csv");
    const ProgramRun run = run_camopt(words);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("angle offset deg"), std::string::npos) << run.output;
    EXPECT_EQ(run_camopt(words + " --set motion.lift_mm=8").exit_code, 2);
}

TEST_F(InspectCommand, OutOfToleranceExitsWithOne) {
    std::string table = "theta_deg;s_mm\n";
    for (int i = 0; i < 360; ++i) table += fmt::format("{};{}\n", i, i >= 100 && i < 110 ? "5,02" : "5");
    write_text_file(path("table.csv"), table);
    const ProgramRun run = run_camopt("inspect " + test::scene("prescribed_tappet") + " " +
                                      path("table.csv") + " --tolerance-um 10");
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.output.find("OUT OF TOLERANCE"), std::string::npos) << run.output;
}

TEST_F(InspectCommand, RefusesWithFileAndLine) {
    write_text_file(path("table.csv"), "theta_deg,s_mm\n0,zero\n");
    const ProgramRun run = inspect("table.csv", "");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.errors.find("table.csv:2: found \"zero\" in the column s_mm"), std::string::npos)
        << run.errors;
    EXPECT_EQ(inspect("absent.csv", "").exit_code, 2);
    EXPECT_EQ(inspect("table.csv", "--tolerance-um -1").exit_code, 2);
}

}  // namespace inspect_test
}  // namespace camopt

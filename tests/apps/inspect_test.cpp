// SPDX-License-Identifier: MIT
// camopt inspect: a cam's own table, and the lobe table of a valve, deviate by their digits alone.
#include "program.hpp"
#include "tests/report/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
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
};

TEST_F(InspectCommand, OwnTableIsInTolerance) {
    ASSERT_EQ(
        run_camopt("export " + test::scene("prescribed_tappet") + " --csv --out " + path("cam")).exit_code,
        0);
    const ProgramRun run = run_camopt("inspect " + test::scene("prescribed_tappet") + " " +
                                      path("cam/table.csv") + " --tolerance-um 0.001 --json");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Json found = Json::parse(run.output);
    EXPECT_EQ(found["in_tolerance"], true);
    EXPECT_LT(std::abs(found["deviations"][0]["largest_um"].get<double>()), 1e-6);
}

TEST_F(InspectCommand, LobeTableReadsBack) {
    const std::string result = path("valve_intake");
    ASSERT_EQ(run_camopt("solve " + test::scene("valve_intake") + " --set spline.segments=12 --out " + result)
                  .exit_code,
              0);
    ASSERT_EQ(
        run_camopt("export " + result + " --lobe in --step-deg 2 --digits 8 --out " + path("cam")).exit_code,
        0);
    const ProgramRun seen = run_camopt("inspect " + result + " " + path("cam/lobe.csv") + " --json");
    ASSERT_EQ(seen.exit_code, 0) << seen.errors;
    EXPECT_LT(std::abs(Json::parse(seen.output)["deviations"][1]["largest_um"].get<double>()), 1e-3);
}

}  // namespace inspect_test
}  // namespace camopt

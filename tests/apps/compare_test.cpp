// SPDX-License-Identifier: MIT
// camopt compare from outside: what goes to which stream, what is written, exit codes.
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace camopt {
namespace compare_test {

using nlohmann::json;
using test::ProgramRun;
using test::run_camopt;
using test::scene;

/// The optimum's own numbers stand for the laws' free dimensions, in the objective too.
TEST(CompareCommand, UsesOptimalDimensionsOfAnyCam) {
    const ProgramRun run = run_camopt("compare " + scene("barrel_smallest") +
                                      " --set solver.starts=1 --set spline.segments=16 --json");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const json result = json::parse(run.output);
    const auto row_of = [&](const json& law) {
        return *std::ranges::find_if(result["rows"], [&](const json& one) { return one["law"] == law; });
    };
    const json optimum = row_of(nullptr), sine = row_of("modified_sine");
    // The scene weighs peaks over those of the modified sine, and the barrel's centre distance.
    const auto share = [&](const char* peak) {
        return optimum["peaks"][peak]["value"].get<double>() / sine["peaks"][peak]["value"].get<double>();
    };
    const double peaks = 0.4 * share("velocity") + 0.4 * share("acceleration") + 0.2 * share("jerk");
    EXPECT_EQ(optimum["objective"], result["objective"]);
    EXPECT_NEAR(sine["objective"].get<double>() - 1.0, optimum["objective"].get<double>() - peaks, 1e-9);
    EXPECT_FALSE(sine["feasible"].get<bool>());
}

}  // namespace compare_test
}  // namespace camopt

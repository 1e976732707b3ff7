// SPDX-License-Identifier: MIT
// Solutions of tests.
#pragma once

#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <map>

namespace camopt::testing_support {

/// Solved once in a process, for all cases that ask for it.
[[nodiscard]] inline const Solution& solved(const TestScene& scene) {
    static std::map<TestScene, Solution> solutions;
    const auto found = solutions.find(scene);
    return found != solutions.end() ? found->second : solutions.emplace(scene, solve(scene)).first->second;
}

/// Expects an optimum; throws InputError if there is no motion.
[[nodiscard]] inline Solution optimum_of(const Scene& scene) {
    Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    if (!solution.motion) throw InputError("no motion");
    return solution;
}
[[nodiscard]] inline Solution optimum_of(const std::string& toml) {
    return optimum_of(TestScene(toml));
}

}  // namespace camopt::testing_support

// SPDX-License-Identifier: MIT
// A sweep that a function makes: for studies that no key of a scene file could say. Sweeps by keys, which can
// be cut into chunks and resumed, are studies/sweep/sweep_run.hpp.
#pragma once

#include "solvers/solver.hpp"
#include "studies/delivered/solution.hpp"

#include <functional>
#include <span>
#include <vector>

namespace camopt {

struct SweptScene {
    double value = 0.0;
    Solution solution;
};

/// Puts a value into a scene, which is that of the sweep each time.
using SceneSetter = std::function<void(Scene& scene, double value)>;

/// One solve a value, in order, each from what the one before found: verdicts and objectives are those of
/// solve() to the solver's tolerance, infeasible scenes are not explained. `solved` (may be empty) is called
/// after each. Where control stops it the finished ones come back. Throws what solve() throws, for the first
/// scene that is wrong.
[[nodiscard]] std::vector<SweptScene> sweep(const Scene& scene, std::span<const double> values,
                                            const SceneSetter& set, const SolveControl& control = {},
                                            const std::function<void(const SweptScene&)>& solved = {});

}  // namespace camopt

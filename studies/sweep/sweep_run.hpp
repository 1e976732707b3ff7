// SPDX-License-Identifier: MIT
// Solving the rows of a sweep, chunk by chunk.
//
// The unit of work is a chunk: so many rows in a row, fixed by their numbers alone. Each chunk starts cold
// and solves its rows in order, every one from what the row before found
// (studies/search/known_solutions.hpp). So a row's result depends on the plan and the size of the chunks, and
// on nothing else: not on who solves which chunk, nor when.
#pragma once

#include "studies/sweep/sweep_plan.hpp"

namespace camopt {

/// One row a number, in order; `row_done` (may be empty) is called after each. A row whose solve throws is
/// failed with the message as its reason, and the next starts cold. Where control stops it the finished rows
/// come back.
[[nodiscard]] std::vector<SweepRow> solve_chunk(SweepScenes& scenes, RowRange rows,
                                                const SolveControl& control = {},
                                                const std::function<void(const SweepRow&)>& row_done = {},
                                                const FoundSolution& found = {});

// A sweep that a function makes: for studies that no key of a scene file could say. Sweeps by keys, which can
// be cut into chunks and resumed, are studies/sweep/sweep_plan.hpp.
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

// SPDX-License-Identifier: MIT
#include "benchmarks/linear/final_grid.hpp"

#include "benchmarks/parts/combination.hpp"
#include "core/errors.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/exchange.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>

namespace camopt::benchmarks {

namespace {

constexpr double most_solve_seconds = 120.0;

}  // namespace

Scene drd_scene(int degree, int segments) {
    Combination combination;
    combination.backend = "structured";
    combination.degree = degree;
    combination.segments = segments;
    return scene_of(combination, most_solve_seconds);
}

FinalGrid final_grid(const Scene& scene, double tolerance) {
    FinalGrid grid{CamProblem(scene_model(scene, DesignKind::states, reference_peaks(scene)))};
    ExchangeOptions options;
    options.tolerance = options.backend.tolerance = tolerance;
    options.backend.max_seconds = most_solve_seconds;
    const ExchangeResult result =
        minimize_by_exchange(grid.problem, *make_solver("structured"), grid.problem.start(), options, {});
    if (!result.converged)
        throw ModelError(fmt::format("the exchange over {} segments ended with \"{}\"", scene.spline.segments,
                                     name_of(result.termination)));
    grid.rounds = result.rounds;
    grid.objective = result.latest.objective;
    return grid;
}

CamProblem rewritten(const FinalGrid& grid, const Scene& scene, DesignKind design) {
    return {scene_model(scene, design, reference_peaks(scene)), grid.problem.samples()};
}

}  // namespace camopt::benchmarks

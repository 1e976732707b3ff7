// SPDX-License-Identifier: MIT
#include "studies/sweep_check.hpp"

#include "core/errors.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/registry.hpp"
#include "studies/solve.hpp"

#include <fmt/format.h>

#include <array>

namespace camopt {

namespace {

/// What has been seen in any row.
struct Seen {
    std::array<bool, dimension_count> variable{}, weighed{};
    std::array<bool, sweep_figure_count> figures{};

    void add(const Scene& scene) {
        const ObjectiveSpec& objective = scene.objective;
        const std::array weights = {objective.velocity,         objective.acceleration, objective.jerk, 0.0,
                                    objective.rms_acceleration, objective.rms_jerk};
        static_assert(weights.size() == sweep_figure_count);
        for (std::size_t i = 0; i < weights.size(); ++i) figures[i] = figures[i] || weights[i] > 0.0;
        for (std::size_t i = 0; i < variable.size(); ++i) {
            if (!scene.cam || !scene.cam->dimensions[i].is_variable()) continue;
            variable[i] = true;
            weighed[i] = weighed[i] || objective.dimensions[i] > 0.0;
        }
    }
};

void check_solve(const Scene& scene) {
    (void)reference_peaks(scene);
    if (scene.solver.name == "auto" && scene.solver.options.empty()) return;  // there is always one
    const std::string solver = choose_backend(scene).solver;
    (void)make_solver(solver);
    check_native_options(solver, scene.solver.options);
}

}  // namespace

SweepColumns check_rows(SweepScenes& scenes) {
    const SweepPlan& plan = scenes.plan();
    Seen seen;
    for (int row = 0; row < plan.rows(); ++row) {
        const Scene& scene = scenes.scene(row);
        try {
            check_solve(scene);
        } catch (const UnavailableError& error) {
            throw UnavailableError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        }
        seen.add(scene);
    }
    SweepColumns columns;
    columns.keys = plan.keys;
    for (int i = 0; i < sweep_figure_count; ++i)
        if (seen.figures[static_cast<std::size_t>(i)])
            columns.criteria.emplace_back(name_of(static_cast<SweepFigure>(i)));
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (seen.variable[static_cast<std::size_t>(i)]) columns.dimensions.push_back(index);
        if (seen.weighed[static_cast<std::size_t>(i)]) columns.criteria.emplace_back(name_of(index));
    }
    return columns;
}

}  // namespace camopt

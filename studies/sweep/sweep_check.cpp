// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_check.hpp"

#include "core/errors.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/registry.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <utility>

namespace camopt {

namespace {

/// Laws and the weights that are > 0 with them: whether a law's peaks will do depends on nothing else.
using CheckedLaws = std::set<std::pair<std::string, std::array<bool, sweep_figure_count>>>;

std::array<bool, sweep_figure_count> weighed_figures(const ObjectiveSpec& objective) {
    std::array<bool, sweep_figure_count> weighs{};
    for (const CostTerm& term : cost_terms())
        weighs[static_cast<std::size_t>(term.figure)] = term.weight_in(objective) > 0.0;
    return weighs;
}

void check_solve(const Scene& scene, CheckedLaws& checked) {
    const Reference& reference = scene.objective.reference;
    if (reference.numeric || checked.emplace(reference.law, weighed_figures(scene.objective)).second)
        (void)reference_peaks(scene);
    if (scene.solver.name == "auto" && scene.solver.options.empty()) return;  // there is always one
    const std::string solver = choose_backend(scene).solver;
    (void)make_solver(solver);
    check_native_options(solver, scene.solver.options);
}

/// What has been seen in any row.
struct Seen {
    std::array<bool, dimension_count> variable{}, weighed{};
    std::array<bool, sweep_figure_count> figures{};
    bool train = false;
    std::vector<std::string> responses;  ///< weighed ones, by name

    void add(const Scene& scene) {
        train = train || scene.dynamics.has_value();
        for (const ResponseTerm& term : response_terms())
            if (term.weight_in(scene.objective) > 0.0 &&
                std::ranges::find(responses, term.name) == responses.end())
                responses.emplace_back(term.name);
        const ObjectiveSpec& objective = scene.objective;
        const auto weighs = weighed_figures(objective);
        for (std::size_t i = 0; i < weighs.size(); ++i) figures[i] = figures[i] || weighs[i];
        for (std::size_t i = 0; i < variable.size(); ++i) {
            if (!scene.cam || !scene.cam->dimensions[i].is_variable()) continue;
            variable[i] = true;
            weighed[i] = weighed[i] || objective.dimensions[i] > 0.0;
        }
    }
};

}  // namespace

SweepColumns check_rows(SweepScenes& scenes) {
    const SweepPlan& plan = scenes.plan();
    Seen seen;
    CheckedLaws checked;
    for (int row = 0; row < plan.rows(); ++row) {
        const Scene& scene = scenes.scene(row);
        try {
            check_solve(scene, checked);
        } catch (const UnavailableError& error) {
            throw UnavailableError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        }
        seen.add(scene);
    }
    SweepColumns columns;
    columns.keys = plan.keys;
    if (plan.rows() > 0) columns.length_unit = scenes.scene(0).length_unit;
    for (int i = 0; i < sweep_figure_count; ++i)
        if (seen.figures[static_cast<std::size_t>(i)])
            columns.criteria.emplace_back(name_of(static_cast<SweepFigure>(i)));
    columns.train = seen.train;
    columns.criteria.insert(columns.criteria.end(), seen.responses.begin(), seen.responses.end());
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (seen.variable[static_cast<std::size_t>(i)]) columns.dimensions.push_back(index);
        if (seen.weighed[static_cast<std::size_t>(i)]) columns.criteria.emplace_back(name_of(index));
    }
    return columns;
}

}  // namespace camopt

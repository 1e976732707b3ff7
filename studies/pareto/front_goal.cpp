// SPDX-License-Identifier: MIT
#include "studies/pareto/front_goal.hpp"

#include "core/errors.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/disk/disk_mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace camopt {

namespace {

const FrontFigure* figure_of(const FrontGoal& goal) {
    return std::get_if<FrontFigure>(&goal);
}

/// A front divides a dimension by its range: one that passes zero trades by its magnitude, which is no goal.
bool is_goal(const Dimension& dimension) {
    return dimension.is_variable() && dimension.low >= 0.0;
}

std::vector<FrontGoal> goals_of(const Scene& scene) {
    std::vector<FrontGoal> goals;
    for (const CostTerm& term : cost_terms())
        if (term.traded) goals.emplace_back(term.figure);
    for (int d = 0; scene.cam && d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (is_goal((*scene.cam)[which])) goals.emplace_back(which);
    }
    return goals;
}

const std::optional<PeakLimit>& peak_limit(const Scene& scene, FrontFigure figure) {
    static const std::optional<PeakLimit> none;
    const auto member = cost_term(figure).limit;
    return member != nullptr ? scene.limits.*member : none;
}

}  // namespace

std::string name_of(const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) return name_of(*figure);
    return name_of(std::get<DimensionIndex>(goal));
}

FrontGoal front_goal(std::string_view name, const Scene& scene) {
    std::vector<std::string> names;
    for (const FrontGoal& goal : goals_of(scene)) {
        names.push_back(name_of(goal));
        if (names.back() == name) return goal;
    }
    throw InputError(fmt::format("a front of \"{}\": this scene has {}{}", name, fmt::join(names, ", "),
                                 scene.cam ? " (dimensions need a range { min, max } from 0 upwards)" : ""));
}

bool can_be_capped(const Scene& scene, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return true;
    if (cost_term(*figure).limit == nullptr) return false;
    const std::optional<PeakLimit>& own = peak_limit(scene, *figure);
    // Such a limit holds for the motion, not for the peak normalised by segment; there is room for one only.
    return !(own && own->in_time() && scene.motion.type == MotionType::program);
}

std::optional<double> limit_on(const Scene& scene, const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) {
        const std::optional<PeakLimit>& own = peak_limit(scene, *figure);
        return own && can_be_capped(scene, goal) ? std::optional(own->normalised) : std::nullopt;
    }
    return (*scene.cam)[std::get<DimensionIndex>(goal)].high;
}

void set_cap(Scene& scene, const FrontGoal& goal, double value) {
    if (const FrontFigure* figure = figure_of(goal)) {
        std::optional<PeakLimit>& limit = scene.limits.*cost_term(*figure).limit;
        const double unit = limit ? limit->unit_per_normalised() : 1.0;
        if (!limit) limit = PeakLimit{value, "limits." + name_of(goal), value, ""};
        limit->normalised = value;
        limit->given = value * unit;
        return;
    }
    Dimension& dimension = (*scene.cam)[std::get<DimensionIndex>(goal)];
    dimension.high = std::max(value, dimension.low);
}

double weight_of(const Scene& scene, const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) return scene.objective.*cost_term(*figure).weight;
    return scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))];
}

void set_weight(Scene& scene, const FrontGoal& goal, double weight) {
    if (const FrontFigure* figure = figure_of(goal)) {
        scene.objective.*cost_term(*figure).weight = weight;
        return;
    }
    scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))] = weight;
}

void scale_weights(Scene& scene, double factor) {
    for (const CostTerm& term : cost_terms()) scene.objective.*term.weight *= factor;
    for (const ResponseTerm& term : response_terms()) scene.objective.*term.weight *= factor;
    for (double& weight : scene.objective.dimensions) weight *= factor;
}

double value_of(const Solution& solution, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return disk_cam(solution.cam->cam).value()[std::get<DimensionIndex>(goal)];
    return cost_term(*figure).measured.of(solution.peaks);
}

double reference_of(const Scene& scene, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return dimension_unit(scene);
    return cost_term(*figure).measured.of(reference_peaks(scene));
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/pareto/front_goal.hpp"

#include "core/errors.hpp"
#include "objectives/scene_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace camopt {

namespace {

struct FigureEntry {
    FrontFigure figure;
    const char* name;
    double ObjectiveSpec::*weight;
    std::optional<PeakLimit> LimitSpec::*limit;  ///< null: a root mean square
};

const std::array<FigureEntry, 5>& figure_entries() {
    static const std::array<FigureEntry, 5> entries = {
        {{FrontFigure::velocity, "velocity", &ObjectiveSpec::velocity, &LimitSpec::velocity},
         {FrontFigure::acceleration, "acceleration", &ObjectiveSpec::acceleration, &LimitSpec::acceleration},
         {FrontFigure::jerk, "jerk", &ObjectiveSpec::jerk, &LimitSpec::jerk},
         {FrontFigure::rms_acceleration, "rms_acceleration", &ObjectiveSpec::rms_acceleration, nullptr},
         {FrontFigure::rms_jerk, "rms_jerk", &ObjectiveSpec::rms_jerk, nullptr}}};
    return entries;
}

const FigureEntry& entry_of(FrontFigure figure) {
    return figure_entries()[static_cast<std::size_t>(figure)];
}

const FrontFigure* figure_of(const FrontGoal& goal) {
    return std::get_if<FrontFigure>(&goal);
}

/// A front divides a dimension by its range: one that passes zero trades by its magnitude, which is no goal.
bool is_goal(const Dimension& dimension) {
    return dimension.is_variable() && dimension.low >= 0.0;
}

std::vector<FrontGoal> goals_of(const Scene& scene) {
    std::vector<FrontGoal> goals;
    for (const FigureEntry& entry : figure_entries()) goals.emplace_back(entry.figure);
    for (int d = 0; scene.cam && d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (is_goal((*scene.cam)[which])) goals.emplace_back(which);
    }
    return goals;
}

const std::optional<PeakLimit>& peak_limit(const Scene& scene, FrontFigure figure) {
    static const std::optional<PeakLimit> none;
    const auto member = entry_of(figure).limit;
    return member != nullptr ? scene.limits.*member : none;
}

}  // namespace

std::string name_of(const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) return entry_of(*figure).name;
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
    if (entry_of(*figure).limit == nullptr) return false;
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
        std::optional<PeakLimit>& limit = scene.limits.*entry_of(*figure).limit;
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
    if (const FrontFigure* figure = figure_of(goal)) return scene.objective.*entry_of(*figure).weight;
    return scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))];
}

void set_weight(Scene& scene, const FrontGoal& goal, double weight) {
    if (const FrontFigure* figure = figure_of(goal)) {
        scene.objective.*entry_of(*figure).weight = weight;
        return;
    }
    scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))] = weight;
}

void scale_weights(Scene& scene, double factor) {
    for (const FigureEntry& entry : figure_entries()) scene.objective.*entry.weight *= factor;
    scene.objective.torque *= factor;
    for (double& weight : scene.objective.dimensions) weight *= factor;
}

double value_of(const Solution& solution, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return solution.cam->cam[std::get<DimensionIndex>(goal)];
    switch (*figure) {
        case FrontFigure::velocity:
            return solution.peaks.velocity.value;
        case FrontFigure::acceleration:
            return solution.peaks.acceleration.value;
        case FrontFigure::jerk:
            return solution.peaks.jerk.value;
        case FrontFigure::rms_acceleration:
            return solution.peaks.rms_acceleration;
        case FrontFigure::rms_jerk:
            return solution.peaks.rms_jerk;
    }
    return 0.0;
}

double reference_of(const Scene& scene, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return dimension_unit(scene);
    const Peaks reference = reference_peaks(scene);
    switch (*figure) {
        case FrontFigure::velocity:
            return reference.velocity.value;
        case FrontFigure::acceleration:
            return reference.acceleration.value;
        case FrontFigure::jerk:
            return reference.jerk.value;
        case FrontFigure::rms_acceleration:
            return reference.rms_acceleration;
        case FrontFigure::rms_jerk:
            return reference.rms_jerk;
    }
    return 1.0;
}

}  // namespace camopt

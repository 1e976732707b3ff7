// SPDX-License-Identifier: MIT
#include "objectives/rules/mechanism_rule.hpp"
#include "scene/limit_table.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {
namespace {

using MechanismRules = std::vector<std::shared_ptr<const MechanismRule>>;
using SharedMechanism = std::shared_ptr<const CamVariables>;

// A relative violation of something near zero says nothing: scales stay above this part of the whole.
constexpr double least_scale = 1e-3;

MechanismValue shifted(MechanismValue value, double by) {
    value.value += by;
    return value;
}

MechanismValue product(const MechanismValue& a, const MechanismValue& b) {
    const Eigen::MatrixXd cross = a.gradient * b.gradient.transpose();
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
            a.value * b.hessian + b.value * a.hessian + cross + cross.transpose(),
            a.value * b.by_angle + b.value * a.by_angle};
}

void add_pressure(MechanismRules& rules, const Scene& scene, const SharedMechanism& mechanism, int station) {
    const auto& limit = limit_on(scene.limits, LimitedFigure::pressure_angle);
    if (!limit || !mechanism->cam.formulas->binds(MechanismQuantity::pressure_numerator, station)) return;
    const double length = mechanism->cam.formulas->length(mechanism->cam.dimensions);
    std::vector<int> active;
    for (const CamVariables::Variable& variable : mechanism->variables) active.push_back(variable.dimension);
    for (const int sign : {1, -1}) {
        const auto value = [sign, length, angle = limit->value](const MechanismCall& call) {
            const MechanismValue excess = call.pressure_excess(angle, sign);
            return combined(1.0 / length, excess, 0.0, excess);
        };
        MechanismFormula formula{{limit->key, {}, sign, 1, limit->value},
                                 station,
                                 MechanismQuantity::pressure_numerator,
                                 value,
                                 mechanism->cam.formulas->pressure_shape(active)};
        formula.over = [sign, station, angle = limit->value](const CamMechanism& formulas,
                                                             const MechanismStateOver& state) {
            return formulas.pressure_over(angle, sign, state, station);
        };
        formula.along = [sign, station, length, angle = limit->value](
                            const CamMechanism& formulas,
                            const MechanismStateAlong& state) -> std::optional<RangeAlong> {
            const auto excess = formulas.pressure_along(angle, sign, state, station);
            if (!excess) return {};
            return (1.0 / length) * *excess;
        };
        rules.push_back(std::make_shared<MechanismRule>(mechanism, std::move(formula)));
    }
}

/// (r + shift) κ − 1: the convex radius stays above shift, the concave one above −shift.
void add_radius(MechanismRules& rules, const SharedMechanism& mechanism, const MechanismFormula& frame,
                double shift) {
    MechanismFormula formula = frame;
    formula.value = [shift](const MechanismCall& call) {
        return shifted(product(shifted(call.dimension(call.formulas.roller_radius()), shift),
                               call(MechanismQuantity::pitch_curvature)),
                       -1.0);
    };
    formula.over = [shift, station = frame.station](const CamMechanism& formulas,
                                                    const MechanismStateOver& state) {
        return formulas.radius_over(shift, state, station);
    };
    formula.along = [shift, station = frame.station](
                        const CamMechanism& formulas,
                        const MechanismStateAlong& state) -> std::optional<RangeAlong> {
        const auto curvature = formulas.quantity_along(MechanismQuantity::pitch_curvature, state, station);
        if (!curvature) return {};
        const double radius = state.dimensions[static_cast<std::size_t>(formulas.roller_radius())];
        return (radius + shift) * *curvature - 1.0;
    };
    rules.push_back(std::make_shared<MechanismRule>(mechanism, std::move(formula)));
}

void add_radii(MechanismRules& rules, const Scene& scene, const SharedMechanism& mechanism, int station) {
    const int index = mechanism->cam.formulas->roller_radius();
    const double roller = mechanism->cam.dimensions[static_cast<std::size_t>(index)];
    const bool moves = std::ranges::any_of(mechanism->variables,
                                           [&](const auto& variable) { return variable.dimension == index; });
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::convex_radius)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (roller + least)) : 1.0;
        add_radius(rules, mechanism,
                   {{limit->key, {}, 0, 2, scale}, station, MechanismQuantity::pitch_curvature}, least);
    }
    // The roller itself fits into any hollow larger than it.
    const auto& concave = limit_on(scene.limits, LimitedFigure::concave_radius);
    if (!concave || !(moves || concave->value > roller)) return;
    const double least = concave->value;
    const double scale = std::clamp(least / std::max(least - roller, least_scale * least), 1.0, 1e3);
    add_radius(rules, mechanism, {{concave->key, {}, 0, 2, scale}, station}, -least);
}

void add_margin(MechanismRules& rules, const Scene& scene, const SharedMechanism& mechanism, int station) {
    const auto& limit = limit_on(scene.limits, LimitedFigure::regularity);
    if (!limit || !mechanism->cam.formulas->binds(MechanismQuantity::regularity, station)) return;
    const auto value = [margin = limit->value](const MechanismCall& call) {
        const MechanismValue regularity = call(MechanismQuantity::regularity);
        return shifted(combined(-1.0, regularity, 0.0, regularity), margin);
    };
    MechanismFormula formula{{limit->key}, station, MechanismQuantity::regularity, value};
    formula.over = [station, margin = limit->value](const CamMechanism& formulas,
                                                    const MechanismStateOver& state) {
        return formulas.regularity_over(margin, state, station);
    };
    formula.along = [station, margin = limit->value](
                        const CamMechanism& formulas,
                        const MechanismStateAlong& state) -> std::optional<RangeAlong> {
        const auto regularity = formulas.quantity_along(MechanismQuantity::regularity, state, station);
        if (!regularity) return {};
        return RangeAlong(margin) - *regularity;
    };
    rules.push_back(std::make_shared<MechanismRule>(mechanism, std::move(formula)));
}

}  // namespace

MechanismRules mechanism_limits(const Scene& scene, const SharedMechanism& mechanism) {
    MechanismRules rules;
    for (int station = 0; station < mechanism->cam.formulas->stations(); ++station) {
        add_pressure(rules, scene, mechanism, station);
        if (mechanism->cam.formulas->planar()) add_radii(rules, scene, mechanism, station);
        add_margin(rules, scene, mechanism, station);
    }
    return rules;
}

}  // namespace camopt

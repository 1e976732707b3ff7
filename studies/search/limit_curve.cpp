// SPDX-License-Identifier: MIT
#include "studies/search/limit_curve.hpp"

#include "motions/bounds/any_curve_limit.hpp"
#include "scene/cost_table.hpp"

#include <algorithm>

namespace camopt {

std::optional<LimitCurve> limit_curve(const Scene& scene, const Peaks& reference) {
    const ObjectiveSpec& objective = scene.objective;
    // The limit knows the peaks of one rise (and return) only; a term beside them would make it a bound that
    // nothing approaches.
    if (scene.motion.type == MotionType::program) return {};
    for (const CostTerm& term : cost_terms())
        if (term.kind != CostTerm::Kind::peak && term.weight_in(objective) > 0.0) return {};
    if (!scene.own_terms.empty() || weighs_response(objective)) return {};
    if (std::ranges::any_of(objective.dimensions, [](double weight) { return weight > 0.0; })) return {};
    const auto over = [](double weight, double peak) { return weight > 0.0 ? weight / peak : 0.0; };
    const auto cap = [](const std::optional<PeakLimit>& limit) {
        return limit ? std::optional(limit->normalised) : std::nullopt;
    };
    const AnyCurveLimit limit = any_curve_limit(
        {scene.motion.type, scene.motion.length(), over(objective.velocity, reference.velocity.value),
         over(objective.acceleration, reference.acceleration.value),
         over(objective.jerk, reference.jerk.value), cap(scene.limits.velocity),
         cap(scene.limits.acceleration), cap(scene.limits.jerk)});
    if (limit.status == AnyCurveStatus::infeasible || limit.status == AnyCurveStatus::not_converged)
        return {};
    return LimitCurve{limit.objective, limit.velocity, limit.acceleration, limit.jerk};
}

}  // namespace camopt

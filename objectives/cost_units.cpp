// SPDX-License-Identifier: MIT
#include "objectives/cost_units.hpp"

#include "scene/cost_table.hpp"

namespace camopt {

namespace {

// References this far from those of good motions, and objectives this far from one, get other units.
constexpr int near_exponent = 7;
constexpr double least_near_cost = 0.25, most_near_cost = 64.0;
// Costs in their unit lie below 1 where they were small (the gap is then no looser) and above it where they
// were large.
constexpr double large_cost = 8.0;

double power_of_two(double exponent) {
    return std::ldexp(1.0, static_cast<int>(exponent));
}

/// V, A and J of a stroke of length 1, and what remains of it beside its cruise.
struct StrokePeaks {
    double velocity = 2.0, acceleration = 8.0, jerk = 32.0, ramps = 0.5;
};

/// From rest to rest: its length in x and displacement in lifts, the units of its caps.
struct RestStroke {
    double length = 1.0, displacement = 1.0;
    bool of_program = false;  ///< then peaks, and caps that are not in time, are normalised by the stroke

    [[nodiscard]] double cap(const std::optional<PeakLimit>& limit, int order) const {
        if (!limit) return infinity;
        if (of_program && !limit->physical()) return limit->normalised;
        return limit->normalised * std::pow(length, order) / displacement;
    }
};

/// Those between given displacements.
std::vector<RestStroke> rest_strokes(const MotionSpec& motion) {
    if (motion.start || motion.end) return {};
    if (motion.type == MotionType::drd) return {RestStroke{}};
    if (motion.type == MotionType::rr) return {RestStroke{std::min(1.0, motion.length() - 1.0)}};
    std::vector<RestStroke> strokes;
    const std::vector<ProgramSegment>& segments = motion.segments;
    const auto rests = [&](std::size_t index) { return segments[index].kind == SegmentKind::dwell; };
    std::optional<double> at = 0.0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (rests(i)) continue;
        const std::optional<double> to = segments[i].to;
        const bool from_rest = i > 0 ? rests(i - 1) : !motion.periodic() || rests(segments.size() - 1);
        const bool to_rest = i + 1 < segments.size() ? rests(i + 1) : !motion.periodic() || rests(0);
        if (from_rest && to_rest && at && to && *at != *to)
            strokes.push_back({segments[i].angle / motion.unit_angle(), std::abs(*to - *at), true});
        at = to;
    }
    return strokes;
}

/// The least jerk within the caps, and its peaks, to a factor of a few: at the velocity V a cruise leaves
/// 1 − 1/V to the ramps, V/A + A/J = 1 − 1/V, and A = 2V / (1 − 1/V) takes the least J. Without caps, or
/// where they contradict, V = 2.
StrokePeaks forced_peaks(const LimitSpec& limits, const RestStroke& stroke) {
    constexpr double least_ramps = 1e-9;  // shorter ones are rounding of a contradiction
    const double most_acceleration = stroke.cap(limits.acceleration, 2);
    StrokePeaks forced;
    forced.velocity =
        std::min({forced.velocity, stroke.cap(limits.velocity, 1), std::sqrt(most_acceleration)});
    forced.ramps = 1.0 - 1.0 / forced.velocity;
    forced.acceleration = std::min(2.0 * forced.velocity / forced.ramps, most_acceleration);
    const double turning = forced.ramps - forced.velocity / forced.acceleration;
    if (!(forced.ramps > least_ramps && turning > least_ramps * forced.ramps)) return {};
    forced.jerk = std::min(forced.acceleration / turning, stroke.cap(limits.jerk, 3));
    return forced;
}

/// The figures of a good motion, to a factor of ten, by CostFigure: typical ones, or those that caps force on
/// a stroke.
std::vector<double> expected_figures(const Scene& scene) {
    constexpr double far = 16.0;  // times the typical figure
    std::vector<double> figures;
    for (const CostTerm& term : cost_terms()) figures.push_back(term.typical);
    for (const RestStroke& stroke : rest_strokes(scene.motion)) {
        const StrokePeaks forced = forced_peaks(scene.limits, stroke);
        for (std::size_t i = 0; i < figures.size(); ++i) {
            const CostTerm& term = cost_terms()[i];
            const bool torque = term.kind == CostTerm::Kind::torque;
            const int order = torque ? 3 : term.measured.order;
            double own = order == 1 ? forced.velocity : order == 2 ? forced.acceleration : forced.jerk;
            if (torque) own = forced.velocity * forced.acceleration;
            if (term.kind == CostTerm::Kind::rms) own *= std::sqrt(forced.ramps);
            if (own <= far * term.typical) continue;
            figures[i] = std::max(figures[i], stroke.of_program ? own : own / std::pow(stroke.length, order));
        }
    }
    return figures;
}

/// The objective of a motion with these figures.
double expected_cost(const Scene& scene, const std::vector<double>& figures, const Peaks& reference) {
    double cost = 0.0;
    for (std::size_t i = 0; i < figures.size(); ++i)
        if (const double weight = cost_terms()[i].weight_in(scene.objective); weight > 0.0)
            cost += weight * figures[i] / cost_terms()[i].measured.of(reference);
    for (const ResponseTerm& term : response_terms()) cost += term.weight_in(scene.objective);
    for (const double weight : scene.objective.dimensions) cost += weight;
    for (const OwnTerm& term : scene.own_terms) cost += term.weight;
    return cost;
}

/// 1 where a cost is near one, or nothing is weighed.
double unit_of(double cost) {
    if (cost == 0.0 || (cost >= least_near_cost && cost <= most_near_cost)) return 1.0;
    return power_of_two(cost < 1.0 ? std::ceil(std::log2(cost)) : std::floor(std::log2(cost / large_cost)));
}

}  // namespace

CostUnits cost_units(const Scene& scene, const Peaks& reference) {
    const std::vector<double> figures = expected_figures(scene);
    CostUnits units;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const CostTerm& term = cost_terms()[i];
        if (term.limit == nullptr && !(term.weight_in(scene.objective) > 0.0)) continue;
        const double own = term.measured.of(reference);
        const double known = std::isfinite(own) && own > 0.0 ? own : term.typical;
        const double exponent = std::round(std::log2(known / figures[i]));
        if (std::abs(exponent) <= near_exponent) continue;
        units.peaks.resize(figures.size(), 1.0);
        units.peaks[i] = power_of_two(-exponent);
    }
    units.cost = unit_of(expected_cost(scene, figures, reference));
    return units;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/least/feasible_edge.hpp"

namespace camopt {

namespace {

constexpr int most_doublings = 24, most_search_steps = 60;
// How far beyond the expected zero a value is tried, so that it replaces the end of the bracket that lies
// further off: of the accuracy, and of the way to the zero. How far from both ends of the bracket at least:
// of the accuracy, and of the width at most.
constexpr double beyond_zero = 0.3, part_beyond_zero = 0.02, from_ends = 0.1, most_from_ends = 0.05;
// After so many steps that shorten the bracket by less than half the middle is tried; after so many in all
// every second time: what is expected is wrong there.
constexpr int patient_steps = 3, expecting_steps = 15;
// A value is found to this part of itself, or of the first step from it.
constexpr double value_accuracy = 1e-8;

// Digits of a value that is told, and how far from the edge it lies at least, both of its size: a solve that
// ends within its tolerance of the edge would prove nothing.
constexpr int told_digits = 5;
constexpr double least_margin = 1e-6;
constexpr int most_decimals = 17;

/// The zero of the line through two trials; NaN: there is none.
double zero_of_line(const ValueTrial& one, const ValueTrial& other) {
    return one.value + (other.value - one.value) * one.violation / (one.violation - other.violation);
}

/// t of it steers the search. A slack of 0 does not: it stands for every slack, since a search that meets a
/// feasible motion has no reason to go on.
bool steers(const ValueTrial& trial) {
    return std::isfinite(trial.violation) && trial.violation != 0.0;
}

/// The trials so far, as far as they steer: the last two of them, the newer one first.
struct LastTrials {
    std::optional<ValueTrial> newer = {}, older = {};
    void add(const ValueTrial& trial) {
        if (!steers(trial)) return;
        older = newer;
        newer = trial;
    }
};

/// The expected zero of t within the bracket: by the last two trials, by its ends, by the slope; none where
/// nothing is known.
std::optional<double> expected_zero(const ValueBracket& now, const LastTrials& last, double slope) {
    if (!steers(now.outside)) return {};
    const auto is_within = [&](double zero) {
        return (zero - now.inside.value) * (zero - now.outside.value) <= 0.0;
    };
    if (last.older)
        if (const double zero = zero_of_line(*last.newer, *last.older); is_within(zero)) return zero;
    if (steers(now.inside)) return zero_of_line(now.outside, now.inside);
    const double inwards = now.inside.value > now.outside.value ? 1.0 : -1.0;
    const double zero = now.outside.value + inwards * now.outside.violation / slope;
    return !last.older && slope > 0.0 && is_within(zero) ? std::optional(zero) : std::nullopt;
}

ValueSearch search_of(const Scene& scene, const Adjustment& adjustment, const Budget& budget,
                      double (*violation)(const Scene& scene, const Budget& budget)) {
    return {[&scene, &adjustment, &budget, violation](double value) {
                return violation(adjustment.with(scene, value), budget);
            },
            [&budget] { return budget.spent(); }};
}

double accuracy_at(const Adjustment& adjustment, double value) {
    return value_accuracy * std::max(std::abs(value), adjustment.step);
}

}  // namespace

ValueMarch marched(const ValueSearch& search, const ValueTrial& from, double step, double end) {
    ValueMarch march{from};
    for (int k = 0; k < most_doublings && !search.is_over(); ++k, step *= 2.0) {
        double value = from.value + step;
        const bool last = (value - end) * step >= 0.0;
        if (last) value = end;
        const ValueTrial next = search.at(value);
        if (next.feasible() != from.feasible()) {
            march.changed = next;
            return march;
        }
        march.last = next;
        march.at_end = last;
        if (last) break;
    }
    return march;
}

ValueBracket closed_in(const ValueSearch& search, ValueBracket bracket, double accuracy) {
    LastTrials last;
    last.add(bracket.inside);
    last.add(bracket.outside);
    bool outside_is_new = true;
    int slow = 0;  // steps in succession that shortened the bracket little
    for (int k = 0; k < most_search_steps && bracket.width() > accuracy && !search.is_over(); ++k) {
        const double inside = bracket.inside.value, outside = bracket.outside.value, width = bracket.width();
        double value = 0.5 * (inside + outside);
        const bool expects = slow < patient_steps && (k < expecting_steps || k % 2 == 0);
        if (const auto zero = expected_zero(bracket, last, search.slope); zero && expects) {
            const double way = std::min(std::abs(*zero - last.newer->value), width);
            const double further = std::max(beyond_zero * accuracy, part_beyond_zero * way);
            value = *zero + ((inside > outside) == outside_is_new ? further : -further);
        }
        const double margin = std::min(from_ends * accuracy, most_from_ends * width);
        value = std::clamp(value, std::min(inside, outside) + margin, std::max(inside, outside) - margin);
        if (search.rounded) value = search.rounded(value);
        if (value == inside || value == outside) break;
        const ValueTrial next = search.at(value);
        last.add(next);
        outside_is_new = !next.feasible();
        (outside_is_new ? bracket.outside : bracket.inside) = next;
        slow = bracket.width() > 0.5 * width && slow < patient_steps ? slow + 1 : 0;
    }
    return bracket;
}

double rounded_away(double value, int decimals, bool up) {
    // Dividing by a power of ten gives the double nearest to the decimal number.
    const double power = std::pow(10.0, std::abs(decimals));
    const double scaled = decimals >= 0 ? value * power : value / power;
    const double steps = up ? std::ceil(scaled) : std::floor(scaled);
    return decimals >= 0 ? steps / power : steps * power;
}

double safe_value(double needed, bool up, double size) {
    size = std::max(size, std::abs(needed));
    if (!(size > 0.0) || !std::isfinite(size)) return needed;
    const int decimals = told_digits - 1 - static_cast<int>(std::floor(std::log10(size)));
    return rounded_away(needed + (up ? least_margin : -least_margin) * size, decimals, up);
}

double shortest_decimal(double near, double far) {
    const double size = std::max(std::abs(near), std::abs(far));
    if (!(size > 0.0) || !std::isfinite(size)) return near;
    int decimals = -static_cast<int>(std::floor(std::log10(size)));
    for (int k = 0; k < most_decimals; ++k, ++decimals) {
        const double value = rounded_away(near, decimals, far > near);
        if (far > near ? value <= far : value >= far) return value;
    }
    return near;
}

std::optional<double> nearest_value(const Scene& scene, const Adjustment& adjustment, double given,
                                    const Budget& budget) {
    const ValueSearch search = search_of(scene, adjustment, budget, least_violation);
    std::optional<double> nearest;
    for (const int direction : {1, -1}) {
        if (!(direction > 0 ? adjustment.may_grow : adjustment.may_shrink)) continue;
        const ValueMarch march = marched(search, {adjustment.given, given}, direction * adjustment.step,
                                         direction > 0 ? adjustment.most : adjustment.least);
        if (!march.changed) continue;
        const double found =
            closed_in(search, {*march.changed, march.last}, accuracy_at(adjustment, march.changed->value))
                .inside.value;
        if (!nearest || std::abs(found - adjustment.given) < std::abs(*nearest - adjustment.given))
            nearest = found;
    }
    return nearest;
}

FeasibleEdge feasible_edge(const Scene& scene, const Adjustment& adjustment, double feasible, int direction,
                           double end, const Budget& budget) {
    const ValueSearch search = search_of(scene, adjustment, budget, violation_of_any);
    // The caller knows that it is feasible: rounding may not say so.
    ValueTrial from = search.at(feasible);
    from.violation = std::min(from.violation, 0.0);
    const ValueMarch march = marched(search, from, direction * adjustment.step, end);
    if (!march.changed) return {march.last.value, std::nullopt, march.at_end};
    const ValueBracket edge =
        closed_in(search, {march.last, *march.changed}, accuracy_at(adjustment, march.last.value));
    return {edge.inside.value, edge.outside.value};
}

double value_towards(const Scene& scene, const Adjustment& adjustment, double feasible,
                     const Budget& budget) {
    const ValueSearch search = search_of(scene, adjustment, budget, least_violation);
    return closed_in(search, {{feasible, 0.0}, {adjustment.given, infinity}},
                     accuracy_at(adjustment, feasible))
        .inside.value;
}

}  // namespace camopt

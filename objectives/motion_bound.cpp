// SPDX-License-Identifier: MIT
#include "objectives/motion_bound.hpp"

#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt {

namespace {

// Of y, y', y'', y''' of a good motion over one lift: what a bound near 0 is measured by.
constexpr std::array typical = {1.0, 2.0, 6.0, 60.0};

}  // namespace

double MotionBound::scale() const {
    if (of_motor()) return size > 0.0 ? size : std::max(std::abs(bound), 1.0);
    const double own = stretch >= 0 ? 1.0 / per_normalised : 1.0;  // of a segment
    return std::max(std::abs(bound), own * typical[order]);
}

Extremum MotionBound::extreme_of(const Motion& motion) const {
    const BoundRule limit(key, rule(0.0, 1.0));
    const double first = std::max(from, motion.begin()), last = std::min(until, motion.end());
    const auto value = [&](double x, Side side) { return limit.evaluate(motion.at(x, side), {}).value; };
    Extremum worst{value(first, Side::right), first, Side::right};
    const auto look = [&](const Extremum& one) {
        if (one.value > worst.value) worst = one;
    };
    look({value(last, Side::left), last, Side::left});
    for (const Extremum& one : rule_maxima(limit, motion, {})) {
        const bool inside = one.at > first && one.at < last;
        if (inside || (one.at == first && one.side == Side::right && first < last)) look(one);
    }
    return worst;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "profiles/inverse/roller_law.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace camopt {

namespace {

// Relative: tolerance for strokes given to six digits.
constexpr double law_meeting_tolerance = 1e-6;

}  // namespace

RollerState state_of(const RollerStroke& stroke, double time) {
    const double since = time - stroke.reference;
    return {stroke.position + since * (stroke.velocity + 0.5 * stroke.acceleration * since),
            stroke.velocity + stroke.acceleration * since, stroke.acceleration};
}

double time_at(const RollerStroke& stroke, double distance) {
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    const double a = 0.5 * stroke.acceleration, b = stroke.velocity, c = stroke.position - distance;
    const double slack = 1e-9 * (stroke.end - stroke.begin);
    const auto inside = [&](double since) {
        const double time = stroke.reference + since;
        return time >= stroke.begin - slack && time <= stroke.end + slack;
    };
    const double root = std::sqrt(b * b - 4.0 * a * c);  // NaN: never
    const double sum = -0.5 * (b + std::copysign(root, b));
    double found = nowhere;
    for (const double since : {a != 0.0 ? sum / a : nowhere, sum != 0.0 ? c / sum : nowhere})
        if (inside(since)) found = stroke.reference + since;
    return std::clamp(found, stroke.begin, stroke.end);
}

RollerLaw::RollerLaw(std::vector<RollerStroke> strokes) : strokes_(std::move(strokes)) {
    if (strokes_.empty()) throw InputError("the roller has no stroke; it needs at least one");
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
        const RollerStroke& stroke = strokes_[i];
        if (!(stroke.end > stroke.begin))
            throw InputError(
                fmt::format("stroke {} of the roller lasts from {} to {} s; it must end after it begins",
                            i + 1, stroke.begin, stroke.end));
        if (i == 0) continue;
        const RollerStroke& before = strokes_[i - 1];
        const double from = state_of(before, before.end).distance,
                     to = state_of(stroke, stroke.begin).distance;
        if (before.end != stroke.begin || !(std::abs(to - from) <= law_meeting_tolerance * std::abs(from)))
            throw InputError(
                fmt::format("stroke {} of the roller ends at {} s, {} m and stroke {} begins at {} s, {} m; "
                            "they must meet",
                            i, before.end, from, i + 1, stroke.begin, to));
    }
}

RollerState RollerLaw::at(double time, Side side) const {
    if (!(time >= begin() && time <= end()))
        throw InputError(fmt::format("the roller's motion lasts from {} to {} s; {} s was requested", begin(),
                                     end(), time));
    std::size_t index = 0;
    while (index + 1 < strokes_.size() &&
           (side == Side::right ? time >= strokes_[index].end : time > strokes_[index].end))
        ++index;
    return state_of(strokes_[index], time);
}

}  // namespace camopt

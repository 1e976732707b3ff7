// SPDX-License-Identifier: MIT
#include "benchmarks/papers/guided_feeder.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Relative: tolerance for strokes given to six digits.
constexpr double law_meeting_tolerance = 1e-6;

}  // namespace

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

BodyMotion body_on_guide(const Guide& guide, const RollerState& roller, Side guide_side) {
    const GuidePoint point = guide.at(roller.distance, guide_side);
    return {-point.angle, -point.slope * roller.velocity,
            -(point.bend * roller.velocity * roller.velocity + point.slope * roller.acceleration)};
}

InverseState inverse_state(const Guide& guide, const FeederLinkage& linkage, const RollerState& roller,
                           Side guide_side) {
    InverseState state;
    state.roller = roller;
    const Reach reach = guide.reach(roller.distance);
    if (reach != Reach::within) {
        state.fault = reach == Reach::before_guide ? InverseFault::roller_before_guide
                                                   : InverseFault::roller_beyond_guide;
        return state;
    }
    const GuidePoint point = guide.at(roller.distance, guide_side);
    state.pressure_angle = point.pressure_angle;
    state.curvature = point.curvature;
    state.body = body_on_guide(guide, roller, guide_side);
    state.feeder = feeder_motion(linkage, state.body);
    state.fault = state.feeder.fault;
    return state;
}

}  // namespace camopt

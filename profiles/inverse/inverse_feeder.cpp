// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_feeder.hpp"

#include <cmath>

namespace camopt {

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

GuideNode wanted_guide(const FeederLinkage& linkage, const RollerState& roller, const FollowerState& feeder) {
    const BodyResult back = body_motion(linkage, feeder);
    GuideNode result;
    result.fault = back.fault;
    if (result.fault == InverseFault::none && !(std::abs(roller.velocity) > 0.0))
        result.fault = InverseFault::roller_at_rest;
    if (result.fault != InverseFault::none) return result;
    const double slope = -back.body.velocity / roller.velocity;
    result.node = {
        roller.distance, -back.body.angle, slope,
        -(back.body.acceleration + slope * roller.acceleration) / (roller.velocity * roller.velocity)};
    return result;
}

}  // namespace camopt

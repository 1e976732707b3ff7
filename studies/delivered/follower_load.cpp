// SPDX-License-Identifier: MIT
#include "studies/delivered/follower_load.hpp"

#include <cmath>
#include <numbers>

namespace camopt {

double FollowerLoads::normal_force(const FollowerState& state) const {
    return force(state) / quantity(cam_, state, Quantity::normal_lever).value;
}

bool FollowerLoads::has_pressure() const {
    return forces_.contact_width.has_value() && !has_edge(cam_.follower);
}

double FollowerLoads::hertz_pressure(const FollowerState& state, const MechanismPoint& point) const {
    const double curvature = has_roller(cam_.follower)
                                 ? 1.0 / (cam_[DimensionIndex::roller_radius] * point.regularity)
                                 : 1.0 / point.cam_radius;
    const double squared =
        normal_force(state) * curvature / (forces_.compliance() * std::numbers::pi * *forces_.contact_width);
    return squared > 0.0 ? std::sqrt(squared) : 0.0;
}

FollowerLoad FollowerLoads::at(const FollowerState& state, const MechanismPoint& point) const {
    FollowerLoad load{force(state), torque(state), normal_force(state), {}};
    if (has_pressure()) load.hertz_pressure = hertz_pressure(state, point);
    return load;
}

}  // namespace camopt

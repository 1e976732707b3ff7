// SPDX-License-Identifier: MIT
#include "studies/delivered/follower_loads.hpp"

#include <cmath>
#include <numbers>

namespace camopt {

double normal_force(const DiskCam& cam, const FollowerState& state, double force) {
    return force / quantity(cam, state, Quantity::normal_lever).value;
}

double hertz_pressure(const DiskCam& cam, const ForceSpec& forces, const MechanismPoint& point,
                      double normal_force) {
    const double curvature = has_roller(cam.follower)
                                 ? 1.0 / (cam[DimensionIndex::roller_radius] * point.regularity)
                                 : 1.0 / point.cam_radius;
    const double squared =
        normal_force * curvature / (forces.compliance() * std::numbers::pi * forces.contact_width.value());
    return squared > 0.0 ? std::sqrt(squared) : 0.0;
}

bool has_hertz_pressure(const DiskCam& cam, const ForceSpec& forces) {
    return forces.contact_width && !has_edge(cam.follower);
}

FollowerLoads follower_loads(const DiskCam& cam, const ForceSpec& forces, double speed,
                             const FollowerState& state, const MechanismPoint& point) {
    FollowerLoads loads;
    loads.force = forces.force(speed, state.s, state.acceleration);
    loads.torque = loads.force * state.velocity;
    loads.normal_force = normal_force(cam, state, loads.force);
    if (has_hertz_pressure(cam, forces))
        loads.hertz_pressure = hertz_pressure(cam, forces, point, loads.normal_force);
    return loads;
}

}  // namespace camopt

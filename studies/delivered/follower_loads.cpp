// SPDX-License-Identifier: MIT
#include "studies/delivered/follower_loads.hpp"

#include "core/numbers/extremum.hpp"
#include "profiles/sampling.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/solution.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace camopt {

double normal_force(const DrivenMechanism& cam, const FollowerState& state, double force, int side) {
    const double lever =
        cam.formulas->quantity(MechanismQuantity::normal_lever, {cam.dimensions, state}, side, {}).value;
    return pressing_sense(side) * force / lever;
}

int carrying_side(const CamMechanism& cam, double force) {
    return cam.drives_both_ways() && force < 0.0 ? 1 : 0;
}

namespace {

/// 1/ρ_cam + 1/r of a roller, which may be a little smaller than what the surface is offset by.
double roller_contact_curvature(const DrivenMechanism& cam, const MechanismPoint& point, int side) {
    const int index = cam.formulas->roller_radius_at(side);
    const double roller = cam.dimensions[static_cast<std::size_t>(index)],
                 wider = cam.formulas->surface_offset(cam.dimensions, side) - roller;
    return (1.0 - wider * point.pitch_curvature) / (roller * point.regularity);
}

}  // namespace

double hertz_pressure(const DrivenMechanism& cam, const ForceSpec& forces, const MechanismPoint& point,
                      double normal_force, int side) {
    const bool rolls = cam.formulas->contact() == ContactKind::roller;
    const double curvature = rolls ? roller_contact_curvature(cam, point, side) : 1.0 / point.cam_radius;
    const double squared =
        normal_force * curvature / (forces.compliance() * std::numbers::pi * forces.contact_width.value());
    return squared > 0.0 ? std::sqrt(squared) : 0.0;
}

bool has_hertz_pressure(const CamMechanism& cam, const ForceSpec& forces) {
    return forces.contact_width && cam.contact() != ContactKind::edge;
}

FollowerLoads follower_loads(const DrivenMechanism& cam, const ForceSpec& forces, double force,
                             const FollowerState& state,
                             const std::function<MechanismPoint(int side)>& point_of) {
    FollowerLoads loads;
    loads.force = force;
    loads.torque = loads.force * state.velocity;
    loads.side = carrying_side(*cam.formulas, loads.force);
    loads.normal_force = normal_force(cam, state, loads.force, loads.side);
    if (!has_hertz_pressure(*cam.formulas, forces)) return loads;
    loads.hertz_pressure = hertz_pressure(cam, forces, point_of(loads.side), loads.normal_force, loads.side);
    return loads;
}

LoadsAt delivered_loads(const Solution& solution) {
    if (!solution.cam || !solution.cam->summary.forces) return {};
    if (!solution.cam->cam.formulas->is_direct()) return {};
    const MotionScale scale = motion_scale(solution.scene);
    const double speed = solution.scene.motion.speed.value();
    return [&solution, scale, speed](const MotionPoint& motion, const CamPoints& cam) {
        const FollowerState state = state_of(motion, scale);
        const ForceSpec& forces = *solution.scene.forces;
        FollowerLoads loads =
            follower_loads(solution.cam->cam, forces, forces.force(speed, state, scale.unit_angle * motion.x),
                           state, [&](int side) { return cam.at(motion, side); });
        if (!solution.cam->summary.no_contact) return loads;
        loads.normal_force = infinity;
        loads.hertz_pressure.reset();
        return loads;
    };
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/delivered/cam/follower_loads.hpp"

#include "core/infinity.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "profiles/sampling.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/solution.hpp"

#include <cmath>
#include <numbers>

namespace camopt {

double normal_force(const DiskCam& cam, const FollowerState& state, double force) {
    return force / quantity(cam, state, MechanismQuantity::normal_lever).value;
}

double normal_force(const DiskCam& cam, const FollowerState& state, double force, int side) {
    return pressing_sense(side) * force / quantity(cam, state, MechanismQuantity::normal_lever, side).value;
}

int carrying_side(const DiskCam& cam, double force) {
    return side_count(cam) > 1 && force < 0.0 ? 1 : 0;
}

namespace {

/// 1/ρ_cam + 1/r of a roller, which may be a little smaller than what the surface is offset by.
double roller_contact_curvature(const DiskCam& cam, const MechanismPoint& point, int side) {
    const double roller = roller_radius_of(cam, side), wider = surface_offset(cam, side) - roller;
    return (1.0 - wider * point.pitch_curvature) / (roller * point.regularity);
}

}  // namespace

double hertz_pressure(const DiskCam& cam, const ForceSpec& forces, const MechanismPoint& point,
                      double normal_force, int side) {
    const double curvature =
        has_roller(cam.follower) ? roller_contact_curvature(cam, point, side) : 1.0 / point.cam_radius;
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
    loads.side = carrying_side(cam, loads.force);
    loads.normal_force = normal_force(cam, state, loads.force, loads.side);
    if (!has_hertz_pressure(cam, forces)) return loads;
    const MechanismPoint touched =
        loads.side == 0 ? point : mechanism_point(profile_point(cam, point.theta, state, loads.side));
    loads.hertz_pressure = hertz_pressure(cam, forces, touched, loads.normal_force, loads.side);
    return loads;
}

LoadsAt delivered_loads(const Solution& solution) {
    if (!solution.cam || !solution.cam->summary.forces) return {};
    const std::optional<DiskCam> cam = disk_cam(solution.cam->cam);
    if (!cam) return {};
    const MotionScale scale = motion_scale(solution.scene);
    const double speed = solution.scene.motion.speed.value();
    return [&solution, cam = *cam, scale, speed](const MotionPoint& motion, const MechanismPoint& point) {
        FollowerLoads loads =
            follower_loads(cam, *solution.scene.forces, speed, state_of(motion, scale), point);
        if (!solution.cam->summary.no_contact) return loads;
        loads.normal_force = infinity;
        loads.hertz_pressure.reset();
        return loads;
    };
}

}  // namespace camopt

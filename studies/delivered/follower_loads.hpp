// SPDX-License-Identifier: MIT
// What a follower of a disk cam carries at one cam angle, as a function of the motion there. SI.
//
//   force         F = m ω² s'' + k s + F_0 along the lift (swinging: a moment, N m)
//   torque        F s' on the camshaft, > 0 where the cam drives
//   normal force  F / lever, along the cam's normal (Quantity::normal_lever)
//   Hertz         √(N E* κ / (π b)),  κ = 1/ρ_cam + 1/r: line contact over the width b
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "scene/cam_mechanism.hpp"

#include <optional>

namespace camopt {

/// F / lever.
[[nodiscard]] double normal_force(const DiskCam& cam, const FollowerState& state, double force);

/// Of a normal force (N) at a point of the cam, Pa; 0 where nothing presses. The forces have a contact width.
[[nodiscard]] double hertz_pressure(const DiskCam& cam, const ForceSpec& forces, const MechanismPoint& point,
                                    double normal_force);

/// Whether there is a pressure to speak of: a contact width is given, and the follower has no edge.
[[nodiscard]] bool has_hertz_pressure(const DiskCam& cam, const ForceSpec& forces);

struct FollowerLoads {
    double force = 0.0, torque = 0.0, normal_force = 0.0;
    std::optional<double> hertz_pressure;
};

[[nodiscard]] FollowerLoads follower_loads(const DiskCam& cam, const ForceSpec& forces, double speed,
                                           const FollowerState& state, const MechanismPoint& point);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A whole cam as points: the angles, and the points.
#pragma once

#include "scene/cam_mechanism.hpp"

namespace camopt {

/// The units of a motion: s = lift · y, θ = unit_angle · x.
struct MotionScale {
    double lift = 1.0;        ///< m or rad
    double unit_angle = 1.0;  ///< rad
};

[[nodiscard]] FollowerState state_of(const MotionPoint& point, const MotionScale& scale);

/// At a breakpoint the side after it, at the end that before.
[[nodiscard]] MotionPoint motion_at(const Motion& motion, double x);

/// A point of a cam along a motion.
[[nodiscard]] MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                                             const MotionScale& scale, int station = 0);

/// About `count` angles, uniformly from the first breakpoint to the last, and the breakpoints, ascending;
/// where both coincide the breakpoint is kept. Throws InputError for fewer than 2.
[[nodiscard]] std::vector<double> even_places(const std::vector<double>& breakpoints, int count);

/// Points either by number or by chord tolerance; the motion's breakpoints are always among them.
struct ProfileSampling {
    std::optional<int> count = {};  ///< about this many, evenly by cam angle, breakpoints besides
    double chord_tolerance = 1e-6;  ///< m: the polyline stays this close to the cam; used without a count
};

/// One side of a cam by the variable x of its motion.
using CamPointAt = std::function<MechanismPoint(double x)>;

/// The x of a profile's points, ascending, from the first breakpoint to the last, both included. Throws
/// InputError for a sampling that is not valid.
[[nodiscard]] std::vector<double> profile_places(const CamPointAt& at, const std::vector<double>& breakpoints,
                                                 double unit_angle, const ProfileSampling& sampling);

/// In order of the cam angle, from the motion's begin to its end, both included. `side` at a breakpoint:
/// right (left at the end).
[[nodiscard]] std::vector<MechanismPoint> sampled_profile(const DrivenMechanism& cam, const Motion& motion,
                                                          const MotionScale& scale,
                                                          const ProfileSampling& sampling, int station = 0);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A valve lobe in the words of engine builders, and the program it stands for. SI units; angles of the cam,
// rad (a crank angle is twice as large), counted from the nose.
//
//   follower displacement of the open valve  s = (valve lift + lash) / ratio
//   opening flank  from the ramp's end to the nose, through s(checking height) at the opening angle before it
//   ramp           the law run_in from rest to the velocity v over a third of its height h, then constant
//                  velocity; each part takes the angle 2h / 3v. The closing ramp is the same backwards
//
// Where the ramp ends: on it, if the checking height is not above it; else at `end` before the checking
// point. Default: as the jerk 60 L/D³ up to the acceleration 4 L/D² reaches that point, L = s(lift), D the
// angle from it to the nose. Each stroke is monotone.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

struct MotionSpec;
struct SceneFault;

struct ValveRamp {
    double height = 0.0;        ///< of the follower above the base circle where it ends, m or rad, > 0
    double velocity = 0.0;      ///< of the follower by the cam angle, m/rad or rad/rad, > 0
    std::optional<double> end;  ///< before the opening checking point (after the closing one), > 0
    friend bool operator==(const ValveRamp&, const ValveRamp&) = default;
};

struct ValveSpec {
    double lift = 0.0;                 ///< of the valve at the nose, m, > 0
    double ratio = 1.0;                ///< valve travel / follower travel; of a swinging follower m/rad
    double lash = 0.0;                 ///< at the valve, m, >= 0
    double checking_height = 0.0;      ///< valve lift at which the duration is measured, m, > 0
    double duration = 0.0;             ///< between the checking points
    double opening = 0.0;              ///< of it, before the nose
    std::optional<double> centerline;  ///< of the nose after top dead centre; events alone use it
    ValveRamp opening_ramp, closing_ramp;

    [[nodiscard]] double closing() const { return duration - opening; }
    /// Of the follower, m or rad, at a valve lift.
    [[nodiscard]] double follower(double valve_lift) const { return (valve_lift + lash) / ratio; }
    friend bool operator==(const ValveSpec&, const ValveSpec&) = default;
};

/// The first member that is out of its range ("motion.opening_ramp.height").
[[nodiscard]] std::optional<SceneFault> find_valve_fault(const ValveSpec& valve);

/// Type, lift and segments of the motion become those of the lobe, from the start of the opening ramp on; a
/// dwell fills the turn. Throws SceneError for a lobe with a fault.
void make_valve_lobe(MotionSpec& motion, const ValveSpec& valve);

/// The cam angle of the nose from the start of the motion.
[[nodiscard]] double nose_angle(const ValveSpec& valve);

}  // namespace camopt

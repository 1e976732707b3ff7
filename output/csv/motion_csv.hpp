// SPDX-License-Identifier: MIT
// motion.csv: the motion as a table. Columns and units: docs/results.md.
//
// Rows: 361 uniform cam angles over the motion, every breakpoint, and the peaks. Where the jerk jumps the
// angle stands in two rows: first as seen from the left, then from the right. A value that is infinite stays
// empty.
#pragma once

#include "core/motion.hpp"
#include "scene/scene.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/follower_loads.hpp"

#include <string>
#include <vector>

namespace camopt {

[[nodiscard]] std::string motion_csv(const Motion& motion, const Peaks& peaks, const MotionSpec& spec);

// profile.csv: the cam as a table, one row a point, in the points' order.
//
// Columns: theta_deg, s_mm (swinging: s_deg; the output's), pitch_x_mm, pitch_y_mm (roller centre; without a
// roller the contact), cam_x_mm, cam_y_mm, normal_x, normal_y (outward, of length 1), pressure_angle_deg,
// pitch_radius_mm (radius of curvature of the pitch curve; flat: of the cam), cam_radius_mm, regularity, and
// for a flat face contact_offset_mm. Where the scene has forces then force_n (swinging: moment_nm),
// torque_nm, normal_force_n and, with a width of contact, hertz_pressure_mpa
// (studies/delivered/follower_loads.hpp); the last two are empty where the follower cannot touch the cam
// as designed. Radii are signed, > 0 convex, and empty where infinite. Cam frame of
// output/drawing/profile_shape.hpp.

/// What the columns depend on.
struct ProfileColumns {
    bool swings = false;               ///< the output does
    bool face = false;                 ///< a flat face is the contact
    bool pressure = false;             ///< with the loads: there is a Hertz pressure
    std::vector<FollowerLoads> loads;  ///< one a point; empty: the scene has no forces
};

/// Throws InputError where the number of outputs, or of loads, differs from the points'.
[[nodiscard]] std::string profile_csv(const MechanismProfile& profile, const ProfileColumns& columns);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Keys that do not go together, and parts of the contract that do not exist yet.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {

std::vector<BrokenScene> broken_combinations() {
    return {
        {"lift_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = 10\n"
         "lift_in = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:1: motion.lift_in: found together with motion.lift_mm, which means the same; allowed: "
         "only one "
         "of the two"},
        {"lift_length_and_angle",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_deg = 10\n"
         "lift_mm = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:1: motion.lift_mm: found together with motion.lift_deg, which means the same; allowed: "
         "only one "
         "of the two"},
        {"rise_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "rise_deg = 90\n"
         "rise_rad = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:1: motion.rise_rad: found together with motion.rise_deg, which means the same; allowed: "
         "only one "
         "of the two"},
        {"speed_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "speed_rad_s = 9\n"
         "speed_rpm = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:1: motion.speed_rpm: found together with motion.speed_rad_s, which means the same; "
         "allowed: only "
         "one of the two"},
        {"limit_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "velocity = 1.7\n"
         "velocity_mm_s = 300\n",
         "s.toml:7:1: limits.velocity_mm_s: found together with limits.velocity, which means the same; "
         "allowed: "
         "only one of the two"},
        {"segments_and_breakpoints",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 2\n"
         "breakpoints = [0, 0.5, 1]\n",
         "s.toml:7:1: spline.breakpoints: found together with spline.segments, which means the same; "
         "allowed: only "
         "one of the two"},
        {"return_in_drd",
         "[motion]\n"
         "type = \"DRD\"\n"
         "return_deg = 90\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:14: motion.return_deg: found a return in a motion of type \"DRD\"; allowed: only in type "
         "\"RR\""},
        {"turn_exceeded",
         "[motion]\n"
         "type = \"RR\"\n"
         "rise_deg = 200\n"
         "return_deg = 200\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:14: motion.return_deg: found 200, together 400 deg of rise and return; allowed: one "
         "revolution, 360 deg, at most"},
        {"turn_exceeded_by_default",
         "[motion]\n"
         "type = \"RR\"\n"
         "rise_deg = 200\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:12: motion.rise_deg: found 200, together 400 deg of rise and return; allowed: one "
         "revolution, 360 deg, at most"},
        {"turn_exceeded_rad",
         "[motion]\n"
         "type = \"RR\"\n"
         "rise_deg = 200\n"
         "return_rad = 3\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:14: motion.return_rad: found 3, together 6.490658504 rad of rise and return; allowed: one "
         "revolution, 6.283185307 rad, at most"},
        {"symmetric_unequal",
         "[motion]\n"
         "type = \"RR\"\n"
         "rise_deg = 90\n"
         "return_deg = 80\n"
         "symmetric = true\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:5:13: motion.symmetric: found true with a return different from the rise; allowed: false, "
         "or equal "
         "angles for rise and return"},
        {"via_outside",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ at = 0.5, velocity = 1 }, { at = 1.5, velocity = 1 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:43: motion.via[1].at: found 1.5; allowed: a number from 0 to 1"},
        {"via_negative",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ at = -0.1, velocity = 1 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:15: motion.via[0].at: found -0.1; allowed: a number >= 0"},
        {"via_same_place",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ at = 0.5, velocity = 1 }, { at = 0.5, displacement = 1 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:43: motion.via[1].at: found 0.5, the location of motion.via[0]; allowed: one point at "
         "each location"},
        {"via_empty",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ at = 0.5 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:8: motion.via[0]: found no value; allowed: at least one of displacement, velocity, "
         "acceleration"},
        {"breakpoints_empty",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = []\n",
         "s.toml:6:15: spline.breakpoints: found fewer than 2 breakpoints; allowed: 2 to 65537"},
        {"breakpoints_single",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0]\n",
         "s.toml:6:15: spline.breakpoints: found fewer than 2 breakpoints; allowed: 2 to 65537"},
        {"breakpoints_start",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0.1, 1]\n",
         "s.toml:6:16: spline.breakpoints[0]: found 0.1; allowed: 0, the start of the motion"},
        {"breakpoints_end",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, 0.5, 0.9]\n",
         "s.toml:6:24: spline.breakpoints[2]: found 0.9; allowed: 1, the end of the motion"},
        {"breakpoints_end_rr",
         "[motion]\n"
         "type = \"RR\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, 1]\n",
         "s.toml:6:19: spline.breakpoints[1]: found 1; allowed: 2, the end of the motion"},
        {"breakpoints_descend",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, 0.5, 0.4, 1]\n",
         "s.toml:6:24: spline.breakpoints[2]: found 0.4 after 0.5; allowed: ascending breakpoints"},
        {"breakpoints_equal",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, 0.5, 0.5, 1]\n",
         "s.toml:6:24: spline.breakpoints[2]: found 0.5 after 0.5; allowed: ascending breakpoints"},
        {"breakpoints_nan",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, nan, 1]\n",
         "s.toml:6:19: spline.breakpoints[1]: found nan; allowed: a number >= 0"},
        {"breakpoints_not_symmetric",
         "[motion]\n"
         "type = \"DRD\"\n"
         "symmetric = true\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, 0.3, 1]\n",
         "s.toml:7:19: spline.breakpoints[1]: found 0.3 in a symmetric motion; allowed: 0.7, the mirror "
         "image of another breakpoint"},
        {"continuity_high_for_cubic",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "continuity = 3\n",
         "s.toml:6:14: spline.continuity: found 3; allowed: 2 with degree 3"},
        {"continuity_high_for_quintic",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degree = 5\n"
         "continuity = 5\n",
         "s.toml:7:14: spline.continuity: found 5; allowed: an integer from 2 to 4"},
        {"end_jerk_cubic",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "end_jerk = \"zero\"\n",
         "s.toml:6:12: spline.end_jerk: found \"zero\" with degree 3; allowed: \"free\", or degree 5"},
        {"ordinates_low_continuity",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degree = 5\n"
         "continuity = 3\n"
         "design = \"ordinates\"\n",
         "s.toml:8:10: spline.design: found \"ordinates\" with continuity 3; allowed: \"ordinates\" only "
         "with continuity 4"},
        {"reference_number_missing",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "velocity = 0.5\n"
         "jerk = 1\n"
         "reference = { jerk = 69 }\n",
         "s.toml:6:13: objective.reference.velocity: found no number; allowed: a number > 0, because "
         "objective.velocity = 0.5"},
        {"reference_table_missing_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "rms_jerk = 1\n"
         "[objective.reference]\n"
         "jerk = 69\n",
         "s.toml:5:1: objective.reference.rms_jerk: found no number; allowed: a number > 0, because "
         "objective.rms_jerk = 1"},
        {"limit_without_speed",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "velocity_mm_s = 300\n",
         "s.toml:6:1: limits.velocity_mm_s: found a limit in mm/s without a speed; allowed: together with "
         "motion.speed_rpm or motion.speed_rad_s"},
        {"limit_of_angle_for_length",
         "[motion]\n"
         "type = \"DRD\"\n"
         "speed_rpm = 60\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "jerk_deg_s3 = 300\n",
         "s.toml:7:1: limits.jerk_deg_s3: found a limit in deg/s^3 where the lift is a length; allowed: a "
         "limit in mm, in or m, or a normalised one"},
        {"limit_of_length_for_angle",
         "[motion]\n"
         "type = \"DRD\"\n"
         "speed_rpm = 60\n"
         "lift_deg = 20\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "acceleration_mm_s2 = 300\n",
         "s.toml:8:1: limits.acceleration_mm_s2: found a limit in mm/s^2 where the lift is an angle; "
         "allowed: a limit in deg or rad, or a normalised one"},
        {"program",
         "[motion]\n"
         "type = \"program\"\n"
         "lift_mm = 80\n"
         "[[motion.segments]]\n"
         "kind = \"dwell\"\n"
         "angle_deg = 60\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:4:1: motion.segments: found dwells only; allowed: at least one segment with kind = \"law\" "
         "or "
         "kind = \"spline\""},
        {"program_key",
         "[motion]\n"
         "type = \"DRD\"\n"
         "closed = false\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:1: motion.closed: found this key in a motion of type \"DRD\"; allowed: only in type "
         "\"program\""},
        {"cam",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[cam]\n"
         "type = \"disk\"\n",
         "s.toml:5:1: cam.follower: missing; allowed: \"translating_roller\", \"translating_flat\", "
         "\"translating_knife\", \"oscillating_roller\", \"oscillating_flat\", \"rotating\" or "
         "\"translating\""},
        {"cam_before_anything",
         "[cam]\n"
         "base_radius_mm = 40\n",
         "s.toml:1:1: cam.type: missing; allowed: \"disk\", \"remote\", \"barrel\", \"cylindrical\" or "
         "\"inverse\""},
        {"knots_free_in_hundreds",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 300\n"
         "knots = \"free\"\n",
         "s.toml:7:9: spline.knots: found \"free\" with 300 segments; allowed: \"fixed\", or at most 256 "
         "segments"},
        {"torque",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "torque = 0.1\n"
         "reference = { jerk = 69 }\n",
         "s.toml:6:13: objective.reference.torque: found no number; allowed: a number > 0, because "
         "objective.torque = 0.1"},
        {"base_radius",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "base_radius = 1\n",
         "s.toml:5:15: objective.base_radius: found 1 without a cam; allowed: 0, or a [cam] table with this "
         "dimension"},
        {"torque_negative",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "torque = -1\n",
         "s.toml:5:10: objective.torque: found -1; allowed: a number >= 0"},
        {"pressure_angle",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "pressure_angle_deg = 30\n",
         "s.toml:6:22: limits.pressure_angle_deg: found a limit of a cam without a cam; allowed: only "
         "together with a [cam] table"},
        {"cam_radius",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "cam_radius_min_in = 0.1\n",
         "s.toml:6:21: limits.cam_radius_min_in: found a limit of a cam without a cam; allowed: only "
         "together with a [cam] table"},
    };
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// Motors in place of cams.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_drives_parts {

/// Seven lines.
const std::string motor =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "motion.speed_rpm = 300\n"
    "[drive]\n"
    "motor_inertia_kg_m2 = 1e-4\n"
    "transmission_mm_per_rev = 60\n";
const std::string curve =
    "two or more pairs [speed in rpm, torque in N m] from speed 0 on, speeds that ascend, torques >= 0 that "
    "never rise and fall ever more steeply (concave)";

}  // namespace broken_drives_parts

std::vector<BrokenScene> broken_drives() {
    using namespace broken_drives_parts;
    return {
        {"motor_limit_without_motor",
         "objective.jerk = 1\nmotion.type = \"DRD\"\n[limits]\nmotor_speed_rpm = 3000\n",
         "s.toml:4:19: limits.motor_speed_rpm: found a figure of a motor without one; allowed: only together "
         "with "
         "a [drive] table"},
        {"motor_without_transmission",
         "objective.jerk = 1\nmotion.type = \"DRD\"\n[drive]\nmotor_inertia_kg_m2 = 1\n",
         "s.toml:3:1: drive.transmission_mm_per_rev: missing; allowed: a number > 0"},
        {"motor_without_speed",
         "objective.jerk = 1\nmotion.type = \"DRD\"\n[drive]\nmotor_inertia_kg_m2 = "
         "1\ntransmission_mm_per_rev = 9\n",
         "s.toml:3:1: drive: found a motor without a speed; allowed: only where motion.speed is given"},
        {"motor_without_inertia",
         "objective.jerk = 1\nmotion.type = \"DRD\"\nmotion.speed_rpm = 9\n[drive]\ntransmission_mm_per_rev "
         "= 9\n",
         "s.toml:4:1: drive: found no mass and no inertia; allowed: a load or drive.motor_inertia_kg_m2 > 0: "
         "nothing else resists acceleration"},
        {"motor_of_other_unit", motor + "load_inertia_kg_m2 = 2\n",
         "s.toml:8:1: drive.load_inertia_kg_m2: found a value in kg m^2 where the lift is a length; allowed: "
         "load_mass_kg, transmission_mm_per_rev, viscous_n_s_m, force_n, friction_n"},
        {"motor_friction_of_unknown_direction", motor + "friction_n = 2\n",
         "s.toml:8:14: drive.friction_n: found friction in a motion that may reverse within a stroke; "
         "allowed: its "
         "direction must be known: motion.monotone = true, or no friction"},
        {"motor_cycle_too_short", motor + "cycle_deg = 90\n",
         "s.toml:8:13: drive.cycle_deg: found 90 deg; allowed: at least 180 deg, the motion itself"},
        {"motor_curve_that_rises", motor + "[limits]\nmotor_curve = [[0, 4], [3000, 5]]\n",
         "s.toml:9:15: limits.motor_curve: found a torque of 5 N m at 3000 rpm, above the line before it; "
         "allowed: " +
             curve},
        {"motor_curve_from_elsewhere", motor + "[limits]\nmotor_curve = [[10, 4], [3000, 2]]\n",
         "s.toml:9:15: limits.motor_curve: found 10 rpm first; allowed: " + curve},
        {"motor_curve_not_concave", motor + "[limits]\nmotor_curve = [[0, 4], [1000, 2], [3000, 1]]\n",
         "s.toml:9:15: limits.motor_curve: found a torque of 1 N m at 3000 rpm, above the line before it; "
         "allowed: " +
             curve},
        {"motor_torques_that_exclude_each_other",
         motor + "[limits]\nmotor_torque_nm = { min = 2, max = 1 }\n",
         "s.toml:9:19: limits.motor_torque_nm: found a range from 2 to 1; allowed: min below max"},
        {"motor_with_free_knots", motor + "[limits]\nmotor_torque_nm = 2\n[spline]\nknots = \"free\"\n",
         "s.toml:9:19: limits.motor_torque_nm: found a figure of the motor with spline.knots = \"free\"; "
         "allowed: "
         "fixed knots"},
    };
}

}  // namespace camopt::input

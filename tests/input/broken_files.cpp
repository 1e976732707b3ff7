// SPDX-License-Identifier: MIT
// Broken TOML, missing and unknown keys, wrong types.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {

namespace broken_files_parts {

/// As the key table lists them.
const std::string set_point_keys =
    "at, at_deg, at_rad, at_crank_deg, from, from_deg, from_rad, from_crank_deg, to, to_deg, to_rad, "
    "to_crank_deg, displacement, displacement_mm, "
    "displacement_in, displacement_m, displacement_deg, displacement_rad, velocity, velocity_mm_s, "
    "velocity_in_s, "
    "velocity_m_s, velocity_deg_s, velocity_rad_s, velocity_mm_rad, velocity_in_rad, velocity_m_rad, "
    "velocity_mm_deg, velocity_in_deg, velocity_deg_deg, velocity_rad_rad, acceleration, acceleration_mm_s2, "
    "acceleration_in_s2, "
    "acceleration_m_s2, acceleration_deg_s2, acceleration_rad_s2, acceleration_mm_rad2, "
    "acceleration_in_rad2, "
    "acceleration_m_rad2, acceleration_mm_deg2, acceleration_in_deg2, acceleration_deg_deg2, "
    "acceleration_rad_rad2";

}  // namespace broken_files_parts

std::vector<BrokenScene> broken_files() {
    using namespace broken_files_parts;
    return {
        {"syntax_no_value",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "title =",
         "s.toml:5:8: TOML: Error while parsing key-value pair: encountered end-of-file"},
        {"syntax_bare_word",
         "[motion]\n"
         "type = DRD\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:2:8: TOML: Error while parsing value: could not determine value type"},
        {"syntax_open_header", "[motion\n",
         "s.toml:1:8: TOML: Error while parsing table header: expected ']', saw '\\n'"},
        {"syntax_empty_header", "[\nmotion]\n",
         "s.toml:1:2: TOML: Error while parsing key: expected bare key starting character or string "
         "delimiter, saw '\\n'"},
        {"syntax_key_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "type = \"RR\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:8: TOML: Error while parsing key-value pair: cannot redefine existing string 'type'"},
        {"syntax_table_twice",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[motion]\n"
         "rise_deg = 3\n",
         "s.toml:3:1: TOML: Error while parsing table header: cannot redefine existing table 'motion'"},
        {"syntax_open_string", "title = \"abc\n",
         "s.toml:1:13: TOML: Error while parsing string: unescaped control characters other than TAB "
         "(U+0009) are explicitly prohibited"},
        {"syntax_integer_too_large",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 99999999999999999999\n",
         "s.toml:6:32: TOML: Error while parsing decimal integer: '99999999999999999999' is not "
         "representable in 64 bits"},
        {"syntax_letter_outside_a_text",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "velocity Ë0\n"
         "jerk = 1\n",
         "s.toml:4:10: TOML: Error while parsing key-value pair: expected '=', saw 'Ë'"},
        {"syntax_dots_without_end",
         "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a."
         "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a."
         "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1\n",
         "s.toml:1:202: TOML: found more than 100 dots in one key or word"},
        {"empty_file", "", "s.toml:1:1: motion: missing; allowed: a [motion] table"},
        {"no_motion",
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:1: motion: missing; allowed: a [motion] table"},
        {"no_type",
         "[motion]\n"
         "rise_deg = 90\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:1: motion.type: missing; allowed: \"DRD\", \"RR\", \"program\" or \"valve\""},
        {"no_objective",
         "[motion]\n"
         "type = \"DRD\"\n",
         "s.toml:1:1: objective: missing; allowed: a [objective] table"},
        {"no_weight",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "tie_break = \"none\"\n",
         "s.toml:3:1: objective: found no weight > 0; allowed: at least one of velocity, acceleration, jerk, "
         "torque, rms_acceleration, rms_jerk, area > 0, or of a dimension of the cam that is a range"},
        {"weights_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "velocity = 0\n"
         "jerk = 0.0\n",
         "s.toml:3:1: objective: found no weight > 0; allowed: at least one of velocity, acceleration, jerk, "
         "torque, rms_acceleration, rms_jerk, area > 0, or of a dimension of the cam that is a range"},
        {"via_without_at",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ displacement = 0.5 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:8: motion.via[0].at: missing; allowed: at (at_deg, at_rad) of a point, or from and to of "
         "a "
         "region"},
        {"unknown_top",
         "titel = \"x\"\n"
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:1: titel: found an unknown key; allowed: title, motion, spline, objective, cam, drawing, "
         "forces, "
         "measured, dynamics, drive, limits, solver; did you mean 'title'?"},
        {"unknown_misspelt",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mn = 10\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:1: motion.lift_mn: found an unknown key; allowed: type, lift_mm, lift_in, lift_m, "
         "lift_deg, lift_rad, rise_deg, rise_rad, rise_crank_deg, return_deg, return_rad, return_crank_deg, "
         "speed_rpm, speed_rad_s, symmetric, "
         "within_lift, monotone, via, segments, closed, repeat, stops, phase_deg, phase_rad, "
         "phase_crank_deg, start, end, corridor, " +
             valve_keys +
             "; did you mean "
             "'lift_mm'?"},
        {"unknown_unit",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_cm = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:1: motion.lift_cm: found an unknown key; allowed: type, lift_mm, lift_in, lift_m, "
         "lift_deg, lift_rad, rise_deg, rise_rad, rise_crank_deg, return_deg, return_rad, return_crank_deg, "
         "speed_rpm, speed_rad_s, symmetric, "
         "within_lift, monotone, via, segments, closed, repeat, stops, phase_deg, phase_rad, "
         "phase_crank_deg, start, end, corridor, " +
             valve_keys +
             "; did you mean "
             "'lift_mm'?"},
        {"unknown_without_unit",
         "[motion]\n"
         "type = \"DRD\"\n"
         "rise = 90\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:1: motion.rise: found an unknown key; allowed: type, lift_mm, lift_in, lift_m, lift_deg, "
         "lift_rad, rise_deg, rise_rad, rise_crank_deg, return_deg, return_rad, return_crank_deg, speed_rpm, "
         "speed_rad_s, symmetric, "
         "within_lift, monotone, via, segments, closed, repeat, stops, phase_deg, phase_rad, "
         "phase_crank_deg, start, end, corridor, " +
             valve_keys +
             "; did you mean "
             "'rise_deg'?"},
        {"unknown_spline",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degre = 3\n",
         "s.toml:6:1: spline.degre: found an unknown key; allowed: degree, segments, breakpoints, knots, "
         "continuity, end_jerk, design; did you mean 'degree'?"},
        {"unknown_in_wrong_table",
         "degree = 3\n"
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:1: degree: found an unknown key; allowed: title, motion, spline, objective, cam, drawing, "
         "forces, "
         "measured, dynamics, drive, limits, solver; did you mean 'spline.degree'?"},
        {"unknown_strange",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "xyzzy = 3\n",
         "s.toml:6:1: spline.xyzzy: found an unknown key; allowed: degree, segments, breakpoints, knots, "
         "continuity, end_jerk, design"},
        {"unknown_objective",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerks = 1\n",
         "s.toml:4:1: objective.jerks: found an unknown key; allowed: velocity, acceleration, jerk, "
         "rms_acceleration, rms_jerk, torque, residual, dynamic_acceleration, area, "
         "motor_torque, motor_torque_rms, deviation, deviation_rms, base_radius, "
         "roller_radius, "
         "offset, center_distance, "
         "arm_length, face_offset, reference, tie_break; did you mean 'jerk'?"},
        {"unknown_reference",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "reference = { jrk = 69 }\n",
         "s.toml:5:15: objective.reference.jrk: found an unknown key; allowed: velocity, acceleration, jerk, "
         "rms_acceleration, rms_jerk, torque, residual, dynamic_acceleration, area, "
         "motor_torque, motor_torque_rms, deviation, deviation_rms; did you mean 'jerk'?"},
        {"unknown_limit",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "velocity_mm = 3\n",
         "s.toml:6:1: limits.velocity_mm: found an unknown key; allowed: " + known_limit_keys +
             "; did you "
             "mean 'velocity_mm_s'?"},
        {"unknown_solver",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "max_time = 3\n",
         "s.toml:6:1: solver.max_time: found an unknown key; allowed: name, tolerance, gap, max_seconds, "
         "explain_seconds, explain_changes, starts, seed, options; did you mean 'max_seconds'?"},
        {"unknown_via",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [{ at = 0.5, displacment = 0.5 }]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:20: motion.via[0].displacment: found an unknown key; allowed: " + set_point_keys +
             "; did you mean 'displacement'?"},
        {"unknown_table",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solvers]\n"
         "name = \"auto\"\n",
         "s.toml:5:2: solvers: found an unknown key; allowed: title, motion, spline, objective, cam, "
         "drawing, forces, "
         "measured, dynamics, drive, limits, solver; did you mean 'solver'?"},
        {"motion_is_number",
         "motion = 3\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:10: motion: found 3; allowed: a [motion] table"},
        {"motion_is_array",
         "[[motion]]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:1: motion: found an array; allowed: a [motion] table"},
        {"title_is_number",
         "title = 4\n"
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:9: title: found 4; allowed: a text in quotes"},
        {"type_is_number",
         "[motion]\n"
         "type = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:2:8: motion.type: found 1; allowed: \"DRD\", \"RR\", \"program\" or \"valve\""},
        {"type_unknown",
         "[motion]\n"
         "type = \"drd\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:2:8: motion.type: found \"drd\"; allowed: \"DRD\", \"RR\", \"program\" or \"valve\"; did "
         "you mean "
         "'DRD'?"},
        {"type_long",
         "[motion]\n"
         "type = \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:2:8: motion.type: found \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…\"; "
         "allowed: \"DRD\", \"RR\", \"program\" or \"valve\""},
        {"lift_is_text",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = \"10\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found \"10\"; allowed: a number > 0"},
        {"lift_is_boolean",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = true\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found true; allowed: a number > 0"},
        {"lift_is_date",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = 2020-01-01\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found a date or time; allowed: a number > 0"},
        {"symmetric_is_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "symmetric = 1\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:13: motion.symmetric: found 1; allowed: true or false"},
        {"via_is_table",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = { at = 0.5 }\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:7: motion.via: found a table; allowed: an array of tables"},
        {"via_holds_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "via = [0.5]\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:8: motion.via[0]: found 0.5; allowed: a table of " + set_point_keys},
        {"degree_is_float",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degree = 3.0\n",
         "s.toml:6:10: spline.degree: found 3.0, a number with a decimal point or exponent; allowed: 3 or 5, "
         "written without one"},
        {"degree_is_text",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degree = \"3\"\n",
         "s.toml:6:10: spline.degree: found \"3\"; allowed: 3 or 5"},
        {"segments_is_float",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 12.0\n",
         "s.toml:6:12: spline.segments: found 12.0, a number with a decimal point or exponent; allowed: an "
         "integer from 1 to 65536, written without one"},
        {"segments_is_fraction",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 12.5\n",
         "s.toml:6:12: spline.segments: found 12.5; allowed: an integer from 1 to 65536"},
        {"segments_has_exponent",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 1e1\n",
         "s.toml:6:12: spline.segments: found 10.0, a number with a decimal point or exponent; allowed: an "
         "integer from 1 to 65536, written without one"},
        {"breakpoints_is_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = 5\n",
         "s.toml:6:15: spline.breakpoints: found 5; allowed: an array of numbers"},
        {"breakpoints_hold_text",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "breakpoints = [0, \"a\", 1]\n",
         "s.toml:6:19: spline.breakpoints[1]: found \"a\"; allowed: a number >= 0"},
        {"reference_is_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "reference = 69\n",
         "s.toml:5:13: objective.reference: found 69; allowed: a text in quotes or a table"},
        {"options_is_number",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "options = 3\n",
         "s.toml:6:11: solver.options: found 3; allowed: a [solver.options] table"},
        {"option_is_array",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "options = { max_iter = [1] }\n",
         "s.toml:6:24: solver.options.max_iter: found an array; allowed: a text, a finite number, true or "
         "false"},
        {"option_is_nan",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "options = { tol = nan }\n",
         "s.toml:6:19: solver.options.tol: found nan; allowed: a text, a finite number, true or false"},
        {"solver_is_text",
         "solver = \"ipopt\"\n"
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:1:10: solver: found \"ipopt\"; allowed: a [solver] table"},
    };
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// Cams: values of their dimensions, dimensions that do not fit the follower, cams nobody can build.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_cams_parts {

/// Four lines: a cam without a follower.
const std::string start =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "[cam]\n"
    "type = \"disk\"\n";

/// Every key of [cam] for a disk cam, as messages list them.
const std::string known_keys =
    "type, follower, base_radius_mm, base_radius_in, base_radius_m, roller_radius_mm, "
    "roller_radius_in, roller_radius_m, offset_mm, offset_in, offset_m, center_distance_mm, "
    "center_distance_in, center_distance_m, arm_length_mm, arm_length_in, arm_length_m, "
    "face_offset_mm, face_offset_in, face_offset_m, face_half_width_mm, face_half_width_in, "
    "face_half_width_m, face_radius_mm, face_radius_in, face_radius_m, form, groove_clearance_mm, "
    "groove_clearance_in, groove_clearance_m, "
    "groove_wall_mm, groove_wall_in, groove_wall_m, roller_distance_mm, roller_distance_in, "
    "roller_distance_m, arm_angle_deg, arm_angle_rad, second_roller_radius_mm, "
    "second_roller_radius_in, second_roller_radius_m, second_offset_mm, second_offset_in, "
    "second_offset_m, second_arm_length_mm, second_arm_length_in, second_arm_length_m, rotation";

/// Eight lines: a cam with a translating roller.
const std::string roller =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "base_radius_mm = 40\n"
    "roller_radius_mm = 10\n";

/// Seven lines: a cam with a translating flat face.
const std::string flat =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_flat\"\n"
    "base_radius_mm = 40\n";

/// Seven lines: an oscillating roller without base radius, center distance and arm.
const std::string arm =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_deg = 20\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"oscillating_roller\"\n"
    "roller_radius_mm = 10\n";

/// Seven lines: an oscillating flat face without a base radius.
const std::string face =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_deg = 20\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"oscillating_flat\"\n"
    "center_distance_mm = 80\n";

}  // namespace broken_cams_parts

std::vector<BrokenScene> broken_cams() {
    using namespace broken_cams_parts;
    return {
        {"cam_no_table",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "cam = 3\n",
         "s.toml:3:7: cam: found 3; allowed: a [cam] table"},
        {"cam_type_unknown",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "cam.type = \"cylinder\"\n",
         "s.toml:3:12: cam.type: found \"cylinder\"; allowed: \"disk\", \"remote\", \"barrel\", "
         "\"cylindrical\" "
         "or \"inverse\""},
        {"cam_follower_missing", start,
         "s.toml:3:1: cam.follower: missing; allowed: \"translating_roller\", \"translating_flat\", "
         "\"translating_knife\", \"oscillating_roller\", \"oscillating_flat\", \"rotating\" or "
         "\"translating\""},
        {"cam_follower_unknown", start + "follower = \"roller\"\n",
         "s.toml:5:12: cam.follower: found \"roller\"; allowed: \"translating_roller\", "
         "\"translating_flat\", \"translating_knife\", \"oscillating_roller\", \"oscillating_flat\", "
         "\"rotating\" or \"translating\"; did you mean 'translating_roller' or 'oscillating_roller'?"},
        {"cam_base_radius_missing", start + "follower = \"translating_knife\"\n",
         "s.toml:3:1: cam.base_radius_mm: missing; allowed: a number > 0, or a range { min = …, max = … }"},
        {"cam_form_unknown", roller + "form = \"slotted\"\n",
         "s.toml:9:8: cam.form: found \"slotted\"; allowed: \"open\", \"grooved\" or \"conjugate\""},
        {"cam_form_of_a_face", flat + "form = \"grooved\"\n",
         "s.toml:8:8: cam.form: found \"grooved\" for the follower \"translating_flat\"; allowed: only with "
         "translating_roller and oscillating_roller: the others touch one side"},
        {"cam_groove_without_a_groove", roller + "groove_clearance_mm = 0.1\n",
         "s.toml:9:23: cam.groove_clearance_mm: found a number that a cam of form \"open\" with the follower "
         "\"translating_roller\" does not have; allowed: only with cam.form = \"grooved\""},
        {"cam_conjugate_without_a_distance", roller + "form = \"conjugate\"\n",
         "s.toml:4:1: cam.roller_distance: found 0 for a cam of form \"conjugate\"; allowed: the distance "
         "between "
         "the rollers' axes, above 0"},
        {"cam_conjugate_arm_of_a_slide", roller + "form = \"conjugate\"\narm_angle_deg = 60\n",
         "s.toml:10:1: cam.arm_angle_deg: found a key that the follower \"translating_roller\" does not "
         "have; "
         "allowed: only with \"oscillating_roller\""},
        {"cam_conjugate_rollers_too_close", roller + "form = \"conjugate\"\nroller_distance_mm = 65\n",
         "s.toml:10:22: cam.roller_distance_mm: found 65 mm, which leaves the second roller 5 mm from the "
         "cam's centre at the largest displacement; allowed: more than its radius of 10 mm, for every base "
         "and "
         "roller radius allowed"},
        {"cam_conjugate_arms_too_close",
         arm + "base_radius_mm = 40\ncenter_distance_mm = 80\narm_length_mm = 70\nform = \"conjugate\"\n"
               "arm_angle_deg = 40\n",
         "s.toml:12:17: cam.arm_angle_deg: found 40 deg, which puts the second arm -18.2132 to 1.78679 deg "
         "from "
         "the line of centres, its roller 25.7123 mm from the cam's centre; allowed: between 0 and 180 deg, "
         "with more than its radius of 10 mm, for every dimension allowed"},
        {"cam_least_force_in_a_groove",
         "motion.speed_rpm = 300\n" + roller +
             "form = \"grooved\"\n[forces]\nmass_kg = 1\n[limits]\ncontact_force_min_n = 10\n",
         "s.toml:14:23: limits.contact_force_min_n: found a least contact force for a cam of form "
         "\"grooved\"; "
         "allowed: only with cam.form = \"open\": this cam drives both ways"},
        {"cam_rotation_unknown", roller + "rotation = \"left\"\n",
         "s.toml:9:12: cam.rotation: found \"left\"; allowed: \"counterclockwise\" or \"clockwise\""},
        {"cam_key_unknown", roller + "ofset_mm = 3\n",
         "s.toml:9:1: cam.ofset_mm: found an unknown key; allowed: " + known_keys +
             "; did you mean 'offset_mm'?"},
        {"cam_unit_missing", roller + "offset = 3\n",
         "s.toml:9:1: cam.offset: found an unknown key; allowed: " + known_keys +
             "; did you mean 'offset_mm'?"},
        {"cam_base_radius_zero", arm + "base_radius_in = 0\n",
         "s.toml:8:18: cam.base_radius_in: found 0; allowed: a number > 0, or a range { min = …, max = … }"},
        {"cam_base_radius_text", arm + "base_radius_mm = \"40\"\n",
         "s.toml:8:18: cam.base_radius_mm: found \"40\"; allowed: a number > 0, or a range { min = …, max = "
         "… }"},
        {"cam_base_radius_array", arm + "base_radius_mm = [20, 60]\n",
         "s.toml:8:18: cam.base_radius_mm: found an array; allowed: a number > 0, or a range { min = …, max "
         "= … }"},
        {"cam_base_radius_twice", roller + "base_radius_in = 2\n",
         "s.toml:9:1: cam.base_radius_in: found together with cam.base_radius_mm, which means the same; "
         "allowed: "
         "only one of the two"},
        {"cam_range_without_max", arm + "base_radius_mm = { min = 20 }\n",
         "s.toml:8:18: cam.base_radius_mm.max: missing; allowed: a number > 0"},
        {"cam_range_empty", arm + "base_radius_mm = {}\n",
         "s.toml:8:18: cam.base_radius_mm.min: missing; allowed: a number > 0"},
        {"cam_range_unknown_key", arm + "base_radius_mm = { min = 20, maximum = 60 }\n",
         "s.toml:8:30: cam.base_radius_mm.maximum: found an unknown key; allowed: min, max"},
        {"cam_range_text", arm + "base_radius_mm = { min = 20, max = \"60\" }\n",
         "s.toml:8:36: cam.base_radius_mm.max: found \"60\"; allowed: a number > 0"},
        {"cam_range_negative", arm + "base_radius_mm = { min = -20, max = 60 }\n",
         "s.toml:8:26: cam.base_radius_mm.min: found -20; allowed: a number > 0"},
        {"cam_range_descends", arm + "base_radius_mm = { min = 60, max = 20 }\n",
         "s.toml:8:18: cam.base_radius_mm: found a range from 60 to 20; allowed: min below max"},
        {"cam_range_of_nothing", roller + "offset_in = { min = 0.5, max = 0.5 }\n",
         "s.toml:9:13: cam.offset_in: found a range from 0.5 to 0.5; allowed: min below max"},
        {"cam_offset_infinite", roller + "offset_mm = inf\n",
         "s.toml:9:13: cam.offset_mm: found inf; allowed: a finite number, or a range { min = …, max = … }"},
        {"cam_offset_range_nan", roller + "offset_mm = { min = 0, max = nan }\n",
         "s.toml:9:30: cam.offset_mm.max: found nan; allowed: a finite number"},
        {"cam_roller_missing",
         start + "follower = \"translating_roller\"\n"
                 "base_radius_mm = 40\n",
         "s.toml:3:1: cam.roller_radius_mm: missing for the follower \"translating_roller\"; allowed: a "
         "number > 0, or a range { min = …, max = … }"},
        {"cam_center_distance_missing", arm + "base_radius_mm = 40\n",
         "s.toml:4:1: cam.center_distance_mm: missing for the follower \"oscillating_roller\"; allowed: a "
         "number > 0, or a range { min = …, max = … }"},
        {"cam_arm_missing",
         arm + "base_radius_mm = 40\n"
               "center_distance_mm = 80\n",
         "s.toml:4:1: cam.arm_length_mm: missing for the follower \"oscillating_roller\"; allowed: a number "
         "> 0, or a range { min = …, max = … }"},
        {"cam_roller_on_flat", flat + "roller_radius_mm = 10\n",
         "s.toml:8:1: cam.roller_radius_mm: found a key that the follower \"translating_flat\" does "
         "not have; allowed: only with \"translating_roller\" or \"oscillating_roller\""},
        {"cam_roller_on_knife",
         start + "follower = \"translating_knife\"\n"
                 "base_radius_mm = 40\n"
                 "roller_radius_mm = { min = 1, max = 2 }\n",
         "s.toml:7:1: cam.roller_radius_mm: found a key that the follower \"translating_knife\" does "
         "not have; allowed: only with \"translating_roller\" or \"oscillating_roller\""},
        {"cam_offset_on_flat", flat + "offset_mm = 0\n",
         "s.toml:8:1: cam.offset_mm: found a key that the follower \"translating_flat\" does not have; "
         "allowed: only with \"translating_roller\" or \"translating_knife\""},
        {"cam_center_distance_on_roller", roller + "center_distance_in = 4\n",
         "s.toml:9:1: cam.center_distance_in: found a key that the follower \"translating_roller\" "
         "does not have; allowed: only with \"oscillating_roller\" or \"oscillating_flat\""},
        {"cam_arm_on_flat_face",
         face + "base_radius_mm = 40\n"
                "arm_length_mm = 60\n",
         "s.toml:9:1: cam.arm_length_mm: found a key that the follower \"oscillating_flat\" does not "
         "have; allowed: only with \"oscillating_roller\""},
        {"cam_face_offset_on_arm",
         arm + "base_radius_mm = 40\n"
               "center_distance_mm = 80\n"
               "arm_length_mm = 70\n"
               "face_offset_mm = 1\n",
         "s.toml:11:1: cam.face_offset_mm: found a key that the follower \"oscillating_roller\" does "
         "not have; allowed: only with \"oscillating_flat\""},
        {"cam_face_width_on_roller", roller + "face_half_width_mm = 20\n",
         "s.toml:9:1: cam.face_half_width_mm: found a key that the follower \"translating_roller\" "
         "does not have; allowed: only with \"translating_flat\""},
        {"cam_face_width_range", flat + "face_half_width_mm = { min = 10, max = 20 }\n",
         "s.toml:8:22: cam.face_half_width_mm: found a table; allowed: a number > 0"},
        {"cam_face_width_zero", flat + "face_half_width_in = 0\n",
         "s.toml:8:22: cam.face_half_width_in: found 0; allowed: a number > 0"},
        {"cam_oscillating_with_length",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"oscillating_roller\"\n"
         "base_radius_mm = 40\n"
         "roller_radius_mm = 10\n",
         "s.toml:6:12: cam.follower: found \"oscillating_roller\" where the lift is a length; allowed: a "
         "translating follower, or motion.lift_deg or motion.lift_rad"},
        {"cam_oscillating_without_lift",
         start + "follower = \"oscillating_flat\"\n"
                 "base_radius_mm = 40\n"
                 "center_distance_mm = 80\n",
         "s.toml:5:12: cam.follower: found \"oscillating_flat\" where the lift is a length; allowed: a "
         "translating follower, or motion.lift_deg or motion.lift_rad"},
        {"cam_translating_with_angle",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_deg = 20\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_flat\"\n"
         "center_distance_mm = 80\n"
         "base_radius_mm = 40\n",
         "s.toml:6:12: cam.follower: found \"translating_flat\" where the lift is an angle; allowed: an "
         "oscillating follower, or motion.lift_mm, motion.lift_in or motion.lift_m"},
        {"cam_offset_too_large", roller + "offset_mm = 60\n",
         "s.toml:9:13: cam.offset_mm: found an offset of 60 mm; allowed: less than 50 mm to either side, the "
         "largest base radius + roller radius"},
        {"cam_offset_too_large_negative", roller + "offset_in = { min = -3, max = -2 }\n",
         "s.toml:9:13: cam.offset_in: found an offset of -2 in; allowed: less than 1.9685 in to either side, "
         "the largest base radius + roller radius"},
        {"cam_arm_too_long",
         arm + "base_radius_mm = 10\n"
               "center_distance_mm = 50\n"
               "arm_length_mm = 75\n",
         "s.toml:8:18: cam.base_radius_mm: found 20 mm for base radius + roller radius; allowed: more than "
         "25 mm, the difference of center distance and arm length"},
        {"cam_arm_too_short",
         arm + "base_radius_mm = { min = 95, max = 200 }\n"
               "center_distance_mm = { min = 20, max = 50 }\n"
               "arm_length_mm = 50\n",
         "s.toml:8:18: cam.base_radius_mm: found 105 mm for base radius + roller radius; allowed: less than "
         "100 mm, the sum of center distance and arm length"},
        {"cam_base_beyond_pivot",
         face + "base_radius_in = 3\n"
                "face_offset_in = 0.5\n",
         "s.toml:8:18: cam.base_radius_in: found 3.5 in for base radius + face offset; allowed: less than "
         "3.14961 in to either side, the center distance"},
        {"cam_face_beyond_pivot",
         face + "base_radius_mm = 10\n"
                "face_offset_mm = -90\n",
         "s.toml:8:18: cam.base_radius_mm: found -80 mm for base radius + face offset; allowed: less than 80 "
         "mm to either side, the center distance"},
        {"cam_limit_needs_cam_first",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "[limits]\n"
         "undercut_margin = 0.1\n",
         "s.toml:4:19: limits.undercut_margin: found a limit of a cam without a cam; allowed: only together "
         "with a [cam] table"},
        {"cam_weight_without_cam",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "objective.face_offset = 0.2\n",
         "s.toml:3:25: objective.face_offset: found 0.2 without a cam; allowed: 0, or a [cam] table with "
         "this dimension"},
        {"cam_weight_negative",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "objective.offset = -1\n",
         "s.toml:3:20: objective.offset: found -1; allowed: a number >= 0"},
        {"cam_weight_of_no_dimension",
         "objective.arm_length = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_roller\"\n"
         "base_radius_mm = 40\n"
         "roller_radius_mm = 10\n",
         "s.toml:1:24: objective.arm_length: found 1 for a dimension that the follower "
         "\"translating_roller\" does not have; allowed: 0"},
        {"cam_weight_of_fixed_only",
         "objective.base_radius = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_roller\"\n"
         "base_radius_mm = 40\n"
         "roller_radius_mm = 10\n",
         "s.toml:1:1: objective: found no weight > 0; allowed: at least one of velocity, acceleration, jerk, "
         "torque, rms_acceleration, rms_jerk, area > 0, or of a dimension of the cam that is a range"},
    };
}

}  // namespace camopt::input

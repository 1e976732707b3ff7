// SPDX-License-Identifier: MIT
// Forces, and the limits on a cam and on its forces.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_forces_parts {

/// Nine lines: [limits] of a cam without forces.
const std::string no_forces =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "base_radius_mm = 40\n"
    "roller_radius_mm = 10\n"
    "[limits]\n";

/// Ten lines: forces on a translating roller.
const std::string forces =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "motion.speed_rpm = 300\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "base_radius_mm = 40\n"
    "roller_radius_mm = 10\n"
    "[forces]\n";

/// Twelve lines: forces on an oscillating roller.
const std::string moments =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_deg = 20\n"
    "motion.speed_rpm = 300\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"oscillating_roller\"\n"
    "roller_radius_mm = 10\n"
    "base_radius_mm = 40\n"
    "center_distance_mm = 80\n"
    "arm_length_mm = 70\n"
    "[forces]\n";

/// Eleven lines: forces of a spring on a cam that turns at 300 rpm.
const std::string spring =
    "objective.jerk = 1\n"
    "motion.type = \"RR\"\n"
    "motion.lift_mm = 10\n"
    "motion.speed_rpm = 300\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "base_radius_mm = 40\n"
    "roller_radius_mm = 10\n"
    "[forces]\n"
    "spring_rate_n_mm = 10\n";
/// Thirteen lines.
const std::string limited = spring + "spring_frequency_hz = 50\n[limits]\n";

}  // namespace broken_forces_parts

std::vector<BrokenScene> broken_forces() {
    using namespace broken_forces_parts;
    return {
        {"forces_without_cam",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "[forces]\n"
         "mass_kg = 1\n",
         "s.toml:3:1: forces: found forces without a cam; allowed: only together with a [cam] table"},
        {"forces_without_speed",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_roller\"\n"
         "base_radius_mm = 40\n"
         "roller_radius_mm = 10\n"
         "[forces]\n"
         "mass_kg = 1\n",
         "s.toml:9:1: forces: found forces without a speed; allowed: only where motion.speed is given"},
        {"forces_key_unknown", forces + "mass_g = 1\n",
         "s.toml:11:1: forces.mass_g: found an unknown key; allowed: mass_kg, mass_lb, inertia_kg_m2, "
         "spring_rate_n_mm, spring_rate_n_m, spring_rate_lbf_in, spring_rate_nm_rad, spring_rate_nm_deg, "
         "preload_n, preload_nm, preload_lbf, preload_lbf_in, damping_n_s_m, damping_nm_s_rad, load_n, "
         "load_nm, load_lbf, load_lbf_in, spring_frequency_hz, spring_frequency_rad_s, "
         "speed_range_rpm, speed_range_rad_s, contact_width_mm, "
         "contact_width_in, contact_width_m, "
         "cam_modulus_gpa, cam_modulus_mpa, cam_modulus_pa, cam_modulus_ksi, follower_modulus_gpa, "
         "follower_modulus_mpa, follower_modulus_pa, follower_modulus_ksi, cam_poisson, follower_poisson; "
         "did you mean 'mass_kg'?"},
        {"forces_unit_missing", forces + "spring_rate = 1\n",
         "s.toml:11:1: forces.spring_rate: found an unknown key; allowed: mass_kg, mass_lb, inertia_kg_m2, "
         "spring_rate_n_mm, spring_rate_n_m, spring_rate_lbf_in, spring_rate_nm_rad, spring_rate_nm_deg, "
         "preload_n, preload_nm, preload_lbf, preload_lbf_in, damping_n_s_m, damping_nm_s_rad, load_n, "
         "load_nm, load_lbf, load_lbf_in, spring_frequency_hz, spring_frequency_rad_s, "
         "speed_range_rpm, speed_range_rad_s, contact_width_mm, "
         "contact_width_in, contact_width_m, "
         "cam_modulus_gpa, cam_modulus_mpa, cam_modulus_pa, cam_modulus_ksi, follower_modulus_gpa, "
         "follower_modulus_mpa, follower_modulus_pa, follower_modulus_ksi, cam_poisson, follower_poisson; "
         "did you mean 'spring_rate_n_mm'?"},
        {"forces_mass_negative", forces + "mass_kg = -1\n",
         "s.toml:11:11: forces.mass_kg: found -1; allowed: a number >= 0"},
        {"forces_mass_and_inertia",
         forces + "mass_kg = 1\n"
                  "inertia_kg_m2 = 1\n",
         "s.toml:12:1: forces.inertia_kg_m2: found together with forces.mass_kg, which means the same; "
         "allowed: "
         "only one of the two"},
        {"forces_spring_twice",
         forces + "spring_rate_n_m = 1\n"
                  "spring_rate_n_mm = 1\n",
         "s.toml:12:1: forces.spring_rate_n_mm: found together with forces.spring_rate_n_m, which means the "
         "same; "
         "allowed: only one of the two"},
        {"forces_inertia_of_translating", forces + "inertia_kg_m2 = 1\n",
         "s.toml:11:1: forces.inertia_kg_m2: found a value in kg m^2 where the follower translates; allowed: "
         "mass_kg or mass_lb"},
        {"forces_mass_of_oscillating", moments + "mass_kg = 1\n",
         "s.toml:13:1: forces.mass_kg: found a value in kg where the follower oscillates; allowed: "
         "inertia_kg_m2"},
        {"forces_spring_of_translating", forces + "spring_rate_nm_deg = 1\n",
         "s.toml:11:1: forces.spring_rate_nm_deg: found a value in N m/deg where the follower translates; "
         "allowed: spring_rate_n_mm or spring_rate_n_m or spring_rate_lbf_in"},
        {"forces_spring_of_oscillating", moments + "spring_rate_n_mm = 1\n",
         "s.toml:13:1: forces.spring_rate_n_mm: found a value in N/mm where the follower oscillates; "
         "allowed: spring_rate_nm_rad or spring_rate_nm_deg"},
        {"forces_preload_of_translating", forces + "preload_nm = 1\n",
         "s.toml:11:1: forces.preload_nm: found a value in N m where the follower translates; allowed: "
         "preload_n or preload_lbf"},
        {"forces_preload_of_oscillating", moments + "preload_n = 1\n",
         "s.toml:13:1: forces.preload_n: found a value in N where the follower oscillates; allowed: "
         "preload_nm or preload_lbf_in"},
        {"forces_preload_infinite", forces + "preload_n = -inf\n",
         "s.toml:11:13: forces.preload_n: found -inf; allowed: a finite number"},
        {"forces_width_zero", forces + "contact_width_mm = 0\n",
         "s.toml:11:20: forces.contact_width_mm: found 0; allowed: a number > 0"},
        {"forces_modulus_zero", forces + "cam_modulus_mpa = 0\n",
         "s.toml:11:19: forces.cam_modulus_mpa: found 0; allowed: a number > 0"},
        {"forces_poisson_half", forces + "follower_poisson = 0.5\n",
         "s.toml:11:20: forces.follower_poisson: found 0.5; allowed: a number >= 0 and < 0.5"},
        {"forces_poisson_negative", forces + "cam_poisson = -0.1\n",
         "s.toml:11:15: forces.cam_poisson: found -0.1; allowed: a number >= 0 and < 0.5"},
        {"limit_pressure_angle_right", no_forces + "pressure_angle_deg = 90\n",
         "s.toml:10:22: limits.pressure_angle_deg: found 90; allowed: a number > 0 and < 90"},
        {"limit_pressure_angle_rad", no_forces + "rise_pressure_angle_rad = 1.6\n",
         "s.toml:10:27: limits.rise_pressure_angle_rad: found 1.6; allowed: a number > 0 and < "
         "1.5707963267948966"},
        {"limit_pressure_angle_zero", no_forces + "return_pressure_angle_deg = 0\n",
         "s.toml:10:29: limits.return_pressure_angle_deg: found 0; allowed: a number > 0 and < 90"},
        {"limit_pressure_angle_twice",
         no_forces + "pressure_angle_deg = 30\n"
                     "pressure_angle_rad = 0.5\n",
         "s.toml:11:1: limits.pressure_angle_rad: found together with limits.pressure_angle_deg, which means "
         "the "
         "same; allowed: only one of the two"},
        {"limit_pressure_angle_range", no_forces + "pressure_angle_deg = { min = 1, max = 2 }\n",
         "s.toml:10:22: limits.pressure_angle_deg: found a table; allowed: a number > 0 and < 90"},
        {"limit_cam_radius_negative", no_forces + "cam_radius_min_in = -1\n",
         "s.toml:10:21: limits.cam_radius_min_in: found -1; allowed: a number >= 0"},
        {"limit_undercut_margin_one", no_forces + "undercut_margin = 1\n",
         "s.toml:10:19: limits.undercut_margin: found 1; allowed: a number >= 0 and < 1"},
        {"limit_undercut_margin_unit", no_forces + "undercut_margin_mm = 1\n",
         "s.toml:10:1: limits.undercut_margin_mm: found an unknown key; allowed: " + known_limit_keys},
        {"limit_concave_on_flat",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_flat\"\n"
         "base_radius_mm = 40\n"
         "[limits]\n"
         "concave_radius_min_mm = 12\n",
         "s.toml:9:25: limits.concave_radius_min_mm: found a concave radius for the follower "
         "\"translating_flat\"; allowed: only with rollers and knife edges: a flat face touches no concave "
         "cam"},
        {"limit_concave_on_face",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_deg = 20\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"oscillating_flat\"\n"
         "center_distance_mm = 80\n"
         "base_radius_mm = 40\n"
         "[limits]\n"
         "concave_radius_min_in = 1\n",
         "s.toml:10:25: limits.concave_radius_min_in: found a concave radius for the follower "
         "\"oscillating_flat\"; allowed: only with rollers and knife edges: a flat face touches no concave "
         "cam"},
        {"limit_contact_force_without_forces", no_forces + "contact_force_min_n = 1\n",
         "s.toml:10:23: limits.contact_force_min_n: found a limit of a force without forces; allowed: only "
         "together with a [forces] table"},
        {"limit_torque_without_forces", no_forces + "torque_max_nm = 1\n",
         "s.toml:10:17: limits.torque_max_nm: found a limit of a force without forces; allowed: only "
         "together with a [forces] table"},
        {"limit_torque_without_cam",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "[limits]\n"
         "torque_max_nm = 1\n",
         "s.toml:4:17: limits.torque_max_nm: found a limit of a cam without a cam; allowed: only together "
         "with a [cam] table"},
        {"limit_moment_without_cam",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "[limits]\n"
         "contact_moment_min_nm = 1\n",
         "s.toml:4:25: limits.contact_moment_min_nm: found a limit of a cam without a cam; allowed: only "
         "together with a [cam] table"},
        {"limit_moment_of_translating",
         forces + "[limits]\n"
                  "contact_moment_min_nm = 1\n",
         "s.toml:12:1: limits.contact_moment_min_nm: found a value in N m where the follower translates; "
         "allowed: contact_force_min_n or contact_force_min_lbf"},
        {"limit_force_of_oscillating",
         moments + "[limits]\n"
                   "contact_force_min_n = 1\n",
         "s.toml:14:1: limits.contact_force_min_n: found a value in N where the follower oscillates; "
         "allowed: contact_moment_min_nm or contact_moment_min_lbf_in"},
        {"limit_force_and_moment",
         moments + "[limits]\n"
                   "contact_moment_min_nm = 1\n"
                   "contact_force_min_n = 1\n",
         "s.toml:15:1: limits.contact_force_min_n: found together with limits.contact_moment_min_nm, which "
         "means "
         "the same; allowed: only one of the two"},
        {"limit_contact_force_negative",
         forces + "[limits]\n"
                  "contact_force_min_n = -1\n",
         "s.toml:12:23: limits.contact_force_min_n: found -1; allowed: a number >= 0"},
        {"limit_torque_zero",
         forces + "[limits]\n"
                  "torque_max_nm = 0\n",
         "s.toml:12:17: limits.torque_max_nm: found 0; allowed: a number > 0"},
        {"limit_hertz_without_width",
         forces + "[limits]\n"
                  "hertz_pressure_max_mpa = 1000\n",
         "s.toml:12:26: limits.hertz_pressure_max_mpa: found a pressure without a contact width; allowed: "
         "only where forces.contact_width is given"},
        {"limit_hertz_of_knife",
         "objective.jerk = 1\n"
         "motion.type = \"DRD\"\n"
         "motion.lift_mm = 10\n"
         "motion.speed_rpm = 300\n"
         "[cam]\n"
         "type = \"disk\"\n"
         "follower = \"translating_knife\"\n"
         "base_radius_mm = 40\n"
         "[forces]\n"
         "contact_width_mm = 5\n"
         "[limits]\n"
         "hertz_pressure_max_gpa = 1\n",
         "s.toml:12:26: limits.hertz_pressure_max_gpa: found a pressure for the follower "
         "\"translating_knife\"; allowed: only with rollers and flat faces: under an edge it is infinite"},
        {"limit_hertz_zero",
         forces + "contact_width_mm = 5\n"
                  "[limits]\n"
                  "hertz_pressure_max_pa = 0\n",
         "s.toml:13:25: limits.hertz_pressure_max_pa: found 0; allowed: a number > 0"},
        {"spring_frequency_zero", forces + "spring_frequency_hz = 0\n",
         "s.toml:11:23: forces.spring_frequency_hz: found 0; allowed: a number > 0"},
        {"spring_frequency_without_spring",
         "objective.jerk = 1\nmotion.type = \"RR\"\nmotion.lift_mm = 10\nmotion.speed_rpm = 300\n[cam]\n"
         "type = \"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = 40\n[forces]\n"
         "spring_frequency_hz = 50\n",
         "s.toml:10:23: forces.spring_frequency_hz: found a natural frequency without a spring; allowed: "
         "only "
         "where forces.spring_rate is above 0"},
        {"spring_frequency_of_rise_alone", forces + "spring_rate_n_mm = 10\nspring_frequency_hz = 50\n",
         "s.toml:12:23: forces.spring_frequency_hz: found a natural frequency with a motion that is no "
         "closed "
         "revolution; allowed: motion type \"RR\" from rest to rest, or a closed program"},
        {"spring_frequency_far_above_speed", spring + "spring_frequency_hz = 9000\n",
         "s.toml:12:23: forces.spring_frequency_hz: found a natural frequency far above the speed of the "
         "cam; "
         "allowed: at most 1000 times the speed"},
        {"limit_harmonic_without_forces", no_forces + "spring_harmonic_um = 20\n",
         "s.toml:10:22: limits.spring_harmonic_um: found a limit of a force without forces; allowed: only "
         "together with a [forces] table"},
        {"limit_harmonic_without_frequency", spring + "[limits]\nspring_harmonic_um = 20\n",
         "s.toml:13:22: limits.spring_harmonic_um: found a limit on harmonics without a natural frequency; "
         "allowed: only where forces.spring_frequency is given"},
        {"limit_harmonic_of_other_unit", limited + "spring_harmonic_deg = 1\n",
         "s.toml:14:23: limits.spring_harmonic_deg: found an amplitude in deg; allowed: a length, as the "
         "lift"},
        {"limit_harmonic_zero", limited + "spring_harmonic_mm = 0\n",
         "s.toml:14:22: limits.spring_harmonic_mm: found 0; allowed: a number > 0"},
        {"limit_harmonic_with_free_knots", limited + "spring_harmonic_um = 20\n[spline]\nknots = \"free\"\n",
         "s.toml:14:22: limits.spring_harmonic_um: found a limit on harmonics with spline.knots = \"free\"; "
         "allowed: fixed knots"},
        {"limit_harmonics_fraction", limited + "spring_harmonics = 2.5\n",
         "s.toml:14:20: limits.spring_harmonics: found 2.5; allowed: integers from 1 to 1000"},
        {"limit_harmonics_reversed", limited + "spring_harmonics = { min = 9, max = 8 }\n",
         "s.toml:14:20: limits.spring_harmonics: found a range from 9 to 8; allowed: min below max"},
        {"limit_harmonics_too_many", limited + "spring_harmonics = { min = 1, max = 90 }\n",
         "s.toml:14:20: limits.spring_harmonics: found harmonics from 1 to 90; allowed: at most 50 harmonics "
         "from 1 to 1000"},
    };
}

}  // namespace camopt::input

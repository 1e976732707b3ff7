// SPDX-License-Identifier: MIT
// Scenes that must be refused, each with its whole message. The file is called s.toml; the laws known are
// cycloidal and modified_sine, the solvers ipopt, nlopt.slsqp and structured.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace camopt::input {

/// The keys of [motion] that only valves have.
inline const std::string valve_keys =
    "duration_deg, duration_rad, duration_crank_deg, checking_height_mm, checking_height_in, "
    "checking_height_m, lash_mm, lash_in, lash_m, rocker_ratio, valve_arm_mm, valve_arm_in, valve_arm_m, "
    "opening_deg, opening_rad, opening_crank_deg, centerline_deg, centerline_rad, centerline_crank_deg, "
    "engine_speed_rpm, engine_speed_rad_s, opening_ramp, closing_ramp";

/// Every key of [limits], as messages list them.
inline const std::string known_limit_keys =
    "velocity, velocity_mm_s, velocity_in_s, velocity_m_s, velocity_deg_s, velocity_rad_s, velocity_mm_deg, "
    "velocity_in_deg, velocity_deg_deg, "
    "acceleration, acceleration_mm_s2, acceleration_in_s2, acceleration_m_s2, acceleration_deg_s2, "
    "acceleration_rad_s2, acceleration_mm_deg2, acceleration_in_deg2, acceleration_deg_deg2, jerk, "
    "jerk_mm_s3, jerk_in_s3, jerk_m_s3, jerk_deg_s3, jerk_rad_s3, jerk_mm_deg3, jerk_in_deg3, jerk_deg_deg3, "
    "pressure_angle_deg, pressure_angle_rad, rise_pressure_angle_deg, rise_pressure_angle_rad, "
    "return_pressure_angle_deg, return_pressure_angle_rad, cam_radius_min_mm, cam_radius_min_in, "
    "cam_radius_min_m, concave_radius_min_mm, concave_radius_min_in, concave_radius_min_m, "
    "undercut_margin, contact_force_min_n, contact_force_min_lbf, contact_moment_min_nm, "
    "contact_moment_min_lbf_in, torque_max_nm, torque_max_lbf_in, hertz_pressure_max_mpa, "
    "hertz_pressure_max_gpa, hertz_pressure_max_pa, hertz_pressure_max_ksi, residual_um, residual_mm, "
    "residual_in, residual_deg, residual_rad, dynamic_contact_force_min_n, dynamic_contact_force_min_nm, "
    "dynamic_contact_force_min_lbf, dynamic_contact_force_min_lbf_in, motor_torque_nm, motor_torque_lbf_in, "
    "motor_torque_rms_nm, motor_torque_rms_lbf_in, motor_speed_rpm, motor_speed_rad_s, spring_harmonic_um, "
    "spring_harmonic_mm, spring_harmonic_in, spring_harmonic_deg, spring_harmonic_rad, motor_curve, "
    "spring_harmonics";

struct BrokenScene {
    std::string name;
    std::string toml;
    std::string message;
    std::vector<std::string> overrides = {};
};

/// How GoogleTest shows a case.
inline void PrintTo(const BrokenScene& broken, std::ostream* out) {
    *out << broken.name;
}

std::vector<BrokenScene> broken_files();
std::vector<BrokenScene> broken_values();
std::vector<BrokenScene> broken_combinations();
std::vector<BrokenScene> broken_programs();
std::vector<BrokenScene> broken_set_points();
std::vector<BrokenScene> broken_cams();
std::vector<BrokenScene> broken_mechanisms();
std::vector<BrokenScene> broken_spatial();
std::vector<BrokenScene> broken_inverse();
std::vector<BrokenScene> broken_forces();
std::vector<BrokenScene> broken_drives();
std::vector<BrokenScene> broken_valves();
std::vector<BrokenScene> broken_drawings();
std::vector<BrokenScene> broken_overrides();

}  // namespace camopt::input

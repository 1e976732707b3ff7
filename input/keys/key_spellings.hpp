// SPDX-License-Identifier: MIT
// The units of quantities, and ranges shared by several keys. Internal to input/.
#pragma once

#include "input/keys/scene_keys.hpp"

namespace camopt::input::spellings {

using camopt::spellings::angle;
using camopt::spellings::cam_angle;
using camopt::spellings::force;
using camopt::spellings::force_or_moment;
using camopt::spellings::length;
using camopt::spellings::moment;
using camopt::spellings::plain;
using camopt::spellings::set_point_acceleration;
using camopt::spellings::set_point_displacement;
using camopt::spellings::set_point_jerk;
using camopt::spellings::set_point_place;
using camopt::spellings::set_point_velocity;

inline constexpr Spelling lift[] = {{"_mm", "mm", units::millimetre},
                                    {"_in", "in", units::inch},
                                    {"_m", "m", 1.0},
                                    {"_deg", "deg", units::degree},
                                    {"_rad", "rad", 1.0}};
inline constexpr Spelling displacement[] = {
    {"", "", 1.0},    {"_mm", "mm", units::millimetre}, {"_in", "in", units::inch},
    {"_m", "m", 1.0}, {"_deg", "deg", units::degree},   {"_rad", "rad", 1.0}};
inline constexpr Spelling ramp_velocity[] = {{"_mm_deg", "mm/deg", units::millimetre / units::degree},
                                             {"_in_deg", "in/deg", units::inch / units::degree},
                                             {"_mm_rad", "mm/rad", units::millimetre},
                                             {"_in_rad", "in/rad", units::inch},
                                             {"_deg_deg", "deg/deg", 1.0}};
/// Where the name of the key is the unit.
inline constexpr Spelling degrees[] = {{"", "deg", units::degree}};
using camopt::spellings::speed;
inline constexpr Spelling mass[] = {{"_kg", "kg", 1.0}, {"_lb", "lb", units::pound}};
inline constexpr Spelling inertia[] = {{"_kg_m2", "kg m^2", 1.0}};
inline constexpr Spelling spring_rate[] = {{"_n_mm", "N/mm", 1.0 / units::millimetre},
                                           {"_n_m", "N/m", 1.0},
                                           {"_lbf_in", "lbf/in", units::pound_force / units::inch},
                                           {"_nm_rad", "N m/rad", 1.0},
                                           {"_nm_deg", "N m/deg", 1.0 / units::degree}};
inline constexpr Spelling train_spring[] = {{"_n_mm", "N/mm", 1.0 / units::millimetre},
                                            {"_n_m", "N/m", 1.0},
                                            {"_lbf_in", "lbf/in", units::pound_force / units::inch},
                                            {"_n_m_rad", "N m/rad", 1.0},
                                            {"_nm_rad", "N m/rad", 1.0}};
inline constexpr Spelling frequency[] = {{"_hz", "Hz", units::turn}, {"_rad_s", "rad/s", 1.0}};
inline constexpr Spelling damper[] = {{"_n_s_m", "N s/m", 1.0}, {"_nm_s_rad", "N m s/rad", 1.0}};
/// Travel of the output a radian of the motor.
inline constexpr Spelling travel_per_turn[] = {{"_mm_per_rev", "mm/rev", units::millimetre / units::turn},
                                               {"_in_per_rev", "in/rev", units::inch / units::turn},
                                               {"_m_per_rev", "m/rev", 1.0 / units::turn},
                                               {"_deg_per_rev", "deg/rev", units::degree / units::turn},
                                               {"_rad_per_rev", "rad/rev", 1.0 / units::turn}};
inline constexpr Spelling modulus[] = {
    {"_gpa", "GPa", 1e9}, {"_mpa", "MPa", 1e6}, {"_pa", "Pa", 1.0}, {"_ksi", "ksi", units::ksi}};

using camopt::spellings::any;
using camopt::spellings::not_negative;
using camopt::spellings::positive;

}  // namespace camopt::input::spellings

namespace camopt::input {

/// What [cam] says of any kind but its type, rows of [forces] and of what [objective] says about a cam.
[[nodiscard]] std::vector<KeyRow> rotation_rows();
[[nodiscard]] std::vector<KeyRow> force_rows();
[[nodiscard]] std::vector<KeyRow> dynamics_rows();
[[nodiscard]] std::vector<KeyRow> drive_rows();
[[nodiscard]] std::vector<KeyRow> dimension_weight_rows();

// Suggestions for terms of other programs: "swing_deg" is lift_deg, a follower "flat" is translating_flat or
// oscillating_flat, a motion "DRDR" is a program. For error messages. Internal to input/.

/// The key of the table that a synonym means, with the written unit; empty if none is known. "swing_deg" in
/// "motion" → "lift_deg".
[[nodiscard]] std::string key_meant(std::string_view table, std::string_view written);

/// "; did you mean …?" for a text that is not a choice of a key; empty if nothing is similar. `path`:
/// "motion.type".
[[nodiscard]] std::string choice_hint(std::string_view path, std::string_view text,
                                      const std::vector<std::string>& choices);

}  // namespace camopt::input

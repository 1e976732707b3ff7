// SPDX-License-Identifier: MIT
// The units of a limit: the suffix of its key, the unit for users, and its SI value. Shared by the reader of
// scene files and scenes written in C++.
#pragma once

#include "core/units.hpp"

#include <string_view>

namespace camopt {

/// One spelling of a quantity: key = name + suffix, SI value = written value · factor.
struct Spelling {
    std::string_view suffix;  ///< "_mm"
    std::string_view unit;    ///< "mm"; empty: dimensionless
    double factor = 1.0;
};

/// Of an angle, or of a derivative of one by time.
[[nodiscard]] constexpr bool is_angle_unit(std::string_view unit) {
    return unit.starts_with("deg") || unit.starts_with("rad");
}

namespace spellings {

inline constexpr Spelling plain[] = {{"", "", 1.0}};
inline constexpr Spelling length[] = {
    {"_mm", "mm", units::millimetre}, {"_in", "in", units::inch}, {"_m", "m", 1.0}};
inline constexpr Spelling angle[] = {{"_deg", "deg", units::degree}, {"_rad", "rad", 1.0}};
inline constexpr Spelling force[] = {{"_n", "N", 1.0}};
inline constexpr Spelling moment[] = {{"_nm", "N m", 1.0}};
inline constexpr Spelling force_or_moment[] = {{"_n", "N", 1.0}, {"_nm", "N m", 1.0}};
inline constexpr Spelling vibration[] = {{"_um", "um", 1e-6},
                                         {"_mm", "mm", units::millimetre},
                                         {"_in", "in", units::inch},
                                         {"_deg", "deg", units::degree},
                                         {"_rad", "rad", 1.0}};
inline constexpr Spelling pressure[] = {{"_mpa", "MPa", 1e6}, {"_gpa", "GPa", 1e9}, {"_pa", "Pa", 1.0}};
// Without a unit: normalised.
inline constexpr Spelling velocity_limit[] = {
    {"", "", 1.0},        {"_mm_s", "mm/s", units::millimetre}, {"_in_s", "in/s", units::inch},
    {"_m_s", "m/s", 1.0}, {"_deg_s", "deg/s", units::degree},   {"_rad_s", "rad/s", 1.0}};
inline constexpr Spelling acceleration_limit[] = {
    {"", "", 1.0},           {"_mm_s2", "mm/s^2", units::millimetre}, {"_in_s2", "in/s^2", units::inch},
    {"_m_s2", "m/s^2", 1.0}, {"_deg_s2", "deg/s^2", units::degree},   {"_rad_s2", "rad/s^2", 1.0}};
inline constexpr Spelling jerk_limit[] = {
    {"", "", 1.0},           {"_mm_s3", "mm/s^3", units::millimetre}, {"_in_s3", "in/s^3", units::inch},
    {"_m_s3", "m/s^3", 1.0}, {"_deg_s3", "deg/s^3", units::degree},   {"_rad_s3", "rad/s^3", 1.0}};

// Of set points: normalised, in time, and by the cam angle.
inline constexpr Spelling set_point_place[] = {
    {"", "", 1.0}, {"_deg", "deg", units::degree}, {"_rad", "rad", 1.0}};
inline constexpr Spelling set_point_displacement[] = {
    {"", "", 1.0},    {"_mm", "mm", units::millimetre}, {"_in", "in", units::inch},
    {"_m", "m", 1.0}, {"_deg", "deg", units::degree},   {"_rad", "rad", 1.0}};
inline constexpr Spelling set_point_velocity[] = {{"", "", 1.0},
                                                  {"_mm_s", "mm/s", units::millimetre},
                                                  {"_in_s", "in/s", units::inch},
                                                  {"_m_s", "m/s", 1.0},
                                                  {"_deg_s", "deg/s", units::degree},
                                                  {"_rad_s", "rad/s", 1.0},
                                                  {"_mm_rad", "mm/rad", units::millimetre},
                                                  {"_in_rad", "in/rad", units::inch},
                                                  {"_m_rad", "m/rad", 1.0},
                                                  {"_mm_deg", "mm/deg", units::millimetre / units::degree},
                                                  {"_deg_deg", "deg/deg", 1.0},
                                                  {"_rad_rad", "rad/rad", 1.0}};
inline constexpr Spelling set_point_acceleration[] = {{"", "", 1.0},
                                                      {"_mm_s2", "mm/s^2", units::millimetre},
                                                      {"_in_s2", "in/s^2", units::inch},
                                                      {"_m_s2", "m/s^2", 1.0},
                                                      {"_deg_s2", "deg/s^2", units::degree},
                                                      {"_rad_s2", "rad/s^2", 1.0},
                                                      {"_mm_rad2", "mm/rad^2", units::millimetre},
                                                      {"_in_rad2", "in/rad^2", units::inch},
                                                      {"_m_rad2", "m/rad^2", 1.0},
                                                      {"_deg_deg2", "deg/deg^2", 1.0 / units::degree},
                                                      {"_rad_rad2", "rad/rad^2", 1.0}};

}  // namespace spellings
}  // namespace camopt

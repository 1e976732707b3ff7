// SPDX-License-Identifier: MIT
// The keys of scene files: ranges of numbers, spellings of a quantity in its units, and one row a key.
#pragma once

#include "core/units.hpp"

namespace camopt {

// The interval allowed for a number of a scene, with its words in error messages. Used by the validation of a
// Scene and by the key table of the scene reader.

/// An interval; bounds without a value are infinite. Numbers that are not finite are never inside.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;

    [[nodiscard]] static constexpr Range above(double low) { return {.low = low, .low_included = false}; }
    [[nodiscard]] static constexpr Range at_least(double low) { return {.low = low}; }
    [[nodiscard]] static constexpr Range between(double low, double high) {
        return {.low = low, .high = high};
    }
    [[nodiscard]] static constexpr Range above_up_to(double low, double high) {
        return {.low = low, .high = high, .low_included = false};
    }

    [[nodiscard]] bool contains(double value) const;

    /// The interval after a change of unit: both bounds times `factor` > 0.
    [[nodiscard]] Range scaled(double factor) const;

    /// "", "> 0", ">= 0", "> 0 and <= 360", "from 2 to 4".
    [[nodiscard]] std::string text() const;

    /// "a number > 0", "an integer from 2 to 4", "a finite number".
    [[nodiscard]] std::string number_text() const;
    [[nodiscard]] std::string integer_text() const;
};

namespace ranges {

inline constexpr Range any = {};
inline constexpr Range positive = {.low = 0.0, .low_included = false};
inline constexpr Range not_negative = {.low = 0.0};

}  // namespace ranges

// The units of a limit: the suffix of its key, the unit for users, and its SI value. Shared by the reader of
// scene files and scenes written in C++.

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

/// Counts by time: "mm/s", "rad/s^2".
[[nodiscard]] constexpr bool is_unit_of_time(std::string_view unit) {
    return unit.find("/s") != std::string_view::npos;
}

namespace spellings {

inline constexpr Spelling plain[] = {{"", "", 1.0}};
inline constexpr Spelling length[] = {
    {"_mm", "mm", units::millimetre}, {"_in", "in", units::inch}, {"_m", "m", 1.0}};
inline constexpr Spelling angle[] = {{"_deg", "deg", units::degree}, {"_rad", "rad", 1.0}};
/// Of the motion: two crank degrees are one of the cam.
inline constexpr Spelling cam_angle[] = {
    {"_deg", "deg", units::degree}, {"_rad", "rad", 1.0}, {"_crank_deg", "crank deg", 0.5 * units::degree}};
inline constexpr Spelling force[] = {{"_n", "N", 1.0}, {"_lbf", "lbf", units::pound_force}};
inline constexpr Spelling moment[] = {{"_nm", "N m", 1.0},
                                      {"_lbf_in", "lbf in", units::pound_force* units::inch}};
inline constexpr Spelling force_or_moment[] = {{"_n", "N", 1.0},
                                               {"_nm", "N m", 1.0},
                                               {"_lbf", "lbf", units::pound_force},
                                               {"_lbf_in", "lbf in", units::pound_force* units::inch}};
inline constexpr Spelling vibration[] = {{"_um", "um", 1e-6},
                                         {"_mm", "mm", units::millimetre},
                                         {"_in", "in", units::inch},
                                         {"_deg", "deg", units::degree},
                                         {"_rad", "rad", 1.0}};
inline constexpr Spelling speed[] = {{"_rpm", "rpm", units::revolution_per_minute}, {"_rad_s", "rad/s", 1.0}};
inline constexpr Spelling pressure[] = {
    {"_mpa", "MPa", 1e6}, {"_gpa", "GPa", 1e9}, {"_pa", "Pa", 1.0}, {"_ksi", "ksi", units::ksi}};
// Without a unit: normalised.
inline constexpr Spelling velocity_limit[] = {{"", "", 1.0},
                                              {"_mm_s", "mm/s", units::millimetre},
                                              {"_in_s", "in/s", units::inch},
                                              {"_m_s", "m/s", 1.0},
                                              {"_deg_s", "deg/s", units::degree},
                                              {"_rad_s", "rad/s", 1.0},
                                              {"_mm_deg", "mm/deg", units::millimetre / units::degree},
                                              {"_in_deg", "in/deg", units::inch / units::degree},
                                              {"_deg_deg", "deg/deg", 1.0}};
inline constexpr Spelling acceleration_limit[] = {
    {"", "", 1.0},
    {"_mm_s2", "mm/s^2", units::millimetre},
    {"_in_s2", "in/s^2", units::inch},
    {"_m_s2", "m/s^2", 1.0},
    {"_deg_s2", "deg/s^2", units::degree},
    {"_rad_s2", "rad/s^2", 1.0},
    {"_mm_deg2", "mm/deg^2", units::millimetre / (units::degree * units::degree)},
    {"_in_deg2", "in/deg^2", units::inch / (units::degree * units::degree)},
    {"_deg_deg2", "deg/deg^2", 1.0 / units::degree}};
inline constexpr double cubic_degree = units::degree * units::degree * units::degree;
inline constexpr Spelling jerk_limit[] = {{"", "", 1.0},
                                          {"_mm_s3", "mm/s^3", units::millimetre},
                                          {"_in_s3", "in/s^3", units::inch},
                                          {"_m_s3", "m/s^3", 1.0},
                                          {"_deg_s3", "deg/s^3", units::degree},
                                          {"_rad_s3", "rad/s^3", 1.0},
                                          {"_mm_deg3", "mm/deg^3", units::millimetre / cubic_degree},
                                          {"_in_deg3", "in/deg^3", units::inch / cubic_degree},
                                          {"_deg_deg3", "deg/deg^3", units::degree / cubic_degree}};

// Of set points: normalised, in time, and by the cam angle.
inline constexpr Spelling set_point_place[] = {{"", "", 1.0},
                                               {"_deg", "deg", units::degree},
                                               {"_rad", "rad", 1.0},
                                               {"_crank_deg", "crank deg", 0.5 * units::degree}};
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
                                                  {"_in_deg", "in/deg", units::inch / units::degree},
                                                  {"_deg_deg", "deg/deg", 1.0},
                                                  {"_rad_rad", "rad/rad", 1.0}};
inline constexpr Spelling set_point_acceleration[] = {
    {"", "", 1.0},
    {"_mm_s2", "mm/s^2", units::millimetre},
    {"_in_s2", "in/s^2", units::inch},
    {"_m_s2", "m/s^2", 1.0},
    {"_deg_s2", "deg/s^2", units::degree},
    {"_rad_s2", "rad/s^2", 1.0},
    {"_mm_rad2", "mm/rad^2", units::millimetre},
    {"_in_rad2", "in/rad^2", units::inch},
    {"_m_rad2", "m/rad^2", 1.0},
    {"_mm_deg2", "mm/deg^2", units::millimetre / (units::degree * units::degree)},
    {"_in_deg2", "in/deg^2", units::inch / (units::degree * units::degree)},
    {"_deg_deg2", "deg/deg^2", 1.0 / units::degree},
    {"_rad_rad2", "rad/rad^2", 1.0}};
inline constexpr Spelling set_point_jerk[] = {{"", "", 1.0},
                                              {"_mm_s3", "mm/s^3", units::millimetre},
                                              {"_in_s3", "in/s^3", units::inch},
                                              {"_m_s3", "m/s^3", 1.0},
                                              {"_deg_s3", "deg/s^3", units::degree},
                                              {"_rad_s3", "rad/s^3", 1.0},
                                              {"_mm_rad3", "mm/rad^3", units::millimetre},
                                              {"_in_rad3", "in/rad^3", units::inch},
                                              {"_m_rad3", "m/rad^3", 1.0},
                                              {"_rad_rad3", "rad/rad^3", 1.0}};

}  // namespace spellings

// One key of a scene file: type, units, range, default, meaning. The rows of the scene itself are in input/,
// those of a kind of cam in its leaf (scene/cam_kind.hpp).

enum class KeyType {
    text,              ///< a string; one of `choices` if there are any
    boolean,           ///< true or false
    integer,           ///< an integer; one of `choices` where there are any
    number,            ///< a finite number
    number_or_range,   ///< a finite number, or a table of two: { min = …, max = … }
    number_or_bounds,  ///< a finite number, or a table of one or two: { min = …, max = … }
    bounds,            ///< such a table
    number_or_points,  ///< a finite number, or an array of pairs [place, number], places ascending
    points,            ///< such an array
    numbers,           ///< an array of finite numbers
    texts,             ///< an array of strings
    table,             ///< a table with its own rows
    tables,            ///< an array of such tables
    text_or_table,     ///< a string, or a table with its own rows
    boolean_or_text,   ///< true, false, or one of `choices`
    options,           ///< a table of any keys with text, boolean or number values
};

/// How this version treats a key of the contract.
enum class Availability {
    now,
    needs_cam,       ///< only together with a [cam] table
    needs_forces,    ///< only together with a [forces] table
    needs_dynamics,  ///< only together with a [dynamics] table
    needs_drive,     ///< only together with a [drive] table
};

struct KeyRow {
    std::string_view table;  ///< "motion", "objective.reference"; empty: top level
    std::string_view name;   ///< without the unit: "lift"
    KeyType type = KeyType::number;
    std::span<const Spelling> spellings;    ///< never empty; exactly one of them may be written
    Range range;                            ///< of numbers and integers, in the unit of the first spelling
    std::vector<std::string_view> choices;  ///< allowed texts (or integers as text)
    std::string_view default_text;          ///< "required" if there is none
    std::string_view meaning;
    Availability availability = Availability::now;
    std::string_view instead_of = {};  ///< another key of the table that excludes it
    /// Only if cam.type is one of these; empty: for any type. Filled from the kinds of cams.
    std::vector<std::string_view> cam_types = {};

    [[nodiscard]] bool is_for(std::string_view type_of_cam) const {
        return cam_types.empty() || std::ranges::find(cam_types, type_of_cam) != cam_types.end();
    }
    /// The types it is for, each between two `quote`s: "disk" or "barrel".
    [[nodiscard]] std::string cam_types_text(char quote) const;
    [[nodiscard]] bool required() const { return default_text == "required"; }
    [[nodiscard]] std::string key(const Spelling& spelling) const;  ///< "lift_mm"
    /// The allowed values in words for an error message, in the unit of the spelling.
    [[nodiscard]] std::string allowed(const Spelling& spelling) const;
    /// The choices as a message lists them: "a", "b" or "c".
    [[nodiscard]] std::string choices_text() const;
};

/// "a", "b" or "c", each in quotes.
[[nodiscard]] std::string quoted_choices(const std::vector<std::string_view>& words);

namespace spellings {

using namespace ranges;

}  // namespace spellings
}  // namespace camopt

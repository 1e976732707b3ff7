// SPDX-License-Identifier: MIT
// SI and radians inside; display units only at the edges.
#pragma once

#include "core/base/standard.hpp"

namespace camopt::units {

inline constexpr double millimetre = 1e-3;                                // m
inline constexpr double inch = 0.0254;                                    // m
inline constexpr double degree = std::numbers::pi / 180.0;                // rad
inline constexpr double turn = 2.0 * std::numbers::pi;                    // rad
inline constexpr double revolution_per_minute = std::numbers::pi / 30.0;  // rad/s
inline constexpr double minute = 60.0;                                    // s
inline constexpr double megapascal = 1e6;                                 // Pa
inline constexpr double pound = 0.45359237;                               // kg
inline constexpr double pound_force = pound * 9.80665;                    // N
inline constexpr double ksi = 1e3 * pound_force / (inch * inch);          // Pa

}  // namespace camopt::units

namespace camopt {

/// The unit of lengths in reports and files.
enum class LengthUnit { millimetre, inch };

[[nodiscard]] constexpr double metres_of(LengthUnit unit) {
    return unit == LengthUnit::inch ? units::inch : units::millimetre;
}
[[nodiscard]] constexpr const char* name_of(LengthUnit unit) {
    return unit == LengthUnit::inch ? "in" : "mm";
}

/// An angle of rad that is one revolution to within the rounding of sums and units.
[[nodiscard]] inline bool is_whole_turn(double angle) {
    constexpr double rounding = 1e-9;  // rad: far above round-off of sums, far below any segment of a motion
    return std::abs(angle - units::turn) < rounding;
}

}  // namespace camopt

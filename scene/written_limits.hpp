// SPDX-License-Identifier: MIT
// Completes the limits of a scene written in C++, as a scene file would give them.
//
// A limit on a peak (PeakLimit) is given by its normalised number, or by the number in a unit:
//     given = normalised · lift · (speed / unit angle)^order / unit,   order 1, 2, 3; by the cam angle
//     (mm/deg^2) without the speed.
// Any other (WrittenLimit) by its SI value. The key, the unit and the other number follow. Without a unit a
// limit of the cam is shown in the manual's: deg, mm, N, N m, MPa.
#pragma once

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// The scene with every key, unit and number of its limits; a complete one is unchanged. Other faults are
/// left to validate(). Throws InputError for two numbers that contradict each other, an invalid unit, and a
/// limit in time without a speed.
[[nodiscard]] Scene with_written_limits(Scene scene);

/// The same of a scene that is to be solved: validated, too.
[[nodiscard]] Scene valid_scene(Scene scene);

/// "limits.acceleration_mm_s2", "limits.motor_torque_nm.max": of a name without its unit. side: "min", "max",
/// or empty for a number.
[[nodiscard]] std::string written_limit_key(std::string_view name, std::string_view suffix,
                                            std::string_view side);
/// The side of a limit on a peak: empty where it holds both.
[[nodiscard]] constexpr std::string_view side_of_key(int side) {
    return side == 0 ? "" : side < 0 ? "min" : "max";
}

/// given / normalised of a limit on the peak of a derivative in this unit; in time the motion has a speed.
[[nodiscard]] double one_normalised_peak(const MotionSpec& motion, int order, const Spelling& spelling);

// Limits on peaks of the motion in units: limits.velocity = millimetres_per_second(300). Those of time need
// motion.speed; lengths where the lift is a length, angles where it is an angle. solve() refuses another
// unit.

struct PeakUnit {
    const char* unit;
    [[nodiscard]] PeakLimit operator()(double number) const { return {0.0, {}, number, unit}; }
};
inline constexpr PeakUnit millimetres_per_second{"mm/s"}, metres_per_second{"m/s"}, inches_per_second{"in/s"},
    degrees_per_second{"deg/s"}, radians_per_second{"rad/s"};
inline constexpr PeakUnit millimetres_per_second_squared{"mm/s^2"}, metres_per_second_squared{"m/s^2"},
    inches_per_second_squared{"in/s^2"}, degrees_per_second_squared{"deg/s^2"},
    radians_per_second_squared{"rad/s^2"};
inline constexpr PeakUnit millimetres_per_second_cubed{"mm/s^3"}, metres_per_second_cubed{"m/s^3"},
    inches_per_second_cubed{"in/s^3"}, degrees_per_second_cubed{"deg/s^3"},
    radians_per_second_cubed{"rad/s^3"};
inline constexpr PeakUnit millimetres_per_degree{"mm/deg"}, millimetres_per_degree_squared{"mm/deg^2"},
    millimetres_per_degree_cubed{"mm/deg^3"};

}  // namespace camopt

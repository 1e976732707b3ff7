// SPDX-License-Identifier: MIT
// Completes the limits of a scene written in C++, as a scene file would give them.
//
// A limit on a peak (PeakLimit) is given by its normalised number, or by the number in a unit:
//     given = normalised · lift · (speed / unit angle)^order / unit,   order 1, 2, 3.
// Any other (WrittenLimit) by its SI value. The key, the unit and the other number follow. Without a unit a
// limit of the cam is shown in the manual's: deg, mm, N, N m, MPa.
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// The scene with every key, unit and number of its limits; a complete one is unchanged. Other faults are
/// left to validate(). Throws InputError for two numbers that contradict each other, an invalid unit, and a
/// limit in time without a speed.
[[nodiscard]] Scene with_written_limits(Scene scene);

// Limits on peaks of the motion in units of time: limits.velocity = millimetres_per_second(300). They need
// motion.speed; lengths where the lift is a length, angles where it is an angle. solve() refuses another
// unit.

[[nodiscard]] inline PeakLimit peak_in(double number, const char* unit) {
    return {0.0, {}, number, unit};
}

[[nodiscard]] inline PeakLimit millimetres_per_second(double number) {
    return peak_in(number, "mm/s");
}
[[nodiscard]] inline PeakLimit metres_per_second(double number) {
    return peak_in(number, "m/s");
}
[[nodiscard]] inline PeakLimit inches_per_second(double number) {
    return peak_in(number, "in/s");
}
[[nodiscard]] inline PeakLimit degrees_per_second(double number) {
    return peak_in(number, "deg/s");
}
[[nodiscard]] inline PeakLimit radians_per_second(double number) {
    return peak_in(number, "rad/s");
}

[[nodiscard]] inline PeakLimit millimetres_per_second_squared(double number) {
    return peak_in(number, "mm/s^2");
}
[[nodiscard]] inline PeakLimit metres_per_second_squared(double number) {
    return peak_in(number, "m/s^2");
}
[[nodiscard]] inline PeakLimit inches_per_second_squared(double number) {
    return peak_in(number, "in/s^2");
}
[[nodiscard]] inline PeakLimit degrees_per_second_squared(double number) {
    return peak_in(number, "deg/s^2");
}
[[nodiscard]] inline PeakLimit radians_per_second_squared(double number) {
    return peak_in(number, "rad/s^2");
}

[[nodiscard]] inline PeakLimit millimetres_per_second_cubed(double number) {
    return peak_in(number, "mm/s^3");
}
[[nodiscard]] inline PeakLimit metres_per_second_cubed(double number) {
    return peak_in(number, "m/s^3");
}
[[nodiscard]] inline PeakLimit inches_per_second_cubed(double number) {
    return peak_in(number, "in/s^3");
}
[[nodiscard]] inline PeakLimit degrees_per_second_cubed(double number) {
    return peak_in(number, "deg/s^3");
}
[[nodiscard]] inline PeakLimit radians_per_second_cubed(double number) {
    return peak_in(number, "rad/s^3");
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Limits on peaks of the motion in units of time: limits.velocity = millimetres_per_second(300). They need
// motion.speed; lengths where the lift is a length, angles where it is an angle. solve() refuses another
// unit.
#pragma once

#include "scene/scene.hpp"

namespace camopt {

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

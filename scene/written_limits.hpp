// SPDX-License-Identifier: MIT
//
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

}  // namespace camopt

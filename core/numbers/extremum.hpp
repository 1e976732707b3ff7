// SPDX-License-Identifier: MIT
// The location and value of a maximum (or minimum) of a function of the cam angle.
#pragma once

namespace camopt {

/// Which one-sided value is meant where a derivative jumps (the jerk of a cubic spline at a breakpoint).
enum class Side { left, right };

/// value: signed value of the function at `at` (x, the cam angle in units of the rise), seen from `side`.
struct Extremum {
    double value = 0.0;
    double at = 0.0;
    Side side = Side::right;
};

}  // namespace camopt

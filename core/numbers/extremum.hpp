// SPDX-License-Identifier: MIT
// A place where a function of the cam angle is largest (or least), and how much it is there.
#pragma once

namespace camopt {

/// Which of two one-sided values is meant where a derivative jumps (the jerk of a cubic spline at a
/// breakpoint).
enum class Side { left, right };

/// value: signed value of the function at `at` (x, the cam angle in units of the rise), seen from `side`.
struct Extremum {
    double value = 0.0;
    double at = 0.0;
    Side side = Side::right;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Extrema of functions of the cam angle: where and how large, one-dimensional searches, and the largest value
// along a motion.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// Which one-sided value is meant where a derivative jumps (the jerk of a cubic spline at a breakpoint).
enum class Side { left, right };

/// value: signed value of the function at `at` (x, the cam angle in units of the rise), seen from `side`.
struct Extremum {
    double value = 0.0;
    double at = 0.0;
    Side side = Side::right;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// An optimum reaches its peaks at many locations, each to the tolerance of a solve, some 1e-9 of the peak:
/// values this close are the same peak, and their order in the last digits is meaningless.
inline constexpr double same_peak = 1e-8;

/// The larger value, at the location of `largest` where both are the same peak.
inline void raise_to(Extremum& largest, const Extremum& found) {
    if (!(found.value > largest.value)) return;
    if (!(largest.value >= found.value - same_peak * std::abs(found.value))) largest = found;
    largest.value = found.value;
}

// One-dimensional searches: the maximum of a function by golden sections, the boundary of a property by
// bisection.
//
// Nothing here allocates or throws; exceptions of the function propagate.

/// The result of golden sections: the interval, the two points inside it and their values.
struct GoldenSection {
    double low = 0.0, high = 0.0;
    double left = 0.0, right = 0.0;
    double left_value = 0.0, right_value = 0.0;

    /// The better of the two points.
    [[nodiscard]] double place() const { return left_value > right_value ? left : right; }
    [[nodiscard]] double value() const { return std::max(left_value, right_value); }
};

/// Narrows [low, high], which contains one maximum of `function`, by a factor of 0.618 per section, until
/// `sections` are done or `enough(GoldenSection)` returns true. The location is accurate to the square root
/// of the function's round-off, its value to round-off. For a minimum search −function.
template <class Function, class Enough>
[[nodiscard]] GoldenSection golden_maximum(const Function& function, double low, double high, int sections,
                                           const Enough& enough) {
    constexpr double golden = 0.6180339887498949;
    GoldenSection at{low, high, high - golden * (high - low), low + golden * (high - low), 0.0, 0.0};
    at.left_value = function(at.left);
    at.right_value = function(at.right);
    for (int k = 0; k < sections && !enough(std::as_const(at)); ++k) {
        if (at.left_value > at.right_value) {
            at.high = at.right;
            at.right = std::exchange(at.left, at.right - golden * (at.right - at.low));
            at.right_value = std::exchange(at.left_value, function(at.left));
        } else {
            at.low = at.left;
            at.left = std::exchange(at.right, at.left + golden * (at.high - at.left));
            at.left_value = std::exchange(at.right_value, function(at.right));
        }
    }
    return at;
}

template <class Function>
[[nodiscard]] GoldenSection golden_maximum(const Function& function, double low, double high, int sections) {
    return golden_maximum(function, low, high, sections, [](const GoldenSection&) { return false; });
}

/// Two numbers between which a property changes.
struct Border {
    double with = 0.0;     ///< it holds here
    double without = 0.0;  ///< and not here
};

/// Bisects the boundary of a property that holds at `with` and not at `without`, until `steps` are done or
/// `enough(Border)` returns true. 60 steps lead to neighbouring doubles from any interval of their magnitude.
template <class Property, class Enough>
[[nodiscard]] Border bisected(const Property& holds, Border border, int steps, const Enough& enough) {
    for (int k = 0; k < steps && !enough(std::as_const(border)); ++k) {
        const double middle = 0.5 * (border.with + border.without);
        (holds(middle) ? border.with : border.without) = middle;
    }
    return border;
}

template <class Property>
[[nodiscard]] Border bisected(const Property& holds, Border border, int steps) {
    return bisected(holds, border, steps, [](const Border&) { return false; });
}

// The largest value of a smooth figure along a motion: samples between its breakpoints, refined where the
// second difference allows a larger value than the best sample. Not an enclosure. A maximum inside a piece is
// accurate to round-off, its location to about 1e-10 of the piece.

/// A figure at x; where the motion jumps, as seen from `side`.
using FigureAlong = std::function<double(double x, Side side)>;

/// breakpoints: ascending, at least two; between neighbours the figure is smooth. NaN (undefined there) is
/// skipped; if it is undefined everywhere: -infinity.
[[nodiscard]] Extremum largest_along(const std::vector<double>& breakpoints, const FigureAlong& figure);

/// The first samples of largest_along, piece by piece: what several figures of one motion share at them can
/// be computed once.
struct SamplePlace {
    double at = 0.0;
    Side side = Side::right;
};
[[nodiscard]] std::vector<SamplePlace> sample_places(const std::vector<double>& breakpoints);
/// The figure at the k-th of them.
using FigureAtSample = std::function<double(std::size_t k)>;
[[nodiscard]] Extremum largest_along(const std::vector<double>& breakpoints, const FigureAlong& figure,
                                     const FigureAtSample& at_sample);

[[nodiscard]] Extremum least_along(const std::vector<double>& breakpoints, const FigureAlong& figure);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Private to profiles/spatial/: the largest value of a function over a motion, piece by piece.
//
// Each piece between breakpoints is scanned; the best place is enclosed by golden sections and, where it lies
// inside the piece, moved to the root of the function's slope by differences, so that not only the value but
// the place too is exact to about 1e-10 of the piece.
#pragma once

#include "core/extremum.hpp"
#include "core/numbers/scalar_search.hpp"
#include "profiles/spatial/follower_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace camopt::spatial_search {

inline constexpr int scan_steps = 400;      ///< a piece is far smoother than this
inline constexpr int golden_sections = 30;  ///< to 1e-6 of two steps; the slope does the rest
inline constexpr double end_share = 1e-12;  ///< ends are looked at from inside the piece

struct Interval {
    double low = 0.0, high = 0.0;
};

/// Newton steps on the slope, both derivatives by fourth-order differences.
template <class Function>
[[nodiscard]] double polished(const Function& function, double place, const Interval& piece) {
    const double step = 1e-3 * (piece.high - piece.low);
    for (int i = 0; i < 3; ++i) {
        if (place - 2.0 * step < piece.low || place + 2.0 * step > piece.high) return place;
        const double f0 = function(place), f1 = function(place + step), f2 = function(place + 2.0 * step);
        const double m1 = function(place - step), m2 = function(place - 2.0 * step);
        const double slope = (8.0 * (f1 - m1) - (f2 - m2)) / (12.0 * step);
        const double bend = (16.0 * (f1 + m1) - (f2 + m2) - 30.0 * f0) / (12.0 * step * step);
        if (!(bend < 0.0)) return place;
        place -= std::clamp(slope / bend, -step, step);
    }
    return std::clamp(place, piece.low, piece.high);
}

/// function(θ) -> double; in constant stretches the first place.
template <class Function>
[[nodiscard]] Extremum largest_along(const FollowerMotion& motion, const Function& function) {
    Extremum best{-std::numeric_limits<double>::infinity(), motion.begin()};
    for (std::size_t k = 1; k < motion.breakpoints.size(); ++k) {
        const double from = motion.breakpoints[k - 1], to = motion.breakpoints[k];
        const double inset = end_share * (to - from);
        const Interval piece{from + inset, to - inset};
        const double step = (piece.high - piece.low) / scan_steps;
        int highest = 0;
        double value = function(piece.low);
        for (int i = 1; i <= scan_steps; ++i)
            if (const double now = function(piece.low + i * step); now > value) {
                value = now;
                highest = i;
            }
        Extremum found{value, piece.low + highest * step};
        if (highest > 0 && highest < scan_steps) {
            const Interval around{found.at - step, found.at + step};
            const double place = polished(
                function, golden_maximum(function, around.low, around.high, golden_sections).place(), piece);
            if (const double refined = function(place); refined >= found.value) found = {refined, place};
        }
        // A piece that only repeats its neighbour's end by rounding does not count.
        if (found.value > best.value) best = found;
    }
    return best;
}

}  // namespace camopt::spatial_search

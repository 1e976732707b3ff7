// SPDX-License-Identifier: MIT
// A motion put together from what was published: control points on knots, laws by name, dwells. Own
// arithmetic in long double (de Boor's algorithm on the published numbers), nothing of the library. Where the
// pieces of the curve are known from memory they are taken in place of its control points.
#pragma once

#include "tests/soak/figures/polynomial.hpp"
#include "tests/soak/run/outcome.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"

#include <array>
#include <string>
#include <vector>

namespace camopt::soak {

/// One smooth part of the motion over x in [begin, end].
struct Piece {
    long double begin = 0, end = 1;
    Polynomial y;     ///< over u = x − begin, in lifts; empty: the law
    std::string law;  ///< of the stretch [law_begin, law_end], from law_from to law_to
    long double law_begin = 0, law_end = 1, law_from = 0, law_to = 0;
    int stretch = 0;  ///< the segment of the program it belongs to; 0 for DRD and RR

    /// y, y', y'', y''' by x; at the ends of the piece as seen from within.
    [[nodiscard]] std::array<long double, 4> at(long double x) const;
};

/// One segment of the motion; DRD and RR have just one.
struct Stretch {
    std::string kind;  ///< "spline", "law", "dwell"
    long double begin = 0, end = 1, from = 0, to = 1;
    int continuity = 0;
    bool free = false;  ///< its displacement is not the scene's
    /// Of splines that join in motion together: what their peaks are measured by. 0: of this one alone.
    long double stroke_angle = 0, stroke_rise = 0;
};

struct Motion {
    std::vector<Piece> pieces;
    std::vector<Stretch> stretches;
    double unit_angle = 1.0;  ///< rad of x = 1
    double lift = 1.0;
    bool exact = false;  ///< of pieces from memory: no digit of it was lost in control points

    [[nodiscard]] std::array<long double, 4> at(long double x) const;
};

/// The motion that was delivered. The outcome has one.
[[nodiscard]] Motion delivered_motion(const SceneNumbers& scene, const Outcome& outcome);

/// The scene's motion made with one law: what a designer would begin with. A free displacement stays.
[[nodiscard]] Motion law_motion(const SceneNumbers& scene, const std::string& law);

}  // namespace camopt::soak

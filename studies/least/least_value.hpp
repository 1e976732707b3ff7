// SPDX-License-Identifier: MIT
// objective.least and objective.largest: how far one number of a scene can go.
//
// For a cap, the values v for which the scene has motions are an interval [v*, ∞); for a least value, such as
// a radius of the cam, one that ends at v*. v* is closed in on by the least common violation t(v) of the
// scene with v in place of its own value (feasible_edge.hpp): t(v) <= 0 where there are motions. Then two
// scenes are solved, at most `least_gap` of v* apart:
//
//     value        beyond v* on the feasible side: its motion is delivered, the best one by the weights;
//     impossible   beyond v* on the other side: infeasible, with a certificate of its own.
//
// Of numbers that are no limits (base radius, preload, spring rate, speed, angle of a segment) the same holds
// where every limit of the scene is known to be monotone in them; elsewhere the range beyond the first edge
// is scanned and nothing is claimed between the values tried.
#pragma once

#include "studies/least/adjustment.hpp"
#include "studies/search/known_solutions.hpp"
#include "studies/search/plan.hpp"

namespace camopt {

/// The number that a scene seeks.
struct SoughtNumber {
    Adjustment change;     ///< its `given`: where the search starts, in the unit of the key
    bool largest = false;  ///< better large
    /// The values for which the scene has motions are an interval without an end on the worse side.
    bool monotone = false;
};

/// None: the scene seeks no number. Throws SceneError for a key that does not name a number of the scene, or
/// one that is sought in the wrong direction; it names those that may be sought.
[[nodiscard]] std::optional<SoughtNumber> sought_number(const Scene& scene);

/// For studies that change weights and caps from solve to solve. Throws InputError for a scene that seeks a
/// number; study: "--surface".
void refuse_sought_number(const Scene& scene, std::string_view study);

/// Solves what the scene asks for: one that seeks a number as above, else as it is. As
/// solve_without_explaining (planned_solve.hpp). Solution::scene has the value found; Solution::least says
/// what is known of it. Infeasible with every value: the solution of the scene without one.
[[nodiscard]] Solution solve_asked(const Scene& scene, const SolveControl& control,
                                   KnownSolutions* known = nullptr, const PlanOptions& options = {});

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Where each classical law lies above the trade-off surface of a scene, and by how much.
//
// Weights here are those of the peaks V, A, J over their references (everything else the scene weighs counts
// 0). A law's loss at weights w is f_law(w) / f_optimum(w) − 1. Its least loss over all weights has a second
// meaning: with θ = f_optimum / f_law there, some motion has all three peaks at θ times the law's or lower,
// and none has them lower still (minimax; exact where the scene is convex). It is found by cutting planes:
// each solve at one w gives a motion, hence a plane above f_optimum; the next w is the best for the planes
// known. The least single peaks are solves with the law's other two peaks as limits. Nothing is interpolated.
#pragma once

#include "studies/compare/comparison.hpp"

namespace camopt {

/// V, A, J in this order wherever three numbers stand.
using PeakTriple = std::array<double, 3>;

struct ClosestApproach {
    PeakTriple weights{};       ///< sum 1
    double loss_percent = 0.0;  ///< at these weights; negative: better than every motion of the spline space
    bool settled = false;       ///< proved least, within 1e-6 of the objective
};

struct LawLoss {
    std::string key, title;
    PeakTriple peaks{};                      ///< normalised, finite
    bool feasible = false;                   ///< satisfies every limit of the scene
    std::optional<double> loss_percent;      ///< at the scene's own weights, of its whole objective
    std::optional<ClosestApproach> closest;  ///< none, too, where a broken limit alone makes it better
    /// The least V at the law's A and J, the least A at its V and J, the least J at its V and A; none where
    /// no motion of the spline space has those two, or a limit in time stands in the way.
    std::array<std::optional<double>, 3> least;
};

struct LawLosses {
    PeakTriple reference{};     ///< of V, A, J
    std::vector<LawLoss> laws;  ///< that fit the scene, meet its conditions, have finite peaks; by least loss
    int solves = 0;
    bool complete = false;  ///< not stopped
};

/// known: peaks of motions that this scene allows, such as the rows of a sweep of its weights: they save
/// solves. Throws as compare() does. Empty where a reference peak is missing or infinite.
[[nodiscard]] LawLosses law_losses(const Scene& scene, const SolveControl& control = {},
                                   std::span<const PeakTriple> known = {});

// A game of three columns: max over u of min over rows of row · u, with u >= 0 and Σ u = 1.
struct GameValue {
    std::array<double, 3> mix{};
    double value = 0.0;
    double bound = 0.0;  ///< no mix has more: from the rows' own mix, whatever was rounded on the way here
};

/// Exact to rounding, by trying every corner: meant for some ten rows, at least one.
[[nodiscard]] GameValue solve_game(std::span<const std::array<double, 3>> rows);

/// Of any number of rows, at least one: over the few that matter, found one by one. To 1e-12 of the value.
[[nodiscard]] GameValue solve_game_by_cuts(std::span<const std::array<double, 3>> rows);

}  // namespace camopt

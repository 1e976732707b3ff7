// SPDX-License-Identifier: MIT
// A scene whose weights or references are far from one, or whose caps force figures far from one on it (a
// velocity little above that of the mean leaves no time for its ramps), brought near one before it is solved:
// tolerances and the gap are absolute where the objective is below 1, so an objective of 1e-9 would be
// optimal from the start, and an interior point needs variables of order one.
//
// Σ w_i P_i / R_i keeps its value when w_i and R_i are divided by the same number, and only changes its unit
// when all w_i are. Both are done by powers of two, so nothing is rounded: the proof of the scaled scene is
// that of the scene, times a power of two. Scenes near one are left as they are, to the last bit.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

class CostScale {
 public:
    /// reference: reference_peaks(scene).
    CostScale(const Scene& scene, const Peaks& reference);

    /// Whether the weights alone leave the objective near one: with the references of a scene that was idle
    /// nothing is to be scaled.
    [[nodiscard]] static bool are_near_one(const Scene& scene, const Peaks& reference);
    /// Nothing to do: solve the scene itself.
    [[nodiscard]] bool is_idle() const { return idle_; }
    /// Objective of the scene / objective of scaled(): a power of two.
    [[nodiscard]] double factor() const { return factor_; }
    /// What to solve in its place.
    [[nodiscard]] const Scene& scaled() const { return scaled_; }
    /// The solution of scaled() becomes that of the scene. The gap is the larger one of the scene's own and
    /// the scaled scene's, so that `optimal` says no less than it does near one.
    void restore(Solution& solution, const Scene& scene, const Peaks& reference) const;

 private:
    /// figures: what to expect, by CostFigure.
    void scale_references(const std::vector<double>& figures, const Peaks& reference);
    void scale_weights(const std::vector<double>& figures, const Peaks& reference);

    Scene scaled_;
    double factor_ = 1.0;
    bool idle_ = true;
};

}  // namespace camopt

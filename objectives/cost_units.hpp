// SPDX-License-Identifier: MIT
// What the objective and its peaks are measured in while a scene is solved. Tolerances and the gap are
// absolute where an objective is below 1, so one of 1e-9 would be optimal from the start, and an interior
// point needs variables of order one. Scenes whose weights or references are far from one, or whose caps
// force figures far from one on it (a velocity little above that of the mean leaves no time for its ramps),
// get other units.
//
// Σ w_i P_i / R_i keeps its value when w_i and R_i are divided by the same number, and only changes its unit
// when all w_i are. Both are done by powers of two, so nothing is rounded: a proof in these units is one of
// the scene, times a power of two (scale_cost, solvers/certificate/scale_cost.hpp).
#pragma once

#include "scene/scene.hpp"

namespace camopt {

struct CostUnits {
    /// By cost_terms(): the unit of a peak's variable / its reference. Empty: all 1.
    std::vector<double> peaks;
    double cost = 1.0;  ///< objective of the scene / cost of its model

    [[nodiscard]] double of_peak(std::size_t term) const { return peaks.empty() ? 1.0 : peaks[term]; }
    /// Those of a scene near one.
    [[nodiscard]] bool are_its_own() const { return peaks.empty() && cost == 1.0; }
};

/// reference: reference_peaks(scene).
[[nodiscard]] CostUnits cost_units(const Scene& scene, const Peaks& reference);

}  // namespace camopt

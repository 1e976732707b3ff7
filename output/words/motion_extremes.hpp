// SPDX-License-Identifier: MIT
// How far the delivered motion goes to either side: the signed extremes of its derivatives, and where it
// leaves the range of a stroke.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// The peak of a derivative with its sign, and the largest value of the other sign: `value` in lifts and
/// units of x. A peak without value (an impulse) is infinite.
struct SignedPeaks {
    Extremum largest;
    std::optional<Extremum> opposite;  ///< none: the derivative keeps its sign
};

/// order 1 … 3. For a solution with a motion. The peak is exact (Solution::motion_peaks), the opposite one
/// comes from core/numbers/sampled_maximum.hpp.
[[nodiscard]] SignedPeaks signed_peaks(const Solution& solution, int order);

/// Of a stroke (rise, rise and return, spline segment of a program) that leaves the range low … high between
/// the displacements at its ends, lifts.
struct Excursion {
    double low = 0.0, high = 1.0;
    int segment = -1;     ///< of a program
    Extremum farthest{};  ///< y there
    double beyond = 0.0;  ///< > 0: how far outside

    [[nodiscard]] bool below() const { return farthest.value < low; }
};
[[nodiscard]] std::vector<Excursion> excursions(const Solution& solution);

/// "The follower goes 3.2 mm below its start at 212 deg." One sentence each.
[[nodiscard]] std::vector<std::string> excursion_sentences(const Solution& solution);

}  // namespace camopt

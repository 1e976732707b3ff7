// SPDX-License-Identifier: MIT
// Where the limits of a scene stand in diagrams over the cam angle.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <vector>

namespace camopt {

/// A limit that holds from x = begin to end only.
struct LimitSpan {
    double begin = 0.0, end = 0.0, normalised = 0.0;
};

/// A limit on the magnitude of the pressure angle over a stretch of the cam, rad.
struct PressureLimit {
    double begin = 0.0, end = 0.0;  ///< θ
    double limit = 0.0;
};

/// The limit on the peak of derivative `order`, 1 … 3; none.
[[nodiscard]] const std::optional<PeakLimit>& peak_limit_of(const LimitSpec& limits, int order);

/// Where a normalised limit on that derivative stands over each spline segment of a program, in the motion's
/// own units. Empty where it is the same over the whole motion.
[[nodiscard]] std::vector<LimitSpan> segment_limits(const Solution& solution, const PeakLimit& limit,
                                                    int order);

/// Rise and return may have limits of their own; where the follower rests the least of all holds. Pieces
/// between the motion's breakpoints are told apart by what the follower does over them.
[[nodiscard]] std::vector<PressureLimit> pressure_spans(const Scene& scene, const Motion& motion);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// What no motion can satisfy, spline or not: from the smallest cam of each stroke
// (motions/bounds/smallest_cam.hpp) and the limit of any curve (motions/bounds/any_curve_limit.hpp).
//
// A stroke is a stretch of the motion between two displacements that the scene gives: the rise, the return,
// and of a program every segment with a given displacement at both ends. Each is held against the pressure
// angle of its direction.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Of all strokes the one that needs the largest prime radius. None unless the cam pushes a roller or an edge
/// straight (CamMechanism::pushed_offset) and the pressure angle of some stroke is limited.
[[nodiscard]] std::optional<SmallestCamReport> smallest_of_any_motion(const Scene& scene,
                                                                      const DrivenMechanism& cam);

/// The keys of the limits that no motion keeps, each by itself. A range of dimensions counts with its most
/// favourable end.
[[nodiscard]] std::vector<std::string> kept_by_no_motion(const Scene& scene);

/// The limit that no curve can pass, for the objective of a scene; reference: what the peaks are divided by.
/// None for programs, and where the objective holds more than peaks. Some milliseconds.
[[nodiscard]] std::optional<LimitCurve> limit_curve(const Scene& scene, const Peaks& reference);

/// AnyCurveLimit::breakpoints of that limit; empty: no curve reaches it.
[[nodiscard]] std::vector<double> limit_switches(const Scene& scene, const Peaks& reference);

/// The caps on peaks cannot be kept together by any motion.
[[nodiscard]] bool no_motion_keeps_all_caps(const Scene& scene);

}  // namespace camopt

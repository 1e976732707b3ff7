// SPDX-License-Identifier: MIT
// The parts of result.json that a Solution fills. Private to output/.
#pragma once

#include "output/json/json_text.hpp"
#include "splines/motion_chain.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>

namespace camopt {

/// The delivered motion, complete: its splines as the polynomials they are, and how the parts are chained;
/// input/result/ reads it back. Parts that share a spline name the same curve.
[[nodiscard]] Json motion_json(const MotionChain& motion);

/// Breakpoints, knots and control points over x; null where there is none.
[[nodiscard]] Json spline_json(const std::optional<SplineCurve>& curve);

[[nodiscard]] Json peaks_json(const std::optional<Peaks>& peaks);

/// One entry a segment; null for a motion that is no program, and where there is no motion.
[[nodiscard]] Json segments_json(const Solution& solution);

// "dynamics" of result.json.

/// null where the scene has no train, or there is no motion.
[[nodiscard]] Json train_json(const Solution& solution);

// The entries of result.json that only a scene with a cam has. Private to output/.

/// {"base_radius_mm": 40.0, …, "prime_radius_mm": 50.0}, {"lever_angle_deg": -10.0, …}; empty without a cam,
/// null for what is free and was not delivered.
[[nodiscard]] Json dimensions_json(const Solution& solution);

/// The figures of the delivered cam; null where there is none.
[[nodiscard]] Json cam_json(const Solution& solution);

// The verdict of a solve, alike in every file that holds one.

/// {lower, gap, proof}: what the objective is proved to be no less than, and how.
[[nodiscard]] Json bound_json(const Certificate& certificate);

/// Adds verdict, reason, objective and bound.
void add_verdict(Json& json, const Certificate& certificate);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// How camopt writes JSON: keys in the given order, lists of plain values on one line, and null for every
// number that is not finite. Private to report/: the JSON library stays out of the public headers.
#pragma once

#include "studies/delivered/solution.hpp"

#include <nlohmann/json.hpp>

namespace camopt {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json number_json(double value);
[[nodiscard]] Json number_json(const std::optional<double>& value);
/// null for text that says nothing.
[[nodiscard]] Json words_json(std::string_view text);
[[nodiscard]] Json extremum_json(const Extremum& extremum);
[[nodiscard]] Json numbers_json(std::span<const double> values);
[[nodiscard]] Json numbers_json(const Eigen::VectorXd& values);

/// Indented by two spaces; a list or object of plain values stands on one line. Ends in a line feed. Numbers
/// read back as the same double; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& value);

// The parts of result.json that a Solution fills. Private to report/.

/// The delivered motion, complete: its splines as the polynomials they are, and how the parts are chained;
/// input/result/ reads it back. Parts that share a spline name the same curve.
[[nodiscard]] Json motion_json(const MotionChain& motion);

/// NAME.check.json of an exported file: its claims, and the design that they compare it with. What
/// scripts/verify-export reads (docs/certificates.md).
[[nodiscard]] std::string export_check_json(const Solution& solution, Json claims);

/// Breakpoints, knots and control points over x; null where there is none.
[[nodiscard]] Json spline_json(const std::optional<SplineCurve>& curve);

[[nodiscard]] Json peaks_json(const std::optional<Peaks>& peaks);

/// One entry a segment; null for a motion that is no program, and where there is no motion.
[[nodiscard]] Json segments_json(const Solution& solution);

// "dynamics" of result.json.

/// In Hz.
[[nodiscard]] Json frequencies_json(const std::vector<double>& frequencies);

/// null where the scene has no train, or there is no motion.
[[nodiscard]] Json train_json(const Solution& solution);
/// What an engine builder asks of a valve lobe; the solution has a motion.
[[nodiscard]] Json valve_json(const Solution& solution);
/// Harmonics of the lift and the spring. The solution has them.
[[nodiscard]] Json surge_json(const Solution& solution);

// The entries of result.json that only a scene with a cam has. Private to report/.

/// {"base_radius_mm": 40.0, …, "prime_radius_mm": 50.0}, {"lever_angle_deg": -10.0, …}; empty without a cam,
/// null for what is free and was not delivered.
[[nodiscard]] Json dimensions_json(const Solution& solution);

/// The figures of the delivered cam; null where there is none.
[[nodiscard]] Json cam_json(const Solution& solution);

// Figures of a document (report/document/document.hpp), each by its key.
struct Figure;
struct Table;
[[nodiscard]] Json figures_json(std::span<const Figure> figures);
/// A list of its rows, each an object.
[[nodiscard]] Json rows_json(const Table& table);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Scenes and reference figures the cases share.
#pragma once

#include "benchmarks/stability/stability_row.hpp"

#include <string>
#include <string_view>

namespace camopt::stability {

/// Weights 0.4, 0.4, 0.2 over 1.76, 5.53, 69; the structured solver on `states`.
[[nodiscard]] Scene study_scene(MotionType type, int degree, int segments);

/// Peaks given as numbers.
[[nodiscard]] Reference numeric_reference(double velocity, double acceleration, double jerk);

/// 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69.
[[nodiscard]] double study_objective(double velocity, double acceleration, double jerk);

/// From the text of a scene file, as a user writes it.
[[nodiscard]] Scene scene_of_text(const std::string& toml);
/// A file of scenes/.
[[nodiscard]] Scene scene_of_file(const std::string& name);

/// No curve whatever is better than this in study_scene (DRD), to ten digits.
inline constexpr double any_curve_limit_of_study = 0.9371963699;

/// The optimum of study_scene, where one is known from elsewhere (a fraction, or a linear program solved by
/// HiGHS; of many quintic segments only an interval is); else proved_optimum.
[[nodiscard]] Expectation known_optimum(MotionType type, int degree, int segments);

/// The objective of a scene solved by the structured solver at tolerance 1e-11 and proved to gap 1e-8 or
/// better, as the interval that the proof leaves. Throws ModelError where it is not proved.
[[nodiscard]] Expectation proved_optimum(Scene scene, std::string source);

/// A case whose run sets group and name.
[[nodiscard]] StabilityCase make_case(std::string group, std::string name, bool quick,
                                      std::function<StabilityRow()> run);

/// "1e-09"
[[nodiscard]] std::string text_of(double value);

}  // namespace camopt::stability

// SPDX-License-Identifier: MIT
// Scenes and reference figures the cases share.
#pragma once

#include "scene/scene.hpp"
#include "tests/soak/stability/stability_row.hpp"

#include <string>

namespace camopt::stability {

/// Weights 0.4, 0.4, 0.2 over 1.76, 5.53, 69; the structured solver on `states`.
[[nodiscard]] SceneText study_scene(MotionType type, int degree, int segments);
/// The same weights and references for another scene.
[[nodiscard]] SceneText study_scene(const std::string& toml, std::string_view backend = "structured");

struct PeakNumbers {
    double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
};
void set_weights(SceneText& scene, const PeakNumbers& weights);
/// What the peaks are divided by.
void set_reference(SceneText& scene, const PeakNumbers& peaks);
void set_solver(SceneText& scene, std::string_view name);
void set_tie_break(SceneText& scene, TieBreak ties);

/// 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69.
[[nodiscard]] double study_objective(double velocity, double acceleration, double jerk);

/// As the library reads it.
[[nodiscard]] Scene scene_of_text(const std::string& toml);
[[nodiscard]] inline Scene scene_of(const SceneText& scene) {
    return scene_of_text(scene.text());
}
/// A file of scenes/.
[[nodiscard]] std::string text_of_file(const std::string& name);
[[nodiscard]] inline Scene scene_of_file(const std::string& name) {
    return scene_of_text(text_of_file(name));
}

/// No curve is better than this in study_scene (DRD), to ten digits.
inline constexpr double any_curve_limit_of_study = 0.9371963699;

/// The optimum of study_scene, where one is known from elsewhere (a fraction, or a linear program solved by
/// HiGHS; of many quintic segments only an interval is); else proved_optimum.
[[nodiscard]] Expectation known_optimum(MotionType type, int degree, int segments);

/// The objective of a scene solved by the structured solver at tolerance 1e-11 and proved to gap 1e-8 or
/// better, as the interval that the proof leaves. Throws ModelError where it is not proved.
[[nodiscard]] Expectation proved_optimum(SceneText scene, std::string source);

/// A case whose run sets group and name.
[[nodiscard]] StabilityCase make_case(std::string group, std::string name, bool quick,
                                      std::function<StabilityRow()> run);

/// "1e-09"
[[nodiscard]] std::string text_of(double value);

}  // namespace camopt::stability

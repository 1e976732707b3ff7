// SPDX-License-Identifier: MIT
#include "output/page/page_laws.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/number_text.hpp"
#include "studies/compare/law_motion.hpp"

#include <array>

namespace camopt {

namespace {

constexpr std::array<const char*, 4> curve_keys = {"displacement", "velocity", "acceleration", "jerk"};

std::vector<LawStroke> strokes_for(const Solution& solution) {
    if (solution.scene.motion.type != MotionType::program) return strokes_of(solution.scene.motion);
    const CamModel model = scene_model(solution.scene, DesignKind::states, solution.reference_peaks);
    return strokes_of(solution.scene, model, solution.motion.get());
}

Json law_curves(const Motion& law, const Solution& solution, const PageRows& rows) {
    const ShownUnits units = shown_units(solution.scene);
    Json curves = Json::object();
    for (std::size_t order = 0; order < curve_keys.size(); ++order)
        curves[curve_keys[order]] = values_along(law, rows, units.motion[order].first);
    return curves;
}

}  // namespace

std::string page_laws(const Solution& solution, std::span<const std::string> keys) {
    Json all = Json::array();
    if (solution.motion && !keys.empty()) {
        const PageRows rows = page_rows(solution);
        const std::vector<LawStroke> strokes = strokes_for(solution);
        const bool closed = solution.scene.motion.type == MotionType::program && solution.scene.motion.closed;
        for (const std::string& key : keys) {
            const LawMotion placed = law_motion(strokes, closed, make_law(key));
            Json law = {{"key", key}, {"title", words_of(key)}, {"misfit", words_json(placed.misfit)}};
            law["curves"] = placed.motion ? law_curves(*placed.motion, solution, rows) : Json(nullptr);
            law["peaks"] = {{"velocity", rounded_json(placed.peaks.velocity.value)},
                            {"acceleration", rounded_json(placed.peaks.acceleration.value)},
                            {"jerk", rounded_json(placed.peaks.jerk.value)}};
            all.push_back(std::move(law));
        }
    }
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "tests/input/scene_key_cases.hpp"

#include <numbers>

namespace camopt::input {
namespace drawing_key_cases {

constexpr double pi = std::numbers::pi;

/// A disk cam with a bore, without one of the quantities of its keyway.
std::string drawn_cam(const std::string& except = "") {
    std::string toml =
        "motion.lift_mm = 20\ncam.type = \"disk\"\ncam.follower = \"translating_knife\"\n"
        "cam.base_radius_mm = 400\n";
    const auto add = [&](const std::string& quantity, const std::string& line) {
        if (quantity != except) toml += "drawing." + line + "\n";
    };
    add("bore", "bore_mm = 600");
    add("width", "keyway.width_mm = 8");
    add("depth", "keyway.depth_mm = 3.3");
    return toml;
}

std::string grooved_cam() {
    return "motion.lift_mm = 20\ncam.type = \"disk\"\ncam.follower = \"translating_roller\"\ncam.form = "
           "\"grooved\"\n"
           "cam.base_radius_mm = 400\ncam.roller_radius_mm = 20\n";
}

const Keyway& keyway_of(const Scene& scene) {
    return scene.drawing.value().keyway.value();
}

double is_x(const std::string& text) {
    return text == "x" ? 1.0 : 0.0;
}

}  // namespace drawing_key_cases

std::vector<KeyCase> drawing_cases() {
    using namespace drawing_key_cases;
    const auto bore = [](const Scene& s) { return s.drawing.value().bore.value(); };
    const auto thickness = [](const Scene& s) { return s.drawing.value().thickness.value(); };
    const auto groove = [](const Scene& s) { return s.drawing.value().groove_depth.value(); };
    const auto density = [](const Scene& s) { return s.drawing.value().density.value(); };
    const auto datum = [](const Scene& s) { return s.drawing.value().datum; };
    const auto width = [](const Scene& s) { return keyway_of(s).width; };
    const auto depth = [](const Scene& s) { return keyway_of(s).depth; };
    const auto at = [](const Scene& s) { return keyway_of(s).at; };
    const auto title = [](std::string TitleBlock::*member) {
        return [member](const Scene& s) { return is_x(s.drawing.value().title_block.*member); };
    };
    return {
        {"drawing.bore_mm", "25", 0.025, bore, drawn_cam("bore")},
        {"drawing.bore_in", "1", 0.0254, bore, drawn_cam("bore")},
        {"drawing.bore_m", "0.03", 0.03, bore, drawn_cam("bore")},
        {"drawing.density_kg_m3", "7850", 7850, density, drawn_cam()},
        {"drawing.density_g_cm3", "7.85", 7850, density, drawn_cam()},
        {"drawing.density_lb_in3", "1", 27679.904710203125, density, drawn_cam()},
        {"drawing.projection", "\"third_angle\"", 1,
         [](const Scene& s) { return s.drawing.value().projection == Projection::third_angle ? 1.0 : 0.0; },
         drawn_cam()},
        {"drawing.thickness_mm", "20", 0.02, thickness, drawn_cam()},
        {"drawing.thickness_in", "0.5", 0.0127, thickness, drawn_cam()},
        {"drawing.thickness_m", "0.03", 0.03, thickness, drawn_cam()},
        {"drawing.groove_depth_mm", "8", 0.008, groove, grooved_cam()},
        {"drawing.groove_depth_in", "0.25", 0.00635, groove, grooved_cam()},
        {"drawing.groove_depth_m", "0.01", 0.01, groove, grooved_cam()},
        {"drawing.datum_deg", "-90", -pi / 2, datum, drawn_cam()},
        {"drawing.datum_rad", "0.5", 0.5, datum, drawn_cam()},
        {"drawing.keyway.width_mm", "10", 0.01, width, drawn_cam("width")},
        {"drawing.keyway.width_in", "0.5", 0.0127, width, drawn_cam("width")},
        {"drawing.keyway.width_m", "0.01", 0.01, width, drawn_cam("width")},
        {"drawing.keyway.depth_mm", "4.3", 0.0043, depth, drawn_cam("depth")},
        {"drawing.keyway.depth_in", "0.25", 0.00635, depth, drawn_cam("depth")},
        {"drawing.keyway.depth_m", "0.004", 0.004, depth, drawn_cam("depth")},
        {"drawing.keyway.at_deg", "180", pi, at, drawn_cam()},
        {"drawing.keyway.at_rad", "-1", -1, at, drawn_cam()},
        {"drawing.title_block.part", "\"x\"", 1, title(&TitleBlock::part), drawn_cam()},
        {"drawing.title_block.material", "\"x\"", 1, title(&TitleBlock::material), drawn_cam()},
        {"drawing.title_block.tolerance", "\"x\"", 1, title(&TitleBlock::tolerance), drawn_cam()},
        {"drawing.title_block.drawn_by", "\"x\"", 1, title(&TitleBlock::drawn_by), drawn_cam()},
        {"drawing.title_block.organisation", "\"x\"", 1, title(&TitleBlock::organisation), drawn_cam()},
        {"drawing.title_block.number", "\"x\"", 1, title(&TitleBlock::number), drawn_cam()},
        {"drawing.title_block.revision", "\"x\"", 1, title(&TitleBlock::revision), drawn_cam()},
        {"drawing.title_block.date", "\"x\"", 1, title(&TitleBlock::date), drawn_cam()},
        {"drawing.title_block.surface_finish", "\"x\"", 1, title(&TitleBlock::surface_finish), drawn_cam()},
        {"drawing.title_block.profile_tolerance", "\"x\"", 1, title(&TitleBlock::profile_tolerance),
         drawn_cam()},
        {"drawing.title_block.bore_fit", "\"x\"", 1, title(&TitleBlock::bore_fit), drawn_cam()},
        {"drawing.title_block.keyway_tolerance", "\"x\"", 1, title(&TitleBlock::keyway_tolerance),
         drawn_cam()},
    };
}

}  // namespace camopt::input

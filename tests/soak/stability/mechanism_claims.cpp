// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "report/drawing/profile_shape.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/inverse/inverse_forward.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/spatial_forward_check.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <cmath>

namespace camopt::stability {

namespace {

using units::degree, units::millimetre;

constexpr double micrometre = 1e-6;

Scene mechanism_scene(const std::string& file) {
    Scene scene = scene_of_file(file);
    scene.solver.starts = 1;
    return scene;
}

StabilityRow drawing_of_disk(const std::string& file) {
    const Solution solution = solve(scene_of_file(file));
    return figure_row("arcs from the cam, µm", cam_dxf(solution).deviation / micrometre,
                      at_most(1.0, "docs/cams.md: within 1 µm"));
}

StabilityRow drawing_of_mechanism(const std::string& file) {
    return figure_row("arcs from the cam, µm", cam_dxf(solve(mechanism_scene(file))).deviation / micrometre,
                      at_most(1.0, "docs/cams.md: within 1 µm"));
}

StabilityRow tappet_on_points() {
    const Solution solution = solve(mechanism_scene("tappet_75.toml"));
    return figure_row("deviation, mm", check_cam(solution, 6000).deviation / millimetre,
                      at_most(1e-6, "docs/papers/003.md: 6000 points"));
}

StabilityRow drum_on_points(const std::string& file, double unit, const std::string& quantity) {
    const Solution solution = solve(mechanism_scene(file));
    return figure_row(quantity, check_flanks(solution, 1601).deviation / unit,
                      at_most(1e-8, "docs/papers: 1601 points a section"));
}

StabilityRow guide_on_points() {
    const Solution solution = solve(mechanism_scene("inverse_feeder.toml"));
    return figure_row("deviation / lift", check_guide(solution, 2000).relative,
                      at_most(1e-9, "docs/papers/000.md"));
}

/// The slide's pressure angle is a cap on its velocity: the same optimum, by a scene without a cam.
StabilityRow slide_as_a_cap() {
    SceneText scene = SceneText::parse(text_of_file("cylinder_slide.toml"));
    scene.at("solver").set("starts", "1");
    const soak::SceneNumbers numbers = soak::numbers_of(scene);
    const double radius =
        (scene.number("cam", "cylinder_radius_mm", 0.0) - scene.number("cam", "roller_length_mm", 0.0)) *
        millimetre;
    const double slope = radius * std::tan(numbers.limits.at("pressure_angle"));
    SceneText capped = scene;
    capped.erase("cam");
    capped.erase("limits");
    capped.at("limits").set("velocity", slope * numbers.rise / numbers.lift);
    Expectation expected = proved_optimum(capped, "the scene with a cap on the velocity instead, proved");
    expected.accuracy = 1e-7;
    return solved_row(scene, expected);
}

/// docs/papers/002.md: printed with four digits, proved.
StabilityRow paper_cup_peak() {
    const Solution solution = solve(mechanism_scene("barrel_paper_cup.toml"));
    Expectation expected = exactly(5.358, "docs/papers/002.md", 0.0);
    expected.digits = 0.5001e-3 / 5.358;
    StabilityRow row = figure_row("A, proved", solution.peaks.acceleration.value, expected);
    row.verdict = name_of(solution.certificate.verdict);
    if (solution.certificate.verdict != Verdict::optimal) {
        row.judgement = Judgement::wrong;
        row.why = "the manual says proved optimal";
    }
    return row;
}

}  // namespace

std::vector<StabilityCase> mechanism_claims() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const std::string& name, bool quick, std::function<StabilityRow()> run) {
        cases.push_back(make_case("claims", name, quick, std::move(run)));
    };
    for (const char* file : {"cam_roller.toml", "cam_flat.toml", "cam_arm_roller.toml"})
        add(std::string(file) + ": profile.dxf", false, [file] { return drawing_of_disk(file); });
    for (const char* file : {"tappet_75.toml", "inverse_feeder.toml"})
        add(std::string(file) + ": profile.dxf", false, [file] { return drawing_of_mechanism(file); });
    add("tappet_75.toml: forward check", false, tappet_on_points);
    for (const char* file : {"barrel_paper_cup.toml", "ocrf_indexing.toml"})
        add(std::string(file) + ": forward check", false,
            [file] { return drum_on_points(file, 1.0, "deviation, rad"); });
    add("cylinder_slide.toml: forward check", false,
        [] { return drum_on_points("cylinder_slide.toml", millimetre, "deviation, mm"); });
    add("inverse_feeder.toml: forward check", false, guide_on_points);
    add("cylinder_slide.toml", true, slide_as_a_cap);
    add("barrel_paper_cup.toml", true, paper_cup_peak);
    return cases;
}

}  // namespace camopt::stability

// SPDX-License-Identifier: MIT
#include "tests/soak/figures/cam_extremes.hpp"
#include "tests/soak/figures/law.hpp"
#include "tests/soak/scenes/drawn_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt::soak {

namespace {

/// A fixed number, or a range about it.
void set_dimension(Draw& draw, SceneTable& cam, const std::string& name, double value) {
    const std::string key = name + draw.one_of<std::string>({"_mm", "_m", "_in"});
    const double written = value / unit_of(key);
    const double spread = std::abs(written) * draw.between(0.05, 0.4);
    cam.set(key, draw.chance(0.8) ? number_text(written)
                                  : fmt::format("{{ min = {}, max = {} }}", number_text(written - spread),
                                                number_text(written + spread)));
}

void draw_dimensions(Draw& draw, SceneText& scene, const std::string& follower) {
    const SceneNumbers numbers = numbers_of(scene);
    const double first = numbers.is_program() ? numbers.segments.front().angle : numbers.rise;
    SceneTable& cam = scene.at("cam");
    cam.set("type", quoted("disk"));
    cam.set("follower", quoted(follower));
    if (draw.chance(0.5)) cam.set("rotation", quoted(draw.chance(0.5) ? "clockwise" : "counterclockwise"));
    if (!numbers.swings) {
        // A flat face is undercut where base + s + s'' < 0.
        const double steep =
            numbers.lift * (follower == "translating_flat" ? 6.0 / (first * first) : 2.0 / first);
        const double base = std::max(0.3 * numbers.lift, steep * draw.between(0.6, 2.2));
        set_dimension(draw, cam, "base_radius", base);
        if (numbers_of(scene).rolls())
            set_dimension(draw, cam, "roller_radius", base * draw.between(0.1, 0.6));
        if (follower != "translating_flat" && draw.chance(0.5))
            set_dimension(draw, cam, "offset", base * draw.between(-0.4, 0.4));
        if (follower == "translating_flat" && draw.chance(0.3))
            cam.set("face_half_width_m", numbers.lift / first * draw.between(1.5, 3.0));
        return;
    }
    const double center = draw.sized(0.05, 0.3);
    set_dimension(draw, cam, "center_distance", center);
    if (follower == "oscillating_flat") {
        const double base = center * draw.between(0.3, 0.6);
        set_dimension(draw, cam, "base_radius", base);
        if (draw.chance(0.6)) set_dimension(draw, cam, "face_offset", base * draw.between(-0.3, 0.3));
        return;
    }
    const double prime = center * draw.between(0.35, 0.7);
    const double roller = prime * draw.between(0.1, 0.35);
    set_dimension(draw, cam, "base_radius", prime - roller);
    set_dimension(draw, cam, "roller_radius", roller);
    set_dimension(draw, cam, "arm_length", center * draw.between(0.75, 1.1));
}

void draw_forces(Draw& draw, SceneText& scene) {
    const SceneNumbers numbers = numbers_of(scene);
    SceneTable& forces = scene.at("forces");
    const double speed = draw.sized(10.0, 90.0);
    scene.at("motion").set("speed_rad_s", speed);
    const double angle = numbers.is_program() ? numbers.segments.front().angle : numbers.rise;
    const double push = draw.sized(50.0, 1500.0) * (numbers.swings ? 0.1 : 1.0);
    const double swing = numbers.lift * std::pow(speed / angle, 2) * 5.0;
    forces.set(numbers.swings ? "inertia_kg_m2" : "mass_kg", push * draw.between(0.3, 1.5) / swing);
    forces.set(numbers.swings ? "spring_rate_nm_rad" : "spring_rate_n_m",
               push * draw.between(0.2, 1.5) / numbers.lift);
    forces.set(numbers.swings ? "preload_nm" : "preload_n", push * draw.between(0.3, 1.5));
    if (draw.chance(0.8)) forces.set("contact_width_m", 0.01);
}

/// The middle of every range.
Cam middle_cam(const SceneNumbers& numbers) {
    std::map<std::string, double> dimensions;
    for (const auto& [name, range] : numbers.dimensions) dimensions[name] = (range.low + range.high) / 2;
    return cam_of(numbers, dimensions);
}

/// Each limit about what the cam of a classical law would need.
void draw_limits(Draw& draw, SceneText& scene) {
    const SceneNumbers numbers = numbers_of(scene);
    const Motion motion = law_motion(numbers, draw.one_of(known_laws()));
    const Cam cam = middle_cam(numbers);
    const CamSurvey survey(motion, cam);
    SceneTable& limits = scene.at("limits");
    const auto about = [&](double value) { return value * draw.between(0.85, 1.4); };
    const double angle =
        std::clamp(survey.largest([](const CamPoint& p) { return p.pressure_angle; }), 0.05, 1.2);
    if (draw.chance(0.7)) limits.set("pressure_angle_rad", std::min(1.4, about(angle)));
    if (draw.chance(0.15)) limits.set("rise_pressure_angle_rad", std::min(1.4, about(angle)));
    if (draw.chance(0.15)) limits.set("return_pressure_angle_rad", std::min(1.4, about(angle)));
    const double sharp = survey.largest([](const CamPoint& p) { return p.curvature; });
    const double radius = numbers.is_flat() ? survey.least([](const CamPoint& p) { return p.cam_radius; })
                                            : 1.0 / sharp - cam.roller;
    if (draw.chance(0.3))
        limits.set("cam_radius_min_m", radius > 0.0 ? radius * draw.between(0.0, 0.9) : 0.0);
    if (draw.chance(0.15)) {
        const double least = survey.least([](const CamPoint& p) { return p.regularity; });
        limits.set("undercut_margin", std::clamp(least * draw.between(0.2, 0.95), 0.0, 0.9));
    }
    const double hollow = survey.least([](const CamPoint& p) { return p.curvature; });
    if (!numbers.is_flat() && hollow < 0.0 && draw.chance(0.25))
        limits.set("concave_radius_min_m", (cam.roller - 1.0 / hollow) * draw.between(0.3, 0.95));
    if (numbers.forces.empty()) return;
    const double least = survey.least([](const CamPoint& p) { return p.force; });
    if (draw.chance(0.4))
        limits.set(numbers.swings ? "contact_moment_min_nm" : "contact_force_min_n",
                   std::max(0.0, least * draw.between(0.2, 1.05)));
    const double torque = survey.largest([](const CamPoint& p) { return std::abs(p.torque); });
    if (draw.chance(0.3)) limits.set("torque_max_nm", about(torque));
    const double pressure =
        survey.largest([](const CamPoint& p) { return std::isinf(p.hertz) ? 0.0 : p.hertz; });
    const bool sharp_edge = survey.least([](const CamPoint& p) { return p.regularity; }) < 0.05;
    if (pressure > 0.0 && !sharp_edge && numbers.follower != "translating_knife" && draw.chance(0.5))
        limits.set("hertz_pressure_max_pa", about(pressure));
}

}  // namespace

SceneText drawn_cam_scene(Draw& draw, const SceneBudget& budget) {
    SceneText scene;
    const std::string follower =
        draw.one_of<std::string>({"translating_roller", "translating_knife", "translating_flat",
                                  "oscillating_roller", "oscillating_flat"});
    const bool swings = follower.starts_with("oscillating");
    if (draw.chance(0.2)) {
        draw_program(draw, scene);
        scene.at("motion").set(swings ? "lift_deg" : "lift_mm",
                               swings ? draw.between(6.0, 25.0) : draw.between(5.0, 50.0));
    } else {
        draw_motion(draw, scene, swings);
    }
    draw_spline(draw, scene, 14);
    draw_objective(draw, scene, true);
    draw_dimensions(draw, scene, follower);
    if (draw.chance(0.6)) draw_forces(draw, scene);
    draw_limits(draw, scene);
    SceneTable& objective = scene.at("objective");
    for (const auto& [name, range] : numbers_of(scene).dimensions)
        if (range.is_variable() && draw.chance(0.8)) objective.set(name, draw.sized(0.02, 0.5));
    SceneTable& solver = scene.at("solver");
    solver.set("max_seconds", budget.cam_seconds);
    solver.set("starts", "2");
    return scene;
}

}  // namespace camopt::soak

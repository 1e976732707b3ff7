// SPDX-License-Identifier: MIT
#include "tests/soak/figures/law.hpp"
#include "tests/soak/scenes/drawn_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// Near the 3-4-5 polynomial, so that most scenes have a motion.
void draw_via(Draw& draw, SceneText& scene) {
    const bool returns = scene.word("motion", "type", "") == "RR";
    std::vector<SceneTable> points;
    for (int count = draw.whole(1, 2); count > 0; --count) {
        double at = points.empty() && draw.chance(0.2) ? 0.5 : draw.between(0.15, 0.85);
        const std::array<double, 4> near = law_at("polynomial_345", at);
        if (returns && points.empty() && draw.chance(0.2)) at = 1.0;
        SceneTable point;
        point.set("at", at);
        const int what = draw.whole(0, 3);
        // Round numbers too: fractions at which the set of motions is a single curve, or empty, are of that
        // kind.
        if (what == 1 && draw.chance(0.3)) {
            point.set("velocity", draw.one_of<double>({1.0, 1.5, 1.875, 2.0}));
            points.push_back(point);
            continue;
        }
        if (what == 0) point.set("displacement", at == 1.0 ? 1.0 : near[0] + draw.between(-0.05, 0.05));
        if (what == 1) point.set("velocity", at == 1.0 ? 0.0 : near[1] * draw.between(0.6, 1.1));
        if (what == 2) point.set("acceleration", near[2] * draw.between(0.5, 1.2));
        if (what == 3) {
            point.set("displacement", at == 1.0 ? 1.0 : near[0]);
            point.set("velocity", at == 1.0 ? 0.0 : near[1]);
        }
        points.push_back(point);
    }
    scene.at("motion").set("via", inline_text(points));
}

void draw_caps(Draw& draw, SceneText& scene) {
    SceneTable& limits = scene.at("limits");
    // Modified sine: 1.76, 5.53, 69.5. The least possible of any curve: 1, 4, 32.
    if (draw.chance(0.5)) limits.set("velocity", draw.between(1.4, 2.4));
    if (draw.chance(0.5)) limits.set("acceleration", draw.between(4.6, 9.0));
    if (limits.members.empty() || draw.chance(0.3)) limits.set("jerk", draw.between(38.0, 120.0));
    // The exact optima of coarse splines and of any curve.
    if (draw.chance(0.1)) limits.set("acceleration", draw.one_of<double>({4.0, 4.5, 5.76, 6.0}));
    if (draw.chance(0.1)) limits.set("velocity", draw.one_of<double>({1.5, 1.6, 1.875, 2.0}));
}

/// Some caps in time instead: of a drive, in mm/s, mm/s², mm/s³.
void put_caps_in_time(Draw& draw, SceneText& scene) {
    const SceneNumbers numbers = numbers_of(scene);
    const double speed = draw.sized(5.0, 80.0);
    scene.at("motion").set("speed_rad_s", speed);
    double per = 1e3 * numbers.lift;
    const char* const keys[] = {"", "velocity_mm_s", "acceleration_mm_s2", "jerk_mm_s3"};
    SceneTable& limits = scene.at("limits");
    for (std::size_t order = 1; order <= 3; ++order) {
        per *= speed / numbers.rise;
        if (!numbers.caps[order]) continue;
        limits.erase(peak_names[order]);
        limits.set(keys[order], numbers.caps[order]->value * per);
    }
}

void draw_solver(Draw& draw, SceneText& scene, double seconds) {
    SceneTable& solver = scene.at("solver");
    solver.set("max_seconds", seconds);
    solver.set("starts", std::to_string(2));
    if (draw.chance(0.1)) solver.set("tolerance", draw.sized(1e-11, 1e-7));
}

}  // namespace

std::vector<double> drawn_breakpoints(Draw& draw, int segments, double length, double evenness) {
    std::vector<double> widths;
    double sum = 0.0;
    for (int k = 0; k < segments; ++k) {
        widths.push_back(draw.sized(evenness, 1.0));
        sum += widths.back();
    }
    std::vector<double> breakpoints = {0.0};
    for (const double width : widths) breakpoints.push_back(breakpoints.back() + width * length / sum);
    breakpoints.back() = length;
    return breakpoints;
}

void draw_motion(Draw& draw, SceneText& scene, bool swings) {
    SceneTable& motion = scene.at("motion");
    const bool returns = draw.chance(0.35);
    motion.set("type", quoted(returns ? "RR" : "DRD"));
    if (swings)
        motion.set(draw.chance(0.5) ? "lift_deg" : "lift_rad", 0.0);
    else
        motion.set(draw.one_of<std::string>({"lift_mm", "lift_m", "lift_in"}), 0.0);
    auto& [key, value] = motion.members.back();
    value = number_text((swings ? draw.between(0.1, 0.5) : draw.sized(0.004, 0.06)) / unit_of(key));
    const double rise = draw.between(40.0, 170.0);
    if (draw.chance(0.7))
        motion.set("rise_deg", rise);
    else
        motion.set("rise_rad", rise * unit_of("_deg"));
    if (returns && draw.chance(0.6))
        motion.set("return_deg", std::min(draw.between(0.6, 1.6) * rise, 355.0 - rise));
}

namespace {

void draw_any_program(Draw& draw, SceneText& scene) {
    const bool closed = draw.chance(0.75);
    scene.at("motion").set("type", quoted("program"));
    if (!closed) scene.at("motion").set("closed", "false");
    const int count = draw.whole(2, 6);
    const int own = draw.whole(0, count - 1);  // surely a spline
    int left = closed ? 360 : draw.whole(60 * count, 360);
    int last_move = own;
    std::vector<std::string> kinds;
    for (int k = 0; k < count; ++k) {
        const bool after_dwell = k > 0 && kinds.back() == "dwell";
        const double luck = draw.unit();
        kinds.push_back(k == own || luck < 0.5 ? "spline" : luck < 0.7 || after_dwell ? "law" : "dwell");
        if (kinds.back() != "dwell") last_move = k;
    }
    double height = 0.0;
    for (int k = 0; k < count; ++k) {
        SceneTable& segment = scene.append("motion.segments");
        const auto& kind = kinds[static_cast<std::size_t>(k)];
        segment.set("kind", quoted(kind));
        const int angle = k + 1 == count ? left : std::min(draw.whole(25, 110), left - 25 * (count - 1 - k));
        left -= angle;
        segment.set("angle_deg", std::to_string(angle));
        if (kind == "dwell") continue;
        if (kind == "law") segment.set("law", quoted(draw.one_of(known_laws())));
        if (closed && k == last_move) {
            if (k + 1 < count || kind == "law" || draw.chance(0.5)) segment.set("to", 0.0);
            continue;
        }
        if (kind == "spline" && draw.chance(0.15)) continue;  // free
        double to = height;
        while (to == height) to = 0.25 * draw.whole(0, 4);
        segment.set("to", to);
        height = to;
    }
}

/// A program in which no displacement is given but 0 asks for nothing.
bool asks_for_something(const SceneText& scene) {
    for (const Segment& segment : numbers_of(scene).segments)
        if (segment.to.value_or(0.0) != 0.0) return true;
    return false;
}

}  // namespace

void draw_program(Draw& draw, SceneText& scene) {
    const SceneText before = scene;
    do {
        scene = before;
        draw_any_program(draw, scene);
    } while (!asks_for_something(scene));
}

void draw_spline(Draw& draw, SceneText& scene, int most_segments) {
    SceneTable& spline = scene.at("spline");
    const bool program = scene.word("motion", "type", "") == "program";
    const int degree = draw.chance(0.6) ? 3 : draw.chance(0.75) ? 5 : 7;
    int segments = draw.whole(program ? 3 : 4, program ? most_segments / 2 : most_segments);
    if (draw.chance(0.1)) segments = draw.whole(1, 3);
    if (draw.chance(0.08) && !program) segments *= 3;
    spline.set("degree", std::to_string(degree));
    const double length = numbers_of(scene).length();
    if (draw.chance(0.3)) {
        const double evenness =
            degree == 3 ? draw.one_of<double>({0.02, 3e-3}) : draw.one_of<double>({0.25, 0.03});
        spline.set("breakpoints",
                   list_text(drawn_breakpoints(draw, segments, program ? 1.0 : length, evenness)));
    } else {
        spline.set("segments", std::to_string(segments));
    }
    if (degree >= 5 && draw.chance(0.4))
        spline.set("continuity", std::to_string(draw.whole(degree == 7 ? 3 : 2, degree - 1)));
    if (degree >= 5 && draw.chance(0.15)) spline.set("end_jerk", quoted("zero"));
    const bool whole = numbers_of(scene).continuity == degree - 1;
    const std::string design =
        draw.one_of<std::string>({"auto", "auto", "states", "coefficients", whole ? "ordinates" : "states"});
    if (design != "auto") spline.set("design", quoted(design));
}

void draw_objective(Draw& draw, SceneText& scene, bool with_cam) {
    SceneTable& objective = scene.at("objective");
    const bool program = scene.word("motion", "type", "") == "program";
    for (const char* term : {"velocity", "acceleration", "jerk"})
        if (draw.chance(0.75)) objective.set(term, draw.between(0.05, 1.0));
    if (!program && draw.chance(0.15)) objective.set("rms_acceleration", draw.between(0.1, 1.0));
    if (!program && draw.chance(0.15)) objective.set("rms_jerk", draw.sized(0.1, 8.0));
    if (!program && !with_cam && draw.chance(0.06)) objective.set("torque", draw.between(0.1, 1.0));
    if (objective.members.empty()) objective.set(draw.one_of<std::string>({"acceleration", "jerk"}), 1.0);
    if (draw.chance(0.5)) return;
    if (draw.chance(0.5)) {
        objective.set("reference", quoted(draw.one_of(known_laws())));
        return;
    }
    SceneTable numbers;
    for (const auto& [term, value] : law_figures("modified_sine"))
        numbers.set(term, value * draw.between(0.8, 1.2));
    objective.set("reference", inline_text(numbers));
}

SceneText drawn_motion_scene(Draw& draw, const SceneBudget& budget) {
    SceneText scene;
    const bool program = draw.chance(0.2);
    if (program) {
        draw_program(draw, scene);
    } else {
        draw_motion(draw, scene, false);
        if (draw.chance(0.15)) {
            scene.at("motion").set("symmetric", "true");
            scene.at("motion").erase("return_deg");
        } else if (draw.chance(0.2)) {
            draw_via(draw, scene);
        }
    }
    draw_spline(draw, scene, 24);
    if (scene.find("motion", "symmetric")) {
        const auto segments = scene.list("spline", "breakpoints").size();
        scene.at("spline").erase("breakpoints");
        if (segments > 0) scene.at("spline").set("segments", std::to_string(segments - 1));
    }
    draw_objective(draw, scene, false);
    if (draw.chance(0.3)) {
        draw_caps(draw, scene);
        if (!program && draw.chance(0.25)) put_caps_in_time(draw, scene);
    }
    draw_solver(draw, scene, budget.motion_seconds);
    return scene;
}

}  // namespace camopt::soak

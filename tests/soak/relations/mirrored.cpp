// SPDX-License-Identifier: MIT
// The motion run backwards, the cam seen from behind: the same answer.
#include "tests/soak/figures/law.hpp"
#include "tests/soak/relations/change.hpp"
#include "tests/soak/relations/relation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace camopt::soak {

namespace {

void turn_round(SceneText& scene) {
    const bool clockwise = scene.word("cam", "rotation", "counterclockwise") == "clockwise";
    scene.at("cam").set("rotation", quoted(clockwise ? "counterclockwise" : "clockwise"));
}

/// Limits of the rise become those of the return.
void swap_pressure(SceneText& scene) {
    if (!scene.has("limits")) return;
    for (auto& [key, value] : scene.at("limits").members) {
        if (key.starts_with("rise_pressure"))
            key.replace(0, 4, "return");
        else if (key.starts_with("return_pressure"))
            key.replace(0, 6, "rise");
    }
}

void reverse_breakpoints(SceneText& scene, double length, double unit) {
    std::vector<double> breakpoints = scene.list("spline", "breakpoints");
    if (breakpoints.empty()) return;
    for (double& point : breakpoints) point = (length - point) / unit;
    std::reverse(breakpoints.begin(), breakpoints.end());
    breakpoints.front() = 0.0;
    breakpoints.back() = length / unit;
    scene.at("spline").set("breakpoints", list_text(breakpoints));
}

/// `unit`: new rise / old rise. Of a rise alone the displacement is counted from the other end.
void reverse_via(SceneText& scene, const SceneNumbers& numbers, double unit) {
    if (numbers.via.empty()) return;
    const bool rise = numbers.type == "DRD";
    std::vector<SceneTable> points;
    for (const ViaPoint& via : numbers.via) {
        SceneTable point;
        point.set("at", (numbers.length() - via.at) / unit);
        const double sign = rise ? -1.0 : 1.0;
        if (via.value[0]) point.set("displacement", rise ? 1.0 - *via.value[0] : *via.value[0]);
        if (via.value[1]) point.set("velocity", -sign * *via.value[1] * unit);
        if (via.value[2]) point.set("acceleration", sign * *via.value[2] * unit * unit);
        points.push_back(point);
    }
    scene.at("motion").set("via", inline_text(points));
}

/// Peaks are counted in the new unit of x: references and caps go with them.
void rescale_peaks(SceneText& scene, const SceneNumbers& numbers, double unit) {
    SceneTable reference = numeric_reference(numbers);
    const std::pair<const char*, int> powers[] = {{"velocity", 1}, {"acceleration", 2},
                                                  {"jerk", 3},     {"rms_acceleration", 2},
                                                  {"rms_jerk", 3}, {"torque", 3}};
    for (const auto& [term, power] : powers) scale_quantity(reference, term, std::pow(unit, power));
    scene.at("objective").set("reference", inline_text(reference));
    if (!scene.has("limits")) return;
    for (const auto& [term, power] : powers)
        if (scene.at("limits").find(term)) scale_quantity(scene.at("limits"), term, std::pow(unit, power));
}

void reverse_stroke(SceneText& scene, const SceneNumbers& numbers) {
    const double unit = numbers.type == "RR" ? numbers.back / numbers.rise : 1.0;
    SceneTable& motion = scene.at("motion");
    if (numbers.type == "RR") {
        for (const char* angle : {"rise", "return"})
            if (const std::string key = spelled(motion, angle); !key.empty()) motion.erase(key);
        motion.set("rise_rad", numbers.back);
        motion.set("return_rad", numbers.rise);
        rescale_peaks(scene, numbers, unit);
    }
    reverse_breakpoints(scene, numbers.length(), unit);
    reverse_via(scene, numbers, unit);
}

/// Displacements between the segments; none: free.
std::vector<std::optional<double>> joints_of(const SceneNumbers& numbers) {
    std::vector<std::optional<double>> joints = {0.0};
    for (const Segment& segment : numbers.segments)
        joints.push_back(segment.kind == "dwell" ? joints.back() : segment.to);
    joints.back() = 0.0;
    return joints;
}

void reverse_program(SceneText& scene, const SceneNumbers& numbers) {
    const auto joints = joints_of(numbers);
    std::vector<SceneTable> segments;
    std::size_t k = 0;
    for (const SceneTable* table : scene.all("motion.segments")) {
        SceneTable segment = *table;
        if (const std::string to = spelled(segment, "to"); !to.empty()) segment.erase(to);
        if (numbers.segments[k].kind != "dwell" && joints[k]) segment.set("to", *joints[k]);
        segments.insert(segments.begin(), segment);
        ++k;
    }
    k = 0;
    for (SceneTable& table : scene.tables())
        if (table.name == "motion.segments") table = segments[k++];
    reverse_breakpoints(scene, 1.0, 1.0);
}

bool only_symmetric_laws(const SceneNumbers& numbers) {
    for (const Segment& segment : numbers.segments)
        if (segment.kind == "law" && std::ranges::count(known_laws(), segment.law) == 0) return false;
    return true;
}

}  // namespace

Finding compare_reversed(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    if (trial.has_cam() && numbers.type == "DRD") return no_case;  // a fall would be no DRD
    SceneText reversed = trial.text();
    if (numbers.is_program()) {
        if (!numbers.closed || !only_symmetric_laws(numbers)) return no_case;
        reverse_program(reversed, numbers);
    } else {
        reverse_stroke(reversed, numbers);
    }
    if (trial.has_cam()) {
        turn_round(reversed);
        swap_pressure(reversed);
    }
    return same_answer(trial.base().outcome, trial.solve(reversed).outcome);
}

Finding compare_mirrored(Trial& trial) {
    if (!trial.has_cam() || trial.numbers().swings) return no_case;
    SceneText mirrored = trial.text();
    turn_round(mirrored);
    scale_quantity(mirrored.at("cam"), "offset", -1.0);
    return same_answer(trial.base().outcome, trial.solve(mirrored).outcome);
}

}  // namespace camopt::soak

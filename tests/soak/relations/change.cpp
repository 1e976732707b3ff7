// SPDX-License-Identifier: MIT
#include "tests/soak/relations/change.hpp"

#include "tests/soak/figures/law.hpp"

#include <algorithm>
#include <cstdlib>

namespace camopt::soak {

const std::vector<std::string>& cam_lengths() {
    static const std::vector<std::string> keys = {"base_radius",     "roller_radius", "offset",
                                                  "center_distance", "arm_length",    "face_offset",
                                                  "face_half_width"};
    return keys;
}

namespace {

/// Of a number or of both ends of a range. A negative factor swaps the ends.
std::string changed(const std::string& value, double factor) {
    const auto times = [&](const std::string& number) {
        return factor * std::strtod(number.c_str(), nullptr);
    };
    if (!value.starts_with('{')) return number_text(times(value));
    const SceneTable ends = inline_table(value);
    const double one = times(ends.find("min").value_or("0"));
    const double other = times(ends.find("max").value_or("0"));
    SceneTable range;
    range.set("min", std::min(one, other));
    range.set("max", std::max(one, other));
    return inline_text(range);
}

void scale_forces(SceneText& scene, double factor, bool swings) {
    if (!scene.has("forces")) return;
    SceneTable& forces = scene.at("forces");
    if (swings) {  // moments stay, the lever grows: the width keeps the pressure
        scale_quantity(forces, "contact_width", 1.0 / (factor * factor));
        return;
    }
    for (const char* name : {"mass", "spring_rate", "contact_width"})
        scale_quantity(forces, name, 1.0 / factor);
    if (scene.has("limits")) scale_quantity(scene.at("limits"), "torque_max", factor);
}

/// A cap in time scales with the lift.
void scale_physical_caps(SceneText& scene, double factor) {
    if (!scene.has("limits")) return;
    SceneTable& limits = scene.at("limits");
    for (const char* const peak : peak_names)
        if (const std::string key = spelled(limits, peak); !key.empty() && key != peak)
            scale_quantity(limits, peak, factor);
}

}  // namespace

void scale_quantity(SceneTable& table, std::string_view quantity, double factor) {
    const std::string key = spelled(table, quantity);
    if (!key.empty()) table.set(key, changed(*table.find(key), factor));
}

void respell(SceneTable& table, std::string_view quantity, std::string_view unit) {
    const std::string key = spelled(table, quantity);
    const std::string other = std::string(quantity) + std::string(unit);
    if (key.empty() || key == other) return;
    const std::string value = changed(*table.find(key), unit_of(key) / unit_of(unit));
    for (auto& [name, old] : table.members) {
        if (name != key) continue;
        name = other;
        old = value;
    }
}

SceneTable numeric_reference(const SceneNumbers& scene) {
    std::map<std::string, double> reference = scene.references;
    if (!scene.reference_law.empty()) reference = law_figures(scene.reference_law);
    SceneTable table;
    for (const auto& [term, value] : reference) table.set(term, value);
    return table;
}

void scale_lengths(SceneText& scene, double factor) {
    SceneTable& motion = scene.at("motion");
    if (spelled(motion, "lift").empty()) motion.set("lift_mm", 1.0);
    const bool swings = numbers_of(scene).swings;
    if (!swings) {
        scale_quantity(motion, "lift", factor);
        scale_physical_caps(scene, factor);
    }
    for (SceneTable& table : scene.tables())
        if (table.name == "motion.segments" && table.find("to") == std::nullopt && !swings)
            scale_quantity(table, "to", factor);
    if (!scene.has("cam")) return;
    for (const std::string& length : cam_lengths()) scale_quantity(scene.at("cam"), length, factor);
    scale_forces(scene, factor, swings);
    if (!scene.has("limits")) return;
    scale_quantity(scene.at("limits"), "cam_radius_min", factor);
    scale_quantity(scene.at("limits"), "concave_radius_min", factor);
}

std::vector<LooseEnd> loose_ends(const SceneText& scene) {
    std::vector<LooseEnd> all;
    const SceneTable* limits = scene.find("limits");
    if (!limits) return all;
    for (const auto& [key, value] : limits->members) {
        const bool least = key.find("_min") != std::string::npos || key == "undercut_margin";
        if (std::strtod(value.c_str(), nullptr) > 0.0) all.push_back({key, !least});
    }
    return all;
}

void loosen(SceneText& scene, const LooseEnd& limit, double factor) {
    SceneTable& limits = scene.at("limits");
    double value = std::strtod(limits.find(limit.key)->c_str(), nullptr);
    value = limit.is_most ? value * factor : value / factor;
    if (limit.key.find("pressure_angle") != std::string::npos)
        value = std::min(value, 1.55 / unit_of(limit.key));  // below 90 degrees
    if (limit.key == "undercut_margin") value = std::min(value, 0.99);
    limits.set(limit.key, value);
}

}  // namespace camopt::soak

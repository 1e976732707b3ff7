// SPDX-License-Identifier: MIT
#include "tests/soak/scenes/scene_numbers.hpp"

#include <cstdlib>
#include <numbers>
#include <utility>

namespace camopt::soak {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double inch = 0.0254;

/// Longest endings first: "_mm_s2" ends in "_s2" too.
constexpr std::pair<std::string_view, double> units[] = {{"_nm_rad", 1.0},
                                                         {"_nm_deg", 1.0 / degree},
                                                         {"_kg_m2", 1.0},
                                                         {"_rad_s3", 1.0},
                                                         {"_rad_s2", 1.0},
                                                         {"_deg_s3", degree},
                                                         {"_deg_s2", degree},
                                                         {"_mm_s3", 1e-3},
                                                         {"_mm_s2", 1e-3},
                                                         {"_in_s3", inch},
                                                         {"_in_s2", inch},
                                                         {"_m_s3", 1.0},
                                                         {"_m_s2", 1.0},
                                                         {"_rad_s", 1.0},
                                                         {"_deg_s", degree},
                                                         {"_mm_s", 1e-3},
                                                         {"_in_s", inch},
                                                         {"_m_s", 1.0},
                                                         {"_n_mm", 1e3},
                                                         {"_n_m", 1.0},
                                                         {"_rpm", std::numbers::pi / 30.0},
                                                         {"_deg", degree},
                                                         {"_rad", 1.0},
                                                         {"_mpa", 1e6},
                                                         {"_gpa", 1e9},
                                                         {"_pa", 1.0},
                                                         {"_kg", 1.0},
                                                         {"_nm", 1.0},
                                                         {"_mm", 1e-3},
                                                         {"_in", inch},
                                                         {"_m", 1.0},
                                                         {"_um", 1e-6},
                                                         {"_hz", 2.0 * std::numbers::pi},
                                                         {"_n", 1.0}};

double value_of(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}

std::optional<double> quantity_of(const SceneTable* table, std::string_view quantity) {
    if (!table) return std::nullopt;
    const std::string key = spelled(*table, quantity);
    if (key.empty()) return std::nullopt;
    return value_of(*table->find(key)) * unit_of(key);
}

void read_via(const SceneText& text, SceneNumbers& numbers) {
    const auto written = text.find("motion", "via");
    if (!written) return;
    for (const SceneTable& point : inline_tables(*written)) {
        ViaPoint via;
        via.at = value_of(point.find("at").value_or("0"));
        const char* const names[] = {"displacement", "velocity", "acceleration"};
        for (std::size_t order = 0; order < 3; ++order)
            if (const auto value = point.find(names[order])) via.value[order] = value_of(*value);
        numbers.via.push_back(via);
    }
}

void read_motion(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* motion = text.find("motion");
    numbers.type = text.word("motion", "type", "DRD");
    numbers.lift = quantity_of(motion, "lift").value_or(1e-3);
    const std::string lift = motion ? spelled(*motion, "lift") : "";
    numbers.swings = lift == "lift_deg" || lift == "lift_rad";
    numbers.rise = quantity_of(motion, "rise").value_or(std::numbers::pi);
    numbers.back = quantity_of(motion, "return").value_or(numbers.rise);
    numbers.speed = quantity_of(motion, "speed").value_or(0.0);
    numbers.symmetric = text.word("motion", "symmetric", "false") == "true";
    numbers.closed = text.word("motion", "closed", "true") == "true";
    read_via(text, numbers);
    for (const SceneTable* table : text.all("motion.segments")) {
        Segment segment;
        segment.kind = table->word("kind", "");
        segment.law = table->word("law", "");
        segment.angle = quantity_of(table, "angle").value_or(0.0);
        segment.to = quantity_of(table, "to");
        if (segment.to && spelled(*table, "to") != "to") *segment.to /= numbers.lift;
        numbers.segments.push_back(segment);
    }
}

void read_spline(const SceneText& text, SceneNumbers& numbers) {
    numbers.degree = static_cast<int>(text.number("spline", "degree", 3));
    numbers.continuity = static_cast<int>(text.number("spline", "continuity", numbers.degree - 1));
    numbers.spline_segments = static_cast<int>(text.number("spline", "segments", 12));
    numbers.breakpoints = text.list("spline", "breakpoints");
    numbers.free_knots = text.word("spline", "knots", "fixed") == "free";
    numbers.end_jerk_zero = text.word("spline", "end_jerk", "free") == "zero";
    numbers.design = text.word("spline", "design", "auto");
}

void read_objective(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* objective = text.find("objective");
    numbers.reference_law = "modified_sine";
    if (!objective) return;
    for (const auto& [key, value] : objective->members) {
        if (key == "reference" && value.starts_with('{')) {
            numbers.reference_law.clear();
            for (const auto& [term, number] : inline_table(value).members)
                numbers.references[term] = value_of(number);
        } else if (key == "reference") {
            numbers.reference_law = text.word("objective", key, "");
        } else if (key != "tie_break" && value_of(value) > 0.0) {
            numbers.weights[key] = value_of(value);
        }
    }
}

void read_cam(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* cam = text.find("cam");
    if (!cam || text.word("cam", "type", "") != "disk") return;
    numbers.follower = text.word("cam", "follower", "");
    numbers.sense = text.word("cam", "rotation", "counterclockwise") == "clockwise" ? -1.0 : 1.0;
    for (const char* name :
         {"base_radius", "roller_radius", "offset", "center_distance", "arm_length", "face_offset"}) {
        const std::string key = spelled(*cam, name);
        Range& range = numbers.dimensions[name];
        if (key.empty()) continue;
        const std::string value = *cam->find(key);
        if (value.starts_with('{')) {
            const SceneTable ends = inline_table(value);
            range = {value_of(ends.find("min").value_or("0")), value_of(ends.find("max").value_or("0"))};
        } else {
            range = {value_of(value), value_of(value)};
        }
        range.low *= unit_of(key);
        range.high *= unit_of(key);
    }
    numbers.face_half_width = quantity_of(cam, "face_half_width");
}

void read_forces(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* forces = text.find("forces");
    if (!forces) return;
    const double mass = quantity_of(forces, "mass").value_or(0.0);
    numbers.forces["mass"] = quantity_of(forces, "inertia").value_or(mass);
    numbers.forces["spring_rate"] = quantity_of(forces, "spring_rate").value_or(0.0);
    numbers.forces["preload"] = quantity_of(forces, "preload").value_or(0.0);
    if (const auto width = quantity_of(forces, "contact_width")) numbers.forces["contact_width"] = *width;
    const auto softness = [&](const char* modulus, const char* poisson) {
        const double ratio = quantity_of(forces, poisson).value_or(0.3);
        return (1.0 - ratio * ratio) / quantity_of(forces, modulus).value_or(210e9);
    };
    numbers.forces["compliance"] =
        softness("cam_modulus", "cam_poisson") + softness("follower_modulus", "follower_poisson");
}

/// Known here: one mass, by its natural frequency and damping ratio.
void read_train(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* dynamics = text.find("dynamics");
    const auto frequency = quantity_of(dynamics, "natural_frequency");
    const auto ratio = quantity_of(dynamics, "damping_ratio");
    if (!frequency || !ratio || text.find("dynamics.stage") || !spelled(*dynamics, "return_spring").empty())
        return;
    const double mass = quantity_of(dynamics, "mass").value();
    numbers.train = Train{mass, mass * *frequency * *frequency, 2.0 * *ratio * mass * *frequency,
                          quantity_of(dynamics, "preload").value_or(0.0)};
}

void read_limits(const SceneText& text, SceneNumbers& numbers) {
    const SceneTable* limits = text.find("limits");
    if (!limits) return;
    for (std::size_t order = 1; order <= 3; ++order)
        if (const auto value = quantity_of(limits, peak_names[order]))
            numbers.caps[order] = Cap{*value, spelled(*limits, peak_names[order]) != peak_names[order]};
    for (const char* name :
         {"pressure_angle", "rise_pressure_angle", "return_pressure_angle", "cam_radius_min",
          "concave_radius_min", "undercut_margin", "contact_force_min", "contact_moment_min", "torque_max",
          "hertz_pressure_max", "residual", "dynamic_contact_force_min"})
        if (const auto value = quantity_of(limits, name)) numbers.limits[name] = *value;
}

}  // namespace

double unit_of(std::string_view key) {
    for (const auto& [ending, unit] : units)
        if (key.ends_with(ending)) return unit;
    return 1.0;
}

std::string spelled(const SceneTable& table, std::string_view quantity) {
    for (const auto& [key, value] : table.members) {
        if (key == quantity) return key;
        if (!key.starts_with(quantity)) continue;
        for (const auto& [ending, unit] : units)
            if (key.substr(quantity.size()) == ending) return key;
    }
    return {};
}

double SceneNumbers::weight(const std::string& term) const {
    const auto found = weights.find(term);
    return found == weights.end() ? 0.0 : found->second;
}

SceneNumbers numbers_of(const SceneText& text) {
    SceneNumbers numbers;
    read_motion(text, numbers);
    read_spline(text, numbers);
    read_objective(text, numbers);
    read_cam(text, numbers);
    read_forces(text, numbers);
    read_train(text, numbers);
    read_limits(text, numbers);
    numbers.tolerance = text.number("solver", "tolerance", numbers.tolerance);
    if (text.find("solver", "gap")) numbers.gap = text.number("solver", "gap", 0.0);
    numbers.max_seconds = text.number("solver", "max_seconds", numbers.max_seconds);
    return numbers;
}

}  // namespace camopt::soak

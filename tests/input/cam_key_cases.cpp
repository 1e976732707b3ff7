// SPDX-License-Identifier: MIT
#include "tests/input/scene_key_cases.hpp"

#include <numbers>
#include <utility>

namespace camopt::input {
namespace cam_key_cases {

using enum DimensionIndex;

constexpr double pi = std::numbers::pi;

/// A scene's cam, without one of its quantities.
std::string cam(FollowerType follower, const std::string& except = "") {
    std::string toml = is_oscillating(follower) ? "motion.lift_deg = 20\n" : "motion.lift_mm = 20\n";
    const auto add = [&](const std::string& quantity, const std::string& line) {
        if (quantity != except) toml += "cam." + line + "\n";
    };
    add("type", "type = \"disk\"");
    add("follower", "follower = \"" + std::string(name_of(follower)) + "\"");
    add("base_radius", "base_radius_mm = 40");
    if (has_roller(follower)) add("roller_radius", "roller_radius_mm = 10");
    if (is_oscillating(follower)) add("center_distance", "center_distance_mm = 80");
    if (has_dimension(follower, arm_length)) add("arm_length", "arm_length_mm = 70");
    return toml;
}

std::string forces(FollowerType follower) {
    return cam(follower) + "motion.speed_rpm = 300\n";
}

std::function<double(const Scene&)> low(DimensionIndex index) {
    return [index](const Scene& s) { return s.cam.value().find(index)->low; };
}

std::function<double(const Scene&)> high(DimensionIndex index) {
    return [index](const Scene& s) { return s.cam.value().find(index)->high; };
}

std::function<double(const Scene&)> of_forces(double ForceSpec::*member) {
    return [member](const Scene& s) { return s.forces.value().*member; };
}

std::function<double(const Scene&)> of_limit(std::optional<WrittenLimit> LimitSpec::*limit) {
    return [limit](const Scene& s) { return (s.limits.*limit).value().value; };
}

constexpr auto roller = FollowerType::translating_roller;
constexpr auto knife = FollowerType::translating_knife;
constexpr auto flat = FollowerType::translating_flat;
constexpr auto arm = FollowerType::oscillating_roller;
constexpr auto face = FollowerType::oscillating_flat;

}  // namespace cam_key_cases

std::vector<KeyCase> segment_cases() {
    using namespace cam_key_cases;
    const std::string program = "motion.type = \"program\"\nmotion.closed = false\n";
    const std::string length = program + "motion.lift_mm = 20\n";
    const std::string angle = program + "motion.lift_rad = 0.5\n";
    const auto to = [](const Scene& s) { return s.motion.segments.at(0).to.value(); };
    const auto first_angle = [](const Scene& s) { return s.motion.segments.at(0).angle; };
    const auto phase = [](const Scene& s) { return s.motion.phase; };
    const std::string turn =
        "motion.type = \"program\"\nmotion.segments = [{ kind = \"spline\", angle_deg = 180, "
        "to = 1 }, { kind = \"spline\", angle_deg = 180 }]\n";
    return {
        {"motion.type", "\"program\"", 1,
         [](const Scene& s) { return s.motion.type == MotionType::program ? 1.0 : 0.0; },
         "motion.closed = false\nmotion.segments = [{ kind = \"spline\", angle_deg = 360, to = 1 }]\n"},
        {"motion.segments",
         "[{ kind = \"dwell\", angle_deg = 300 }, { kind = \"spline\", angle_deg = 60, to = 1 }]", 2,
         [](const Scene& s) { return double(s.motion.segments.size()); },
         "motion.type = \"program\"\nmotion.closed = false\n"},
        {"motion.closed", "false", 0, [](const Scene& s) { return s.motion.closed ? 1.0 : 0.0; },
         "motion.type = \"program\"\nmotion.segments = [{ kind = \"spline\", angle_deg = 36, to = 1 }]\n"},
        {"motion.closed", "\"relative\"", 1, [](const Scene& s) { return s.motion.relative ? 1.0 : 0.0; },
         "motion.type = \"program\"\nmotion.segments = [{ kind = \"spline\", angle_deg = 360, to = 1 }]\n"},
        {"motion.repeat", "4", 8, [](const Scene& s) { return double(s.motion.segments.size()); },
         "motion.type = \"program\"\nmotion.segments = [{ kind = \"spline\", angle_deg = 45, to = 1 }, "
         "{ kind = \"spline\", angle_deg = 45 }]\n"},
        {"motion.phase_deg", "18", pi / 10, phase, turn},
        {"motion.phase_rad", "-0.5", -0.5, phase, turn},
        {"motion.phase_crank_deg", "180", pi / 2, phase, turn},
        {"motion.segments.angle_crank_deg", "180", pi / 2, first_angle, program},
        {"cam.face_radius_mm", "30", 0.03, [](const Scene& s) { return s.cam.value().face_radius.value(); },
         cam(FollowerType::translating_flat)},
        {"cam.face_radius_in", "1", 0.0254,
         [](const Scene& s) { return s.cam.value().face_half_width.value(); },
         cam(FollowerType::translating_flat)},
        {"cam.face_radius_m", "0.02", 0.02, [](const Scene& s) { return s.cam.value().face_radius.value(); },
         cam(FollowerType::translating_flat)},
        {"motion.within_lift", "false", 0, [](const Scene& s) { return s.motion.within_lift ? 1.0 : 0.0; }},
        {"motion.monotone", "true", 1, [](const Scene& s) { return s.motion.monotone ? 1.0 : 0.0; }},
        {"motion.segments.kind", "\"dwell\"", 1,
         [](const Scene& s) { return s.motion.segments.at(0).kind == SegmentKind::dwell ? 1.0 : 0.0; },
         program},
        {"motion.segments.kind", "\"spline\"", 1,
         [](const Scene& s) { return s.motion.segments.at(0).kind == SegmentKind::spline ? 1.0 : 0.0; },
         program},
        {"motion.segments.law", "\"cycloidal\"", 1,
         [](const Scene& s) { return s.motion.segments.at(0).law == "cycloidal" ? 1.0 : 0.0; }, program},
        {"motion.segments.angle_deg", "90", pi / 2, first_angle, program},
        {"motion.segments.angle_rad", "0.25", 0.25, first_angle, program},
        {"motion.segments.to", "-0.5", -0.5, to, program},
        {"motion.segments.to_mm", "5", 0.25, to, length},
        {"motion.segments.to_in", "1", 1.27, to, length},
        {"motion.segments.to_m", "0.01", 0.5, to, length},
        {"motion.segments.to_deg", "45", pi / 2, to, angle},
        {"motion.segments.to_rad", "0.5", 1, to, angle},
    };
}

namespace cam_key_cases {

std::function<double(const Scene&)> number(const char* name) {
    return [name](const Scene& s) { return s.cam.value().find(name)->low; };
}

/// In every unit of a length: 1 mm, 1 in, 0.04 m times `size`.
void add_lengths(std::vector<KeyCase>& all, const std::string& key, double size,
                 const std::function<double(const Scene&)>& got, const std::string& rest) {
    for (const auto& [unit, metres] : {std::pair("_mm", 1e-3), {"_in", 0.0254}, {"_m", 1.0}})
        all.push_back({"cam." + key + unit, std::to_string(size / metres),
                       std::stod(std::to_string(size / metres)) * metres, got, rest});
}

void add_form_cases(std::vector<KeyCase>& all) {
    const std::string groove = cam(roller) + "cam.form = \"grooved\"\n";
    const std::string pair = cam(roller) + "cam.form = \"conjugate\"\n";
    const std::string slide = pair + "cam.roller_distance_mm = 120\n";
    const std::string arms = cam(arm) + "cam.form = \"conjugate\"\n";
    const auto is = [](const char* form) {
        return [form](const Scene& s) { return s.cam.value().choice("form") == form ? 1.0 : 0.0; };
    };
    all.push_back({"cam.form", "\"open\"", 1, is("open"), cam(roller)});
    all.push_back({"cam.form", "\"grooved\"", 1, is("grooved"), cam(arm)});
    all.push_back(
        {"cam.form", "\"conjugate\"", 1, is("conjugate"), cam(roller) + "cam.roller_distance_mm = 120\n"});
    add_lengths(all, "groove_clearance", 0.002, number("groove_clearance"), groove);
    add_lengths(all, "groove_wall", 0.012, number("groove_wall"), groove);
    add_lengths(all, "roller_distance", 0.12, number("roller_distance"), pair);
    add_lengths(all, "second_roller_radius", 0.008, number("second_roller_radius"), slide);
    add_lengths(all, "second_offset", -0.006, number("second_offset"), slide);
    all.push_back({"cam.arm_angle_deg", "90", pi / 2, number("arm_angle"), arms});
    all.push_back({"cam.arm_angle_rad", "1.5", 1.5, number("arm_angle"), arms});
    add_lengths(all, "second_arm_length", 0.075, number("second_arm_length"),
                arms + "cam.arm_angle_deg = 90\n");
}

}  // namespace cam_key_cases

std::vector<KeyCase> cam_cases() {
    using namespace cam_key_cases;
    const auto width = [](const Scene& s) { return s.cam.value().face_half_width.value(); };
    std::vector<KeyCase> all = {
        {"cam.type", "\"disk\"", 1, [](const Scene& s) { return s.cam ? 1.0 : 0.0; }, cam(roller, "type")},
        {"cam.follower", "\"translating_knife\"", 1,
         [](const Scene& s) { return s.cam.value().choice("follower") == "translating_knife" ? 1.0 : 0.0; },
         cam(knife, "follower")},
        {"cam.rotation", "\"clockwise\"", 1,
         [](const Scene& s) { return s.cam.value().rotation == Rotation::clockwise ? 1.0 : 0.0; },
         cam(roller)},
        {"cam.base_radius_mm", "40", 0.04, low(base_radius), cam(roller, "base_radius")},
        {"cam.base_radius_mm", "40", 0.04, high(base_radius), cam(roller, "base_radius")},
        {"cam.base_radius_mm", "{ min = 20, max = 60 }", 0.02, low(base_radius), cam(roller, "base_radius")},
        {"cam.base_radius_mm", "{ min = 20, max = 60 }", 0.06, high(base_radius), cam(roller, "base_radius")},
        {"cam.base_radius_in", "{ max = 3.0, min = 2 }", 0.0508, low(base_radius),
         cam(roller, "base_radius")},
        {"cam.base_radius_in", "{ max = 3.0, min = 2 }", 0.0254,
         [](const Scene& s) { return s.cam.value().find(base_radius)->unit; }, cam(roller, "base_radius")},
        {"cam.base_radius_m", "0.05", 0.05, low(base_radius), cam(arm, "base_radius")},
        {"cam.roller_radius_mm", "8", 0.008, low(roller_radius), cam(roller, "roller_radius")},
        {"cam.roller_radius_in", "0.5", 0.0127, low(roller_radius), cam(arm, "roller_radius")},
        {"cam.roller_radius_m", "0.01", 0.01, low(roller_radius), cam(roller, "roller_radius")},
        {"cam.offset_mm", "-12", -0.012, low(offset), cam(roller)},
        {"cam.offset_in", "{ min = -1, max = 1 }", -0.0254, low(offset), cam(knife)},
        {"cam.offset_m", "0", 0, high(offset), cam(roller)},
        {"cam.center_distance_mm", "90", 0.09, low(center_distance), cam(arm, "center_distance")},
        {"cam.center_distance_in", "4", 0.1016, low(center_distance), cam(face, "center_distance")},
        {"cam.center_distance_m", "{ min = 0.08, max = 0.1 }", 0.1, high(center_distance),
         cam(arm, "center_distance")},
        {"cam.arm_length_mm", "75", 0.075, low(arm_length), cam(arm, "arm_length")},
        {"cam.arm_length_in", "3", 0.0762, low(arm_length), cam(arm, "arm_length")},
        {"cam.arm_length_m", "0.06", 0.06, low(arm_length), cam(arm, "arm_length")},
        {"cam.face_offset_mm", "-5", -0.005, low(face_offset), cam(face)},
        {"cam.face_offset_in", "0.5", 0.0127, low(face_offset), cam(face)},
        {"cam.face_offset_m", "{ min = 0, max = 0.01 }", 0.01, high(face_offset), cam(face)},
        {"cam.face_half_width_mm", "30", 0.03, width, cam(flat)},
        {"cam.face_half_width_in", "1", 0.0254, width, cam(flat)},
        {"cam.face_half_width_m", "0.02", 0.02, width, cam(flat)},
    };
    add_form_cases(all);
    return all;
}

std::vector<KeyCase> force_cases() {
    using namespace cam_key_cases;
    const auto width = [](const Scene& s) { return s.forces.value().contact_width.value(); };
    const auto load = [](const Scene& s) { return s.forces.value().load.back()[1]; };
    const auto frequency = [](const Scene& s) { return s.forces.value().spring_frequency.value(); };
    const auto fastest = [](const Scene& s) { return s.forces.value().speed_range.value()[1]; };
    const auto harmonic = of_limit(&LimitSpec::spring_harmonic);
    const std::string rr = "motion.type = \"RR\"\n";
    const std::string spring = rr + forces(roller) + "forces.spring_rate_n_mm = 12\n",
                      turned = rr + forces(arm) + "forces.spring_rate_nm_rad = 12\n";
    const std::string surge = spring + "forces.spring_frequency_hz = 40\n",
                      surge_of_arm = turned + "forces.spring_frequency_hz = 40\n";
    return {
        {"forces.mass_kg", "1.5", 1.5, of_forces(&ForceSpec::mass), forces(roller)},
        {"forces.mass_lb", "2", 0.90718474, of_forces(&ForceSpec::mass), forces(roller)},
        {"forces.spring_rate_lbf_in", "1", 175.12683524647636, of_forces(&ForceSpec::spring_rate),
         forces(flat)},
        {"forces.preload_lbf", "1", 4.4482216152605, of_forces(&ForceSpec::preload), forces(roller)},
        {"forces.preload_lbf_in", "1", 0.1129848290276167, of_forces(&ForceSpec::preload), forces(arm)},
        {"forces.damping_n_s_m", "7", 7, of_forces(&ForceSpec::damping), forces(roller)},
        {"forces.damping_nm_s_rad", "7", 7, of_forces(&ForceSpec::damping), forces(arm)},
        {"forces.load_n", "3", 3, load, forces(roller)},
        {"forces.load_nm", "[[0, 1], [90, 3]]", 3, load, forces(arm)},
        {"forces.load_lbf", "1", 4.4482216152605, load, forces(roller)},
        {"forces.load_lbf_in", "[[0, 2], [90, 1]]", 0.1129848290276167, load, forces(arm)},
        {"forces.cam_modulus_ksi", "1", 6894757.293168361, of_forces(&ForceSpec::cam_modulus),
         forces(roller)},
        {"forces.follower_modulus_ksi", "1", 6894757.293168361, of_forces(&ForceSpec::follower_modulus),
         forces(roller)},
        {"forces.inertia_kg_m2", "0.01", 0.01, of_forces(&ForceSpec::mass), forces(arm)},
        {"forces.spring_rate_n_mm", "12", 12000, of_forces(&ForceSpec::spring_rate), forces(flat)},
        {"forces.spring_rate_n_m", "12", 12, of_forces(&ForceSpec::spring_rate), forces(knife)},
        {"forces.spring_rate_nm_rad", "5", 5, of_forces(&ForceSpec::spring_rate), forces(face)},
        {"forces.spring_rate_nm_deg", "5", 900 / pi, of_forces(&ForceSpec::spring_rate), forces(arm)},
        {"forces.preload_n", "-20", -20, of_forces(&ForceSpec::preload), forces(roller)},
        {"forces.preload_nm", "2", 2, of_forces(&ForceSpec::preload), forces(arm)},
        {"forces.contact_width_mm", "10", 0.01, width, forces(roller)},
        {"forces.contact_width_in", "0.5", 0.0127, width, forces(roller)},
        {"forces.contact_width_m", "0.02", 0.02, width, forces(roller)},
        {"forces.cam_modulus_gpa", "200", 200e9, of_forces(&ForceSpec::cam_modulus), forces(roller)},
        {"forces.cam_modulus_mpa", "200", 200e6, of_forces(&ForceSpec::cam_modulus), forces(roller)},
        {"forces.cam_modulus_pa", "2e11", 2e11, of_forces(&ForceSpec::cam_modulus), forces(roller)},
        {"forces.follower_modulus_gpa", "100", 100e9, of_forces(&ForceSpec::follower_modulus),
         forces(roller)},
        {"forces.follower_modulus_mpa", "1e5", 1e11, of_forces(&ForceSpec::follower_modulus), forces(roller)},
        {"forces.follower_modulus_pa", "1e11", 1e11, of_forces(&ForceSpec::follower_modulus), forces(roller)},
        {"forces.cam_poisson", "0.25", 0.25, of_forces(&ForceSpec::cam_poisson), forces(roller)},
        {"forces.follower_poisson", "0", 0, of_forces(&ForceSpec::follower_poisson), forces(roller)},
        {"forces.speed_range_rpm", "[0, 6000]", 200 * pi, fastest, spring},
        {"forces.speed_range_rad_s", "[0, 700]", 700, fastest, spring},
        {"forces.spring_frequency_hz", "40", 80 * pi, frequency, spring},
        {"forces.spring_frequency_rad_s", "250", 250, frequency, turned},
        {"limits.spring_harmonic_um", "20", 2e-5, harmonic, surge},
        {"limits.spring_harmonic_mm", "0.02", 2e-5, harmonic, surge},
        {"limits.spring_harmonic_in", "0.001", 2.54e-5, harmonic, surge},
        {"limits.spring_harmonic_deg", "0.9", pi / 200, harmonic, surge_of_arm},
        {"limits.spring_harmonic_rad", "0.01", 0.01, harmonic, surge_of_arm},
        {"limits.spring_harmonics", "7", 7, [](const Scene& s) { return s.limits.spring_harmonics[1]; },
         surge},
        {"limits.spring_harmonics", "{ min = 7, max = 9 }", 9,
         [](const Scene& s) { return s.limits.spring_harmonics[1]; }, surge},
    };
}

std::vector<KeyCase> dimension_weight_cases() {
    using namespace cam_key_cases;
    const auto weight = [](DimensionIndex index) {
        return [index](const Scene& s) { return s.objective.dimensions.at(static_cast<std::size_t>(index)); };
    };
    return {
        {"objective.base_radius", "0.1", 0.1, weight(base_radius), cam(flat)},
        {"objective.roller_radius", "0.2", 0.2, weight(roller_radius), cam(roller)},
        {"objective.offset", "0.3", 0.3, weight(offset), cam(knife)},
        {"objective.center_distance", "0.4", 0.4, weight(center_distance), cam(arm)},
        {"objective.arm_length", "0.5", 0.5, weight(arm_length), cam(arm)},
        {"objective.face_offset", "0.6", 0.6, weight(face_offset), cam(face)},
    };
}

std::vector<KeyCase> cam_limit_cases() {
    using namespace cam_key_cases;
    const std::string width = forces(roller) + "forces.contact_width_mm = 10\n";
    const std::string mass = forces(roller) + "forces.mass_kg = 1\n";
    const std::string inertia = forces(arm) + "forces.inertia_kg_m2 = 1\n";
    return {
        {"limits.pressure_angle_deg", "30", pi / 6, of_limit(&LimitSpec::pressure_angle), cam(roller)},
        {"limits.pressure_angle_rad", "0.5", 0.5, of_limit(&LimitSpec::pressure_angle), cam(flat)},
        {"limits.rise_pressure_angle_deg", "45", pi / 4, of_limit(&LimitSpec::rise_pressure_angle), cam(arm)},
        {"limits.rise_pressure_angle_rad", "1", 1, of_limit(&LimitSpec::rise_pressure_angle), cam(arm)},
        {"limits.return_pressure_angle_deg", "45", pi / 4, of_limit(&LimitSpec::return_pressure_angle),
         cam(face)},
        {"limits.return_pressure_angle_rad", "1", 1, of_limit(&LimitSpec::return_pressure_angle), cam(face)},
        {"limits.cam_radius_min_mm", "2", 0.002, of_limit(&LimitSpec::cam_radius_min), cam(roller)},
        {"limits.cam_radius_min_in", "0.5", 0.0127, of_limit(&LimitSpec::cam_radius_min), cam(flat)},
        {"limits.cam_radius_min_m", "0", 0, of_limit(&LimitSpec::cam_radius_min), cam(face)},
        {"limits.concave_radius_min_mm", "12", 0.012, of_limit(&LimitSpec::concave_radius_min), cam(roller)},
        {"limits.concave_radius_min_in", "1", 0.0254, of_limit(&LimitSpec::concave_radius_min), cam(arm)},
        {"limits.concave_radius_min_m", "0.05", 0.05, of_limit(&LimitSpec::concave_radius_min), cam(knife)},
        {"limits.undercut_margin", "0.2", 0.2, of_limit(&LimitSpec::undercut_margin), cam(flat)},
        {"limits.contact_force_min_n", "10", 10, of_limit(&LimitSpec::contact_force_min), mass},
        {"limits.contact_force_min_lbf", "1", 4.4482216152605, of_limit(&LimitSpec::contact_force_min), mass},
        {"limits.contact_moment_min_lbf_in", "1", 0.1129848290276167, of_limit(&LimitSpec::contact_force_min),
         inertia},
        {"limits.torque_max_lbf_in", "1", 0.1129848290276167, of_limit(&LimitSpec::torque_max), mass},
        {"limits.hertz_pressure_max_ksi", "100", 689475729.3168361, of_limit(&LimitSpec::hertz_pressure_max),
         width},
        {"limits.contact_moment_min_nm", "0.5", 0.5, of_limit(&LimitSpec::contact_force_min), inertia},
        {"limits.torque_max_nm", "25", 25, of_limit(&LimitSpec::torque_max), mass},
        {"limits.hertz_pressure_max_mpa", "1200", 1.2e9, of_limit(&LimitSpec::hertz_pressure_max), width},
        {"limits.hertz_pressure_max_gpa", "1.2", 1.2e9, of_limit(&LimitSpec::hertz_pressure_max), width},
        {"limits.hertz_pressure_max_pa", "1.2e9", 1.2e9, of_limit(&LimitSpec::hertz_pressure_max), width},
    };
}

}  // namespace camopt::input

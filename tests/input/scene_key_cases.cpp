// SPDX-License-Identifier: MIT
#include "tests/input/scene_key_cases.hpp"

#include <numbers>

namespace camopt::input {
namespace scene_key_cases {

constexpr double pi = std::numbers::pi;
const std::string rr = "motion.type = \"RR\"\n";

double lift(const Scene& s) {
    return s.motion.lift;
}
double is_angle(const Scene& s) {
    return s.motion.lift_is_angle ? 1.0 : 0.0;
}
double rise(const Scene& s) {
    return s.motion.rise;
}
double return_angle(const Scene& s) {
    return s.motion.return_angle.value();
}
double speed(const Scene& s) {
    return s.motion.speed.value();
}
double velocity_cap(const Scene& s) {
    return s.limits.velocity.value().normalised;
}
double acceleration_cap(const Scene& s) {
    return s.limits.acceleration.value().normalised;
}
double jerk_cap(const Scene& s) {
    return s.limits.jerk.value().normalised;
}

}  // namespace scene_key_cases

std::vector<KeyCase> dimension_cases(const std::string& key, bool is_angle,
                                     const std::function<double(const Scene&)>& got,
                                     const std::string& rest) {
    using namespace scene_key_cases;
    if (is_angle) return {{key + "_deg", "45", pi / 4, got, rest}, {key + "_rad", "0.5", 0.5, got, rest}};
    return {{key + "_mm", "120", 0.12, got, rest},
            {key + "_in", "2", 0.0508, got, rest},
            {key + "_m", "0.25", 0.25, got, rest}};
}

std::vector<KeyCase> motion_cases() {
    using namespace scene_key_cases;
    return {
        {"title", "\"x\"", 1, [](const Scene& s) { return s.title == "x" ? 1.0 : 0.0; }},
        {"motion.type", "\"RR\"", 1,
         [](const Scene& s) { return s.motion.type == MotionType::rr ? 1.0 : 0.0; }},
        {"motion.lift_mm", "10", 0.01, lift},
        {"motion.lift_in", "2", 0.0508, lift},
        {"motion.lift_m", "0.5", 0.5, lift},
        {"motion.lift_m", "0.5", 0, is_angle},
        {"motion.lift_deg", "30", pi / 6, lift},
        {"motion.lift_rad", "0.5", 0.5, lift},
        {"motion.lift_rad", "0.5", 1, is_angle},
        {"motion.rise_deg", "90", pi / 2, rise},
        {"motion.rise_deg", "360", 2 * pi, rise},
        {"motion.rise_rad", "6.283185307179586", 2 * pi, rise},
        {"motion.rise_crank_deg", "360", pi, rise},
        {"motion.return_crank_deg", "90", pi / 4, return_angle, rr},
        {"motion.stops", "8", pi / 4, lift},
        {"motion.return_deg", "45", pi / 4, return_angle, rr},
        {"motion.return_rad", "0.5", 0.5, return_angle, rr},
        {"motion.speed_rpm", "300", 10 * pi, speed},
        {"motion.speed_rad_s", "7", 7, speed},
        {"motion.symmetric", "true", 1, [](const Scene& s) { return s.motion.symmetric ? 1.0 : 0.0; }},
        {"motion.via", "[{ at = 0.5, velocity = 1 }]", 1,
         [](const Scene& s) { return double(s.motion.via.size()); }},
    };
}

std::vector<KeyCase> spline_cases() {
    using namespace scene_key_cases;
    return {
        {"spline.degree", "5", 5, [](const Scene& s) { return double(s.spline.degree); }},
        {"spline.segments", "65536", 65536, [](const Scene& s) { return double(s.spline.segments); }},
        {"spline.breakpoints", "[0, 0.25, 1]", 0.25,
         [](const Scene& s) { return s.spline.breakpoints.at(1); }},
        {"spline.knots", "\"free\"", 1, [](const Scene& s) { return s.spline.free_knots ? 1.0 : 0.0; }},
        {"spline.continuity", "3", 3, [](const Scene& s) { return double(s.spline.smoothness()); },
         "spline.degree = 5\n"},
        {"spline.end_jerk", "\"zero\"", 1,
         [](const Scene& s) { return s.spline.end_jerk == EndJerk::zero ? 1.0 : 0.0; },
         "spline.degree = 5\n"},
        {"spline.design", "\"states\"", 1,
         [](const Scene& s) { return s.spline.design == DesignKind::states ? 1.0 : 0.0; }},
    };
}

std::vector<KeyCase> objective_cases() {
    using namespace scene_key_cases;
    const std::string table = "objective.reference.";
    const std::string deviates =
        "motion.rise_rad = 2\nmotion.lift_mm = 20\nmeasured.step_rad = 0.28571\n"
        "measured.s_mm = [0, 1, 3, 7, 12, 17, 19, 20]\n";
    return {
        {"objective.velocity", "0.25", 0.25, [](const Scene& s) { return s.objective.velocity; }},
        {"objective.acceleration", "2", 2, [](const Scene& s) { return s.objective.acceleration; }},
        {"objective.jerk", "0.5", 0.5, [](const Scene& s) { return s.objective.jerk; }},
        {"objective.rms_acceleration", "3", 3, [](const Scene& s) { return s.objective.rms_acceleration; }},
        {"objective.rms_jerk", "4", 4, [](const Scene& s) { return s.objective.rms_jerk; }},
        {"objective.area", "0.5", 0.5, [](const Scene& s) { return s.objective.area; }},
        {table + "area", "0.4", 0.4, [](const Scene& s) { return s.objective.reference.area.value(); }},
        {"objective.deviation", "0.5", 0.5, [](const Scene& s) { return s.objective.deviation; }, deviates},
        {"objective.deviation_rms", "0.5", 0.5, [](const Scene& s) { return s.objective.deviation_rms; },
         deviates},
        {table + "deviation", "0.4", 0.4,
         [](const Scene& s) { return s.objective.reference.deviation.value(); }},
        {table + "deviation_rms", "0.4", 0.4,
         [](const Scene& s) { return s.objective.reference.deviation_rms.value(); }},
        {"objective.torque", "0.75", 0.75, [](const Scene& s) { return s.objective.torque; }},
        {"objective.reference", "\"cycloidal\"", 1,
         [](const Scene& s) { return s.objective.reference.law == "cycloidal" ? 1.0 : 0.0; }},
        {"objective.tie_break", "\"none\"", 1,
         [](const Scene& s) { return s.objective.tie_break == TieBreak::none ? 1.0 : 0.0; }},
        {table + "velocity", "1.76", 1.76,
         [](const Scene& s) { return s.objective.reference.velocity.value(); }},
        {table + "acceleration", "5.53", 5.53,
         [](const Scene& s) { return s.objective.reference.acceleration.value(); }},
        {table + "jerk", "69", 1, [](const Scene& s) { return s.objective.reference.numeric ? 1.0 : 0.0; }},
        {table + "jerk", "69", 69, [](const Scene& s) { return s.objective.reference.jerk.value(); }},
        {table + "rms_acceleration", "4", 4,
         [](const Scene& s) { return s.objective.reference.rms_acceleration.value(); }},
        {table + "rms_jerk", "5", 5, [](const Scene& s) { return s.objective.reference.rms_jerk.value(); }},
        {table + "torque", "6", 6, [](const Scene& s) { return s.objective.reference.torque.value(); }},
    };
}

// Lift 20 mm (or 0.5 rad), rise 2 rad, speed 10 rad/s: lift·ω/β = 0.1 m/s, lift (ω/β)² = 0.5, lift (ω/β)³
// = 2.5.
std::vector<KeyCase> limit_cases() {
    using namespace scene_key_cases;
    const std::string length = "motion.lift_mm = 20\nmotion.rise_rad = 2\nmotion.speed_rad_s = 10\n";
    const std::string angle = "motion.lift_rad = 0.5\nmotion.rise_rad = 2\nmotion.speed_rad_s = 10\n";
    return {
        {"limits.velocity", "1.8", 1.8, velocity_cap},
        {"limits.velocity_mm_s", "180", 1.8, velocity_cap, length},
        {"limits.velocity_in_s", "10", 2.54, velocity_cap, length},
        {"limits.velocity_m_s", "0.2", 2, velocity_cap, length},
        {"limits.velocity_deg_s", "180", pi / 2.5, velocity_cap, angle},
        {"limits.velocity_rad_s", "5", 2, velocity_cap, angle},
        {"limits.acceleration", "5", 5, acceleration_cap},
        {"limits.acceleration_mm_s2", "3000", 6, acceleration_cap, length},
        {"limits.acceleration_in_s2", "100", 5.08, acceleration_cap, length},
        {"limits.acceleration_m_s2", "3", 6, acceleration_cap, length},
        {"limits.acceleration_deg_s2", "1800", 10 * pi / 12.5, acceleration_cap, angle},
        {"limits.acceleration_rad_s2", "50", 4, acceleration_cap, angle},
        {"limits.velocity_mm_deg", "0.5", 9 / pi, velocity_cap, length},
        {"limits.velocity_in_deg", "0.01", 0.254 * 18 / pi, velocity_cap, length},
        {"limits.velocity_deg_deg", "0.5", 2, velocity_cap, angle},
        {"limits.acceleration_mm_deg2", "0.002", 0.0004 * 180 * 180 / pi / pi, acceleration_cap, length},
        {"limits.acceleration_in_deg2", "0.0001", 0.000508 * 180 * 180 / pi / pi, acceleration_cap, length},
        {"limits.acceleration_deg_deg2", "0.01", 1.8 / pi / 0.125, acceleration_cap, angle},
        {"limits.jerk_mm_deg3", "0.001", 0.0004 * 180 * 180 * 180 / pi / pi / pi, jerk_cap, length},
        {"limits.jerk_in_deg3", "0.0001", 0.001016 * 180 * 180 * 180 / pi / pi / pi, jerk_cap, length},
        {"limits.jerk_deg_deg3", "0.01", 0.01 * 180 * 180 / pi / pi * 16, jerk_cap, angle},
        {"limits.jerk", "60", 60, jerk_cap},
        {"limits.jerk_mm_s3", "100000", 40, jerk_cap, length},
        {"limits.jerk_in_s3", "10000", 101.6, jerk_cap, length},
        {"limits.jerk_m_s3", "100", 40, jerk_cap, length},
        {"limits.jerk_deg_s3", "180000", 1000 * pi / 62.5, jerk_cap, angle},
        {"limits.jerk_rad_s3", "2500", 40, jerk_cap, angle},
    };
}

std::vector<KeyCase> solver_cases() {
    using namespace scene_key_cases;
    return {
        {"solver.name", "\"ipopt\"", 1, [](const Scene& s) { return s.solver.name == "ipopt" ? 1.0 : 0.0; }},
        {"solver.tolerance", "1e-8", 1e-8, [](const Scene& s) { return s.solver.tolerance; }},
        {"solver.gap", "1e-6", 1e-6, [](const Scene& s) { return s.solver.gap.value_or(0.0); }},
        {"solver.max_seconds", "5", 5, [](const Scene& s) { return s.solver.max_seconds; }},
        {"solver.explain_seconds", "2.5", 2.5, [](const Scene& s) { return s.solver.explain_seconds; }},
        {"solver.explain_changes", "7", 7, [](const Scene& s) { return double(s.solver.explain_changes); }},
        {"solver.starts", "8", 8, [](const Scene& s) { return double(s.solver.starts.value_or(0)); }},
        {"solver.seed", "4294967295", 4294967295.0, [](const Scene& s) { return double(s.solver.seed); }},
        {"solver.options", "{ a = 1, b = 0.5, c = true, d = \"e\" }", 4,
         [](const Scene& s) { return double(s.solver.options.size()); }},
    };
}

}  // namespace camopt::input

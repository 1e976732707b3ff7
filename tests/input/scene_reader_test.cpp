// SPDX-License-Identifier: MIT
// Every key in every unit arrives in the Scene; what is absent keeps its default; overrides replace.
#include "input/scene_reader.hpp"

#include "input/scene_keys.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <set>

namespace camopt::input {
namespace {

constexpr double pi = std::numbers::pi;
const KnownNames known = {.laws = {"cycloidal", "modified_sine"},
                          .solvers = {"ipopt", "nlopt.slsqp", "structured"}};
const std::string drd = "motion.type = \"DRD\"\n";
const std::string rr = "motion.type = \"RR\"\n";
const std::string jerk_only = "objective.jerk = 1\n";

Scene read(const std::string& toml, const std::vector<std::string>& overrides = {}) {
    return read_scene(toml, "s.toml", known, overrides);
}

struct KeyCase {
    std::string key;    ///< "motion.lift_mm"
    std::string value;  ///< TOML
    double expected;    ///< in the unit of the Scene
    std::function<double(const Scene&)> got;
    std::string rest = {};  ///< what the key needs beside it
};

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

std::vector<KeyCase> motion_cases() {
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
        {"motion.return_deg", "45", pi / 4, return_angle, rr},
        {"motion.return_rad", "0.5", 0.5, return_angle, rr},
        {"motion.speed_rpm", "300", 10 * pi, speed},
        {"motion.speed_rad_s", "7", 7, speed},
        {"motion.symmetric", "true", 1, [](const Scene& s) { return s.motion.symmetric ? 1.0 : 0.0; }},
        {"motion.via", "[{ at = 0.5, velocity = 1 }]", 1,
         [](const Scene& s) { return double(s.motion.via.size()); }},
        {"motion.via.at", "0.25", 0.25, [](const Scene& s) { return s.motion.via.at(0).at; }},
        {"motion.via.displacement", "0.2", 0.2,
         [](const Scene& s) { return s.motion.via.at(0).displacement.value(); }},
        {"motion.via.velocity", "-3", -3, [](const Scene& s) { return s.motion.via.at(0).velocity.value(); }},
        {"motion.via.acceleration", "0", 0,
         [](const Scene& s) { return s.motion.via.at(0).acceleration.value(); }},
    };
}

std::vector<KeyCase> spline_cases() {
    return {
        {"spline.degree", "5", 5, [](const Scene& s) { return double(s.spline.degree); }},
        {"spline.segments", "65536", 65536, [](const Scene& s) { return double(s.spline.segments); }},
        {"spline.breakpoints", "[0, 0.25, 1]", 0.25,
         [](const Scene& s) { return s.spline.breakpoints.at(1); }},
        {"spline.knots", "\"fixed\"", 12, [](const Scene& s) { return double(s.spline.segments); }},
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
    const std::string table = "objective.reference.";
    return {
        {"objective.velocity", "0.25", 0.25, [](const Scene& s) { return s.objective.velocity; }},
        {"objective.acceleration", "2", 2, [](const Scene& s) { return s.objective.acceleration; }},
        {"objective.jerk", "0.5", 0.5, [](const Scene& s) { return s.objective.jerk; }},
        {"objective.rms_acceleration", "3", 3, [](const Scene& s) { return s.objective.rms_acceleration; }},
        {"objective.rms_jerk", "4", 4, [](const Scene& s) { return s.objective.rms_jerk; }},
        {"objective.torque", "0", 1, [](const Scene& s) { return s.objective.jerk; }},
        {"objective.base_radius", "0.0", 1, [](const Scene& s) { return s.objective.jerk; }},
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
        {table + "torque", "6", 1, [](const Scene& s) { return s.objective.jerk; }},
    };
}

// Lift 20 mm (or 0.5 rad), rise 2 rad, speed 10 rad/s: lift·ω/β = 0.1 m/s, lift (ω/β)² = 0.5, lift (ω/β)³
// = 2.5.
std::vector<KeyCase> limit_cases() {
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
        {"limits.jerk", "60", 60, jerk_cap},
        {"limits.jerk_mm_s3", "100000", 40, jerk_cap, length},
        {"limits.jerk_in_s3", "10000", 101.6, jerk_cap, length},
        {"limits.jerk_m_s3", "100", 40, jerk_cap, length},
        {"limits.jerk_deg_s3", "180000", 1000 * pi / 62.5, jerk_cap, angle},
        {"limits.jerk_rad_s3", "2500", 40, jerk_cap, angle},
    };
}

std::vector<KeyCase> solver_cases() {
    return {
        {"solver.name", "\"ipopt\"", 1, [](const Scene& s) { return s.solver.name == "ipopt" ? 1.0 : 0.0; }},
        {"solver.tolerance", "1e-8", 1e-8, [](const Scene& s) { return s.solver.tolerance; }},
        {"solver.gap", "1e-6", 1e-6, [](const Scene& s) { return s.solver.gap; }},
        {"solver.max_seconds", "5", 5, [](const Scene& s) { return s.solver.max_seconds; }},
        {"solver.starts", "8", 8, [](const Scene& s) { return double(s.solver.starts.value_or(0)); }},
        {"solver.seed", "4294967295", 4294967295.0, [](const Scene& s) { return double(s.solver.seed); }},
        {"solver.options", "{ a = 1, b = 0.5, c = true, d = \"e\" }", 4,
         [](const Scene& s) { return double(s.solver.options.size()); }},
    };
}

std::vector<KeyCase> key_cases() {
    std::vector<KeyCase> all;
    for (const auto& part :
         {motion_cases(), spline_cases(), objective_cases(), limit_cases(), solver_cases()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// The smallest scene that holds the key.
std::string scene_with(const KeyCase& c) {
    const std::string via = "motion.via.";
    std::string toml = c.rest;
    if (c.key.starts_with(via))
        toml += "motion.via = [{ " + std::string(c.key == via + "at" ? "velocity = 1, " : "at = 0.5, ") +
                c.key.substr(via.size()) + " = " + c.value + " }]\n";
    else
        toml += c.key + " = " + c.value + "\n";
    if (c.key != "motion.type" && c.rest != rr) toml += drd;
    if (c.key.starts_with("objective.reference.") && !c.key.ends_with(".jerk"))
        toml += "objective.reference.jerk = 69\n";
    return c.key == "objective.jerk" ? toml : toml + jerk_only;
}

TEST(SceneReader, EveryKeyArrivesInSiUnits) {
    for (const KeyCase& c : key_cases()) {
        SCOPED_TRACE(c.key);
        EXPECT_NEAR(c.got(read(scene_with(c))), c.expected, 1e-13 * std::abs(c.expected));
    }
}

TEST(SceneReader, EveryKeyOfTheTableIsTried) {
    std::set<std::string> tried, written;
    for (const KeyCase& c : key_cases()) tried.insert(c.key);
    for (const KeyRow& row : scene_keys()) {
        const bool refused =
            row.availability == Availability::later || row.availability == Availability::needs_cam;
        if (refused || row.type == KeyType::table) continue;
        for (const Spelling& spelling : row.spellings)
            written.insert((row.table.empty() ? "" : std::string(row.table) + ".") + row.key(spelling));
    }
    EXPECT_EQ(tried, written);
}

TEST(SceneReader, AbsentKeysKeepTheDefaultsOfTheScene) {
    const Scene scene = read(drd + jerk_only);
    EXPECT_EQ(scene.title, "");
    EXPECT_EQ(scene.motion.lift, 1e-3);
    EXPECT_FALSE(scene.motion.lift_is_angle);
    EXPECT_DOUBLE_EQ(scene.motion.rise, pi);
    EXPECT_FALSE(scene.motion.return_angle || scene.motion.speed || scene.motion.symmetric);
    EXPECT_EQ(scene.spline.degree, 3);
    EXPECT_EQ(scene.spline.segments, 12);
    EXPECT_EQ(scene.spline.smoothness(), 2);
    EXPECT_EQ(scene.objective.velocity, 0.0);
    EXPECT_EQ(scene.objective.reference.law, "modified_sine");
    EXPECT_FALSE(scene.objective.reference.numeric);
    EXPECT_EQ(scene.objective.tie_break, TieBreak::rms_jerk);
    EXPECT_FALSE(scene.limits.velocity || scene.limits.acceleration || scene.limits.jerk);
    EXPECT_EQ(scene.solver.name, "auto");
    EXPECT_EQ(scene.solver.tolerance, 1e-9);
    EXPECT_EQ(scene.solver.gap, 1e-7);
    EXPECT_EQ(scene.solver.max_seconds, 60.0);
    EXPECT_TRUE(scene.solver.options.empty());
}

TEST(SceneReader, ALimitRemembersHowItWasWritten) {
    const Scene scene =
        read(drd + jerk_only + "motion.lift_mm = 20\nmotion.speed_rad_s = 10\nlimits.velocity_in_s = 10\n");
    const PeakLimit& limit = scene.limits.velocity.value();
    EXPECT_EQ(limit.key, "limits.velocity_in_s");
    EXPECT_EQ(limit.given, 10.0);
    EXPECT_EQ(limit.unit, "in/s");
    EXPECT_NEAR(limit.unit_per_normalised(), 0.02 * 10 / pi / 0.0254, 1e-12);
}

TEST(SceneReader, OptionsKeepTheirTypes) {
    const auto options =
        read(drd + jerk_only + "[solver.options]\na = 1\nb = 0.5\nc = true\nd = \"e\"\n").solver.options;
    EXPECT_EQ(std::get<long long>(options.at("a")), 1);
    EXPECT_EQ(std::get<double>(options.at("b")), 0.5);
    EXPECT_EQ(std::get<bool>(options.at("c")), true);
    EXPECT_EQ(std::get<std::string>(options.at("d")), "e");
}

TEST(Overrides, ReplaceAddAndTakeBareWords) {
    const Scene scene =
        read(drd + jerk_only, {"motion.type=RR", "motion.rise_deg = 90", "solver.name=nlopt.slsqp",
                               "solver.options.max_iter=7", "title=\"two words\""});
    EXPECT_EQ(scene.motion.type, MotionType::rr);
    EXPECT_DOUBLE_EQ(scene.motion.rise, pi / 2);
    EXPECT_EQ(scene.solver.name, "nlopt.slsqp");
    EXPECT_EQ(std::get<long long>(scene.solver.options.at("max_iter")), 7);
    EXPECT_EQ(scene.title, "two words");
}

TEST(Overrides, ReplaceEveryOtherWayToSayTheSame) {
    const std::string toml = drd + jerk_only + "motion.lift_in = 1\nspline.breakpoints = [0, 0.5, 1]\n";
    const Scene scene = read(toml, {"motion.lift_mm=4", "spline.segments=24"});
    EXPECT_DOUBLE_EQ(scene.motion.lift, 0.004);
    EXPECT_TRUE(scene.spline.breakpoints.empty());
    EXPECT_EQ(scene.spline.segments, 24);
    EXPECT_DOUBLE_EQ(read(toml, {"motion.lift_mm=4", "motion.lift_mm=5"}).motion.lift, 0.005);
}

TEST(Overrides, MendABrokenFile) {
    EXPECT_EQ(read(drd + jerk_only + "spline.degree = 4\n", {"spline.degree=5"}).spline.degree, 5);
}

}  // namespace
}  // namespace camopt::input

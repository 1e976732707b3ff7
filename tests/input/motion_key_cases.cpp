// SPDX-License-Identifier: MIT
// Set points of the whole motion and of segments, and measured motions: every key in every unit.
#include "tests/input/scene_key_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt::input {
namespace motion_key_cases {

constexpr double pi = std::numbers::pi;

// Lift 20 mm (or 0.5 rad) over 2 rad at 10 rad/s: lift/β = 10 mm/rad, lift·ω/β = 0.1 m/s, lift (ω/β)² = 0.5
// m/s².
const std::string of_length = "motion.lift_mm = 20\nmotion.speed_rad_s = 10\n";
const std::string of_angle = "motion.lift_rad = 0.5\nmotion.speed_rad_s = 10\n";

struct Written {
    const char* key;
    const char* value;
    double expected;
    bool swings = false;
};

using Got = std::function<double(const SetPoint&)>;

const std::vector<Written> velocities = {
    {"velocity", "-3", -3},
    {"velocity_mm_s", "150", 1.5},
    {"velocity_in_s", "10", 2.54},
    {"velocity_m_s", "-0.2", -2},
    {"velocity_deg_s", "180", pi / 2.5, true},
    {"velocity_rad_s", "5", 2, true},
    {"velocity_mm_rad", "15", 1.5},
    {"velocity_in_rad", "1", 2.54},
    {"velocity_m_rad", "0.02", 2},
    {"velocity_mm_deg", "0.5", 9 / pi},
    {"velocity_in_deg", "0.01", 0.254 * 18 / pi},
    {"velocity_deg_deg", "0.5", 2, true},
    {"velocity_rad_rad", "0.25", 1, true},
};
const std::vector<Written> accelerations = {
    {"acceleration", "0", 0},
    {"acceleration_mm_s2", "3000", 6},
    {"acceleration_in_s2", "100", 5.08},
    {"acceleration_m_s2", "-3", -6},
    {"acceleration_deg_s2", "1800", 10 * pi / 12.5, true},
    {"acceleration_rad_s2", "50", 4, true},
    {"acceleration_mm_rad2", "10", 2},
    {"acceleration_in_rad2", "1", 5.08},
    {"acceleration_m_rad2", "0.01", 2},
    {"acceleration_mm_deg2", "0.002", 0.0004 * 180 * 180 / pi / pi},
    {"acceleration_in_deg2", "0.0001", 0.000508 * 180 * 180 / pi / pi},
    {"acceleration_deg_deg2", "0.01", 1.8 / pi / 0.125, true},
    {"acceleration_rad_rad2", "0.25", 2, true},
};
const std::vector<Written> jerks = {
    {"jerk", "7", 7},
    {"jerk_mm_s3", "5000", 2},
    {"jerk_in_s3", "100", 1.016},
    {"jerk_m_s3", "-5", -2},
    {"jerk_deg_s3", "9000", 50 * pi / 62.5, true},
    {"jerk_rad_s3", "125", 2, true},
    {"jerk_mm_rad3", "5", 2},
    {"jerk_in_rad3", "1", 10.16},
    {"jerk_m_rad3", "0.01", 4},
    {"jerk_rad_rad3", "0.25", 4, true},
};

/// Velocity and acceleration at an end.
std::vector<KeyCase> end_cases(const std::string& table, const std::string& rest,
                               const std::function<const SetPoint&(const Scene&)>& point) {
    std::vector<KeyCase> all;
    for (const auto* list : {&velocities, &accelerations})
        for (const Written& w : *list)
            all.push_back({table + "." + w.key, w.value, w.expected,
                           [=, velocity = list == &velocities](const Scene& scene) {
                               const SetPoint& state = point(scene);
                               return velocity ? state.velocity.value() : state.acceleration.value();
                           },
                           rest + (w.swings ? of_angle : of_length)});
    return all;
}

/// The larger bound is the written number, the other is missing.
std::vector<KeyCase> corridor_cases() {
    const std::vector<Written> displacements = {{"displacement", "0.2", 0.2},
                                                {"displacement_mm", "5", 0.25},
                                                {"displacement_in", "0.5", 0.635},
                                                {"displacement_m", "0.01", 0.5},
                                                {"displacement_deg", "18", pi / 5, true},
                                                {"displacement_rad", "0.125", 0.25, true}};
    const std::vector<const std::vector<Written>*> lists = {&displacements, &velocities, &accelerations,
                                                            &jerks};
    std::vector<KeyCase> all;
    for (std::size_t order = 0; order < lists.size(); ++order)
        for (const Written& w : *lists[order])
            all.push_back({std::string("motion.corridor.") + w.key, std::string("{ max = ") + w.value + " }",
                           w.expected,
                           [order](const Scene& scene) {
                               const Corridor::Bounds& own = scene.motion.corridors.at(0).bounds.at(order);
                               return own.least ? -1e9 : own.most.value();
                           },
                           "motion.rise_rad = 2\n" + (w.swings ? of_angle : of_length)});
    const auto from = [](const Scene& scene) { return scene.motion.corridors.at(0).from; };
    const auto to = [](const Scene& scene) { return scene.motion.corridors.at(0).to; };
    const std::string motion = "motion.rise_rad = 2\n";
    for (const KeyCase& one :
         {KeyCase{"from_deg", "45", pi / 4, from, motion}, KeyCase{"from_rad", "0.5", 0.5, from, motion},
          KeyCase{"to_deg", "90", pi / 2, to, motion}, KeyCase{"to_rad", "1.5", 1.5, to, motion}})
        all.push_back({"motion.corridor." + one.key, one.value, one.expected, one.got, one.rest});
    all.push_back({"motion.corridor", "[{ displacement = { min = 0 } }]", 1,
                   [](const Scene& scene) { return double(scene.motion.corridors.size()); }, motion});
    return all;
}

std::vector<KeyCase> point_cases(const std::string& table, const std::string& rest,
                                 const std::function<const SetPoint&(const Scene&)>& point) {
    std::vector<KeyCase> all = end_cases(table, rest, point);
    const auto add = [&](const Written& written, const Got& got) {
        all.push_back({table + "." + written.key, written.value, written.expected,
                       [=](const Scene& scene) { return got(point(scene)); },
                       rest + (written.swings ? of_angle : of_length)});
    };
    const Got at = [](const SetPoint& p) { return p.at; };
    for (const Written& w : {Written{"at", "0.25", 0.25}, Written{"at_deg", "45", pi / 8},
                             Written{"at_rad", "0.5", 0.25}, Written{"at_crank_deg", "90", pi / 8},
                             Written{"from", "0.25", 0.25}, Written{"from_deg", "45", pi / 8},
                             Written{"from_rad", "0.5", 0.25}, Written{"from_crank_deg", "90", pi / 8}})
        add(w, at);
    const Got until = [](const SetPoint& p) { return p.until.value(); };
    for (const Written& w : {Written{"to", "0.75", 0.75}, Written{"to_deg", "90", pi / 4},
                             Written{"to_rad", "1.25", 0.625}, Written{"to_crank_deg", "180", pi / 4}})
        add(w, until);
    const Got displacement = [](const SetPoint& p) { return p.displacement.value(); };
    for (const Written& w :
         {Written{"displacement", "0.2", 0.2}, Written{"displacement_mm", "5", 0.25},
          Written{"displacement_in", "0.5", 0.635}, Written{"displacement_m", "0.01", 0.5},
          Written{"displacement_deg", "18", pi / 5, true}, Written{"displacement_rad", "0.125", 0.25, true}})
        add(w, displacement);
    return all;
}

/// Of a cam under a knife edge, every 5 deg: 20 mm over 2 rad, dwell, return. In the unit.
std::string cam_points(const std::function<double(double radius, double angle)>& of) {
    std::string text;
    for (int i = 0; i < 72; ++i) {
        const double theta = i * pi / 36.0;
        const double lift = theta < 2.0   ? theta / 2.0
                            : theta < 4.5 ? 1.0
                                          : (2.0 * pi - theta) / (2.0 * pi - 4.5);
        text += fmt::format("{}{:.17g}", i == 0 ? "[" : ", ", of(0.04 + 0.02 * lift, pi / 2.0 - theta));
    }
    return text + "]";
}

}  // namespace motion_key_cases

std::vector<KeyCase> set_point_cases() {
    using namespace motion_key_cases;
    std::vector<KeyCase> all =
        point_cases("motion.via", "motion.rise_rad = 2\n",
                    [](const Scene& scene) -> const SetPoint& { return scene.motion.via.at(0); });
    const std::vector<KeyCase> segments = point_cases(
        "motion.segments.via", "motion.type = \"program\"\nmotion.closed = false\n",
        [](const Scene& scene) -> const SetPoint& { return scene.motion.segments.at(0).via.at(0); });
    all.insert(all.end(), segments.begin(), segments.end());
    for (const std::vector<KeyCase>& more :
         {end_cases("motion.start", "motion.rise_rad = 2\n",
                    [](const Scene& scene) -> const SetPoint& { return scene.motion.start.value(); }),
          end_cases("motion.end", "motion.rise_rad = 2\n",
                    [](const Scene& scene) -> const SetPoint& { return scene.motion.end.value(); }),
          end_cases(
              "motion.segments.end", "motion.type = \"program\"\nmotion.closed = false\n",
              [](const Scene& scene) -> const SetPoint& { return scene.motion.segments.at(0).end.value(); }),
          corridor_cases()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back({"motion.segments.via", "[{ at = 0.5, velocity = 1 }]", 1,
                   [](const Scene& scene) { return double(scene.motion.segments.at(0).via.size()); },
                   "motion.type = \"program\"\nmotion.closed = false\n"});
    return all;
}

std::vector<KeyCase> measured_cases() {
    using namespace motion_key_cases;
    const std::string motion = "motion.rise_rad = 2\nmotion.lift_mm = 20\n";
    const std::string swing = "motion.rise_rad = 2\nmotion.lift_rad = 0.5\n";
    const std::string theta = "measured.theta_rad = [0, 0.2, 0.5, 0.8, 1.1, 1.4, 1.7, 2]\n";
    const std::string s = "measured.s_mm = [0, 1, 3, 7, 12, 17, 19, 20]\n";
    const auto angle = [](const Scene& scene) { return scene.measured.value().angle.at(3); };
    const auto displacement = [](const Scene& scene) { return scene.measured.value().displacement.at(3); };
    const std::string both = motion + theta + s;
    const std::string knife =
        motion +
        "cam = { type = \"disk\", follower = \"translating_knife\", base_radius_mm = 40, "
        "rotation = \"counterclockwise\" }\n";
    const auto x = [](double unit) {
        return cam_points([unit](double r, double at) { return r * std::cos(at) / unit; });
    };
    const auto y = [](double unit) {
        return cam_points([unit](double r, double at) { return r * std::sin(at) / unit; });
    };
    const auto r = [](double unit) {
        return cam_points([unit](double radius, double) { return radius / unit; });
    };
    const std::string around =
        "measured.theta_rad = " + cam_points([](double, double at) { return at; }) + "\n";
    const auto on_cam = [](const Scene& scene) {
        const MeasuredMotion& measured = scene.measured.value();
        const auto from = [](double at) { return std::abs(at - 20.0 * pi / 36.0); };
        const auto row = std::ranges::min_element(measured.angle, {}, from) - measured.angle.begin();
        return measured.displacement.at(static_cast<std::size_t>(row));
    };
    const double there = 0.02 * 20.0 * pi / 36.0 / 2.0;
    std::vector<KeyCase> all = {
        {"measured.table", "\"measured.csv\"", 8,
         [](const Scene& scene) { return double(scene.measured.value().angle.size()); }, motion},
        {"measured.theta_rad", "[0, 0.2, 0.5, 0.8, 1.1, 1.4, 1.7, 2]", 0.8, angle, motion + s},
        {"measured.theta_deg", "[0, 10, 30, 45, 60, 80, 100, 114.6]", pi / 4, angle, motion + s},
        {"measured.s_mm", "[0, 1, 3, 7, 12, 17, 19, 20]", 0.007, displacement, motion + theta},
        {"measured.s_in", "[0, 0.1, 0.2, 0.25, 0.4, 0.6, 0.7, 0.79]", 0.00635, displacement, motion + theta},
        {"measured.s_m", "[0, 0.001, 0.003, 0.007, 0.012, 0.017, 0.019, 0.02]", 0.007, displacement,
         motion + theta},
        {"measured.s_deg", "[0, 1, 3, 9, 15, 20, 25, 28.6]", pi / 20, displacement, swing + theta},
        {"measured.s_rad", "[0, 0.02, 0.1, 0.2, 0.3, 0.4, 0.47, 0.5]", 0.2, displacement, swing + theta},
        {"measured.theta_crank_deg", "[0, 20, 60, 90, 120, 160, 200, 229.2]", pi / 4, angle, motion + s},
        {"measured.step_deg", "16.4", 49.2 * pi / 180, angle, motion + s},
        {"measured.step_rad", "0.29", 0.87, angle, motion + s},
        {"measured.step_crank_deg", "32.8", 49.2 * pi / 180, angle, motion + s},
        {"measured.angles", "\"crank\"", 0.87, angle, motion + s + "measured.step_rad = 0.58\n"},
        {"measured.zero", "\"nose\"", 0.8, angle,
         motion + s + "measured.theta_rad = [-2, -1.8, -1.5, -1.2, -0.9, -0.6, -0.3, 0]\n"},
        {"measured.zero.deg", "-90", 0.8, angle,
         motion + s +
             "measured.theta_rad = [1.5707963267948966, 1.7707963267948966, 2.0707963267948966, "
             "2.3707963267948966, 2.6707963267948966, 2.9707963267948966, 3.2707963267948966, "
             "3.5707963267948966]\n"},
        {"measured.columns", "[\"s_in\", \"theta_rad\"]", 7 * 0.0254, displacement,
         "motion.rise_rad = 2\nmotion.lift_in = 20\nmeasured.table = \"measured.csv\"\n"},
        {"measured.decimal", "\".\"", 8,
         [](const Scene& scene) { return double(scene.measured.value().angle.size()); },
         motion + "measured.table = \"measured.csv\"\n"},
        {"measured.scale", "[0.5, 1]", 0.0035, displacement,
         "motion.rise_rad = 2\nmotion.lift_mm = 10\nmeasured.table = \"measured.csv\"\n"},
        {"measured.offset", "[0.5, 0]", 0.0075, displacement, motion + "measured.table = \"measured.csv\"\n"},
        {"measured.skip_lines", "0", 8,
         [](const Scene& scene) { return double(scene.measured.value().angle.size()); },
         motion + "measured.table = \"measured.csv\"\n"},
        {"measured.register", "[\"radius\"]", 1,
         [](const Scene& scene) { return scene.measured.value().place.value().zero ? 1.0 : 0.0; }, both},
        {"measured.outliers", "\"exclude\"", 1,
         [](const Scene& scene) { return scene.measured.value().excluded ? 1.0 : 0.0; }, both},
        {"measured.use", "\"start\"", 1,
         [](const Scene& scene) { return scene.measured.value().start ? 1.0 : 0.0; }, both},
        {"measured.norm", "\"rms\"", 1, [](const Scene& scene) { return scene.objective.deviation_rms; },
         both + "measured.use = \"nearest\"\n"},
        {"measured.name", "\"old cam\"", 1,
         [](const Scene& scene) { return scene.measured.value().name == "old cam" ? 1.0 : 0.0; }, both},
    };
    for (const auto& [unit, size] : {std::pair("mm", 1e-3), std::pair("in", 0.0254), std::pair("m", 1.0)}) {
        all.push_back({fmt::format("measured.x_{}", unit), x(size), there, on_cam,
                       knife + "measured.y_m = " + y(1.0) + "\n"});
        all.push_back({fmt::format("measured.y_{}", unit), y(size), there, on_cam,
                       knife + "measured.x_m = " + x(1.0) + "\n"});
        all.push_back({fmt::format("measured.r_{}", unit), r(size), there, on_cam, knife + around});
        all.push_back({fmt::format("measured.probe_radius_{}", unit), "0", there, on_cam,
                       knife + around + "measured.r_m = " + r(1.0) + "\n"});
    }
    return all;
}

}  // namespace camopt::input

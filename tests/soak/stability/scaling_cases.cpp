// SPDX-License-Identifier: MIT
#include "tests/soak/relations/change.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt::stability {

namespace {

SceneText plain_motion(double lift_mm, double rise_deg, const std::string& backend = "structured") {
    return study_scene(
        fmt::format("[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = {}\n", lift_mm, rise_deg), backend);
}

SceneText timed_motion(double length, double time) {
    // The rise takes as long as before where speed grows with the angle; here angle stays and time scales.
    return study_scene(
        fmt::format("[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = 120\nspeed_rpm = {}\n"
                    "[spline]\nsegments = 24\n"
                    "[limits]\nvelocity_mm_s = {}\nacceleration_m_s2 = {}\n",
                    20 * length, 300 / time, 550 * length / time, 30 * length / (time * time)));
}

/// A scene of scenes/ with one of its limits, and less segments.
struct ScaledCam {
    const char* name;
    bool convex;
    const char *file, *limit;

    [[nodiscard]] SceneText scene(const std::string& backend = "structured") const {
        SceneText scene = study_scene(text_of_file(file), backend);
        const std::string value = scene.find("limits", limit).value();
        scene.erase("limits");
        scene.at("limits").set(limit, value);
        scene.at("spline").set("segments", "16");
        return scene;
    }
};

constexpr ScaledCam scaled_cams[] = {{"roller with offset", true, "cam_roller.toml", "pressure_angle_deg"},
                                     {"free base radius", true, "cam_smallest.toml", "pressure_angle_deg"},
                                     {"flat face", true, "cam_flat.toml", "cam_radius_min_mm"},
                                     {"arm with roller", true, "cam_arm_roller.toml", "pressure_angle_deg"},
                                     {"least contact force", true, "cam_forces.toml", "contact_force_min_n"},
                                     {"least cam radius", false, "cam_undercut.toml", "cam_radius_min_mm"}};

StabilityRow against_scale_one(const ScaledCam& cam, double factor, const std::string& backend) {
    const SceneText one = cam.scene();
    Expectation expected;
    if (cam.convex) {
        expected = proved_optimum(one, "the same scene at scale 1, proved");
    } else {
        const StabilityRow row = solved_row(one, {});
        expected = exactly(row.found.value_or(0.0), "the same scene at scale 1", 1e-7);
        expected.verdicts = {Verdict::local, Verdict::optimal};
    }
    expected.honest_gap = cam.convex;
    SceneText scaled = cam.scene(backend);
    soak::scale_lengths(scaled, factor);
    return solved_row(scaled, expected);
}

void add_plain(std::vector<StabilityCase>& cases) {
    const auto add = [&](const std::string& name, double lift, double rise) {
        for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"})
            cases.push_back(make_case("scaling", name, true, [lift, rise, backend] {
                return solved_row(plain_motion(lift, rise, backend),
                                  exactly(study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7), "fraction"));
            }));
    };
    for (const double lift : {1e-9, 1e-6, 1e6, 1e9}) add("DRD, lift_mm " + text_of(lift), lift, 120.0);
    for (const double rise : {120e-9, 120e-6, 360.0}) add("DRD, rise_deg " + text_of(rise), 10.0, rise);
    cases.push_back(make_case("scaling", "DRD, rise_deg 120e9", true, [] {
        return refused_row([] { static_cast<void>(scene_of(plain_motion(10.0, 120e9))); },
                           "a rise is at most a turn");
    }));
}

void add_timed(std::vector<StabilityCase>& cases) {
    for (const double length : {1e-9, 1.0, 1e9})
        for (const double time : {1e-9, 1.0, 1e9})
            cases.push_back(make_case(
                "scaling", fmt::format("limits in time, length × {}, time × {}", length, time), true,
                [length, time] {
                    return solved_row(
                        timed_motion(length, time),
                        proved_optimum(timed_motion(1.0, 1.0), "the same scene at scale 1, proved"));
                }));
}

void add_cams(std::vector<StabilityCase>& cases) {
    for (const ScaledCam& cam : scaled_cams)
        for (const double factor : {1e-9, 1e-3, 1e3, 1e9})
            for (const char* backend : {"structured", "ipopt"}) {
                if (!cam.convex && std::string(backend) == "ipopt") continue;
                cases.push_back(
                    make_case("scaling", fmt::format("{}, lengths × {}", cam.name, factor),
                              cam.convex && std::string(backend) == "structured",
                              [cam, factor, backend] { return against_scale_one(cam, factor, backend); }));
            }
}

/// On a roller far larger than its lift tan φ = s'/s0 (1 + O(lift/s0)): a cap on V.
StabilityRow huge_cam() {
    constexpr double shrink = 1e-9;
    const double rise = 60 * shrink * std::numbers::pi / 180;
    const double prime_mm = 40.0 / shrink;
    const double cap = std::tan(28 * std::numbers::pi / 180) * prime_mm * rise / 20.0;
    SceneText capped = study_scene(MotionType::drd, 3, 24);
    capped.at("limits").set("velocity", cap);
    Expectation expected = proved_optimum(capped, "a cap on V of tan φm s0 β/h: the limit of a large cam");
    expected.digits = 1e-8;
    const std::string text = fmt::format(
        "[motion]\ntype = \"DRD\"\nlift_mm = 20\nrise_deg = {}\n[spline]\nsegments = 24\n[cam]\ntype = "
        "\"disk\"\n"
        "follower = \"translating_roller\"\nbase_radius_mm = {}\nroller_radius_mm = 10\n[limits]\n"
        "pressure_angle_deg = 28\n",
        60 * shrink, prime_mm - 10.0);
    return solved_row(study_scene(text), expected);
}

/// Each stroke is normalised by its own angle, so a quick one costs what a slow one does.
StabilityRow tiny_stroke(double angle_deg) {
    const std::string text = fmt::format(
        "[motion]\ntype = \"program\"\nlift_mm = 10\n"
        "[[motion.segments]]\nkind = \"dwell\"\nangle_deg = 60\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 100\nto = 1\n"
        "[[motion.segments]]\nkind = \"dwell\"\nangle_deg = {:.17g}\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = {:.17g}\n[spline]\nsegments = 12\n",
        200.0 - angle_deg, angle_deg);
    Expectation expected = exactly(study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7), "fraction");
    expected.may_give_up = angle_deg < 1e-5;
    return solved_row(study_scene(text), expected);
}

}  // namespace

std::vector<StabilityCase> scaling_cases() {
    std::vector<StabilityCase> cases;
    add_plain(cases);
    add_timed(cases);
    add_cams(cases);
    cases.push_back(make_case("scaling", "rise × 1e-9, base radius × 1e9", true, huge_cam));
    for (const double angle : {1e-3, 1e-6, 1e-9})
        cases.push_back(make_case("scaling",
                                  "program with a stroke of " + text_of(angle) + "° beside one of 100°", true,
                                  [angle] { return tiny_stroke(angle); }));
    return cases;
}

}  // namespace camopt::stability

// SPDX-License-Identifier: MIT
#include "benchmarks/stability/stability_cases.hpp"
#include "benchmarks/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt::stability {

namespace {

const char* const study_objective_text = R"(
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
reference = { velocity = 1.76, acceleration = 5.53, jerk = 69 }
)";

std::string solver_text(const std::string& name) {
    return "[solver]\nname = \"" + name + "\"\n";
}

std::string plain_motion(double lift_mm, double rise_deg) {
    return fmt::format("[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = {}\n", lift_mm, rise_deg) +
           study_objective_text;
}

std::string timed_motion(double length, double time) {
    // The rise takes as long as before where speed grows with the angle; here angle stays and time scales.
    return fmt::format(
               "[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = 120\nspeed_rpm = {}\n[spline]\nsegments = "
               "24\n"
               "[limits]\nvelocity_mm_s = {}\nacceleration_m_s2 = {}\n",
               20 * length, 300 / time, 550 * length / time, 30 * length / (time * time)) +
           study_objective_text;
}

/// Cams with every length times `f`. {0}: lift mm, {1}: base, {2}: roller, {3}: offset or centre distance.
std::string roller_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"RR\"\nlift_mm = {}\nrise_deg = 100\n[spline]\nsegments = 16\n[cam]\ntype "
               "= "
               "\"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = {}\nroller_radius_mm = {}\n"
               "offset_mm = {}\n[limits]\npressure_angle_deg = 25\n",
               20 * f, 22 * f, 8 * f, 4 * f) +
           study_objective_text;
}

std::string variable_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = 60\n[spline]\nsegments = 24\n[cam]\ntype "
               "= "
               "\"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = {{ min = {}, max = {} }}\n"
               "roller_radius_mm = {}\n[limits]\npressure_angle_deg = 30\n",
               20 * f, 5 * f, 100 * f, 10 * f) +
           study_objective_text + "base_radius = 0.5\n";
}

std::string flat_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"RR\"\nlift_mm = {}\nrise_deg = 70\n[spline]\nsegments = 24\n[cam]\ntype = "
               "\"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = {}\n[limits]\ncam_radius_min_mm "
               "= {}\n",
               14 * f, 30 * f, 5 * f) +
           study_objective_text;
}

std::string arm_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"DRD\"\nlift_deg = 20\nrise_deg = 90\n[spline]\nsegments = 16\n[cam]\ntype "
               "= "
               "\"disk\"\nfollower = \"oscillating_roller\"\nbase_radius_mm = {}\nroller_radius_mm = {}\n"
               "center_distance_mm = {}\narm_length_mm = {}\n[limits]\npressure_angle_deg = 32\n",
               30 * f, 8 * f, 90 * f, 70 * f) +
           study_objective_text;
}

std::string forces_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"RR\"\nlift_mm = {}\nrise_deg = 100\nspeed_rpm = 600\n[spline]\nsegments = "
               "16\n"
               "[cam]\ntype = \"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = "
               "{}\nroller_radius_mm "
               "= {}\n[forces]\nmass_kg = {}\nspring_rate_n_mm = {}\npreload_n = 60\n[limits]\n"
               "contact_force_min_n = 30\n",
               10 * f, 40 * f, 10 * f, 0.8 / f, 12 / f) +
           study_objective_text;
}

std::string undercut_cam(double f) {
    return fmt::format(
               "[motion]\ntype = \"RR\"\nlift_mm = {}\nrise_deg = 60\n[spline]\nsegments = 12\n[cam]\ntype = "
               "\"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = {}\nroller_radius_mm = "
               "{}\n[limits]\n"
               "cam_radius_min_mm = {}\n",
               12 * f, 20 * f, 10 * f, 1 * f) +
           study_objective_text;
}

struct ScaledCam {
    const char* name;
    std::string (*text)(double factor);
    bool convex;
};

StabilityRow against_scale_one(const ScaledCam& cam, double factor, const std::string& backend) {
    const SceneText one = SceneText::parse(cam.text(1.0) + solver_text("structured"));
    Expectation expected;
    if (cam.convex) {
        expected = proved_optimum(one, "the same scene at scale 1, proved");
    } else {
        const StabilityRow row = solved_row(one, {});
        expected = exactly(row.found.value_or(0.0), "the same scene at scale 1", 1e-7);
        expected.verdicts = {Verdict::local, Verdict::optimal};
    }
    expected.honest_gap = cam.convex;
    return solved_row(SceneText::parse(cam.text(factor) + solver_text(backend)), expected);
}

void add_plain(std::vector<StabilityCase>& cases) {
    const auto add = [&](const std::string& name, double lift, double rise) {
        for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"})
            cases.push_back(make_case("scaling", name, true, [lift, rise, backend] {
                return solved_row(SceneText::parse(plain_motion(lift, rise) + solver_text(backend)),
                                  exactly(study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7), "fraction"));
            }));
    };
    for (const double lift : {1e-9, 1e-6, 1e6, 1e9}) add("DRD, lift_mm " + text_of(lift), lift, 120.0);
    for (const double rise : {120e-9, 120e-6, 360.0}) add("DRD, rise_deg " + text_of(rise), 10.0, rise);
    cases.push_back(make_case("scaling", "DRD, rise_deg 120e9", true, [] {
        return refused_row([] { static_cast<void>(scene_of_text(plain_motion(10.0, 120e9))); },
                           "a rise is at most a turn");
    }));
}

void add_timed(std::vector<StabilityCase>& cases) {
    for (const double length : {1e-9, 1.0, 1e9})
        for (const double time : {1e-9, 1.0, 1e9})
            cases.push_back(make_case(
                "scaling", fmt::format("limits in time, length × {}, time × {}", length, time), true,
                [length, time] {
                    const SceneText one = SceneText::parse(timed_motion(1.0, 1.0));
                    Expectation expected = proved_optimum(one, "the same scene at scale 1, proved");
                    return solved_row(
                        SceneText::parse(timed_motion(length, time) + solver_text("structured")), expected);
                }));
}

void add_cams(std::vector<StabilityCase>& cases) {
    const ScaledCam cams[] = {{"roller with offset", roller_cam, true},
                              {"free base radius", variable_cam, true},
                              {"flat face", flat_cam, true},
                              {"arm with roller", arm_cam, true},
                              {"least contact force", forces_cam, true},
                              {"least cam radius", undercut_cam, false}};
    for (const ScaledCam& cam : cams)
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
    return solved_row(SceneText::parse(text + study_objective_text + solver_text("structured")), expected);
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
    return solved_row(SceneText::parse(text + study_objective_text + solver_text("structured")), expected);
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

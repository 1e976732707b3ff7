// SPDX-License-Identifier: MIT
#include "benchmarks/cam/cam_case.hpp"

#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/papers/paper_report.hpp"

#include <fmt/format.h>

namespace camopt::benchmarks {

namespace {

using enum DimensionIndex;
using units::degree, units::millimetre;

constexpr int most_segments_without_derivatives = 12;

Scene empty_scene(int segments) {
    Scene scene;
    scene.motion.lift = 20 * millimetre;
    scene.motion.rise = 60 * degree;
    scene.spline.segments = segments;
    scene.objective.velocity = paper::weights[0];
    scene.objective.acceleration = paper::weights[1];
    scene.objective.jerk = paper::weights[2];
    Reference& reference = scene.objective.reference;
    reference.numeric = true;
    reference.velocity = paper::velocity_reference;
    reference.acceleration = paper::acceleration_reference;
    reference.jerk = paper::jerk_reference;
    scene.objective.tie_break = TieBreak::none;
    scene.cam = disk_spec({});
    return scene;
}

WrittenLimit degrees(double value) {
    return {value * degree, "limits.pressure_angle_deg", degree, "deg"};
}

WrittenLimit least_radius(double value) {
    return {value * millimetre, "limits.cam_radius_min_mm", millimetre, "mm"};
}

/// Rise of 60°, lift 20 mm, roller of 10 mm on the axis, at most 30°.
Scene pressure_angle(double prime_radius, int segments) {
    Scene scene = empty_scene(segments);
    scene.cam->set(base_radius, (prime_radius - 10) * millimetre);
    scene.cam->set(roller_radius, 10 * millimetre);
    scene.limits.pressure_angle = degrees(30);
    return scene;
}

/// The same, but the base radius is free and costs its own length.
Scene variable_base(int segments) {
    Scene scene = pressure_angle(40, segments);
    scene.cam->set(base_radius, Dimension(1 * millimetre, 60 * millimetre));
    scene.objective.dimensions[0] = 1.0;
    return scene;
}

Scene quintic(int segments) {
    Scene scene = pressure_angle(40, segments);
    scene.spline.degree = 5;
    return scene;
}

Scene variable_offset(int segments) {
    Scene scene = pressure_angle(35, segments);
    scene.cam->set(offset, Dimension(-8 * millimetre, 8 * millimetre));
    scene.objective.dimensions[2] = 0.1;
    return scene;
}

/// A valve lift: rise and return of 70° each, lift 14 mm, cam radius at least 8 mm, base radius free.
Scene flat_face(int segments) {
    Scene scene = empty_scene(segments);
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 14 * millimetre;
    scene.motion.rise = 70 * degree;
    scene.cam = disk_spec({.follower = FollowerType::translating_flat});
    scene.cam->set(base_radius, Dimension(1 * millimetre, 200 * millimetre));
    scene.objective.dimensions[0] = 0.1;
    scene.limits.cam_radius_min = least_radius(8);
    return scene;
}

/// Not convex: without the limit the cam radius of the best motion is 18.3 mm at 12 segments.
Scene roller_radius_limit(int segments) {
    Scene scene = pressure_angle(40, segments);
    scene.limits = {};
    scene.limits.cam_radius_min = least_radius(16);
    return scene;
}

/// A swinging roller: centre distance 100, arm 80, prime radius 50 mm, swing 20°; without the limit 28°.
Scene swinging_roller(int segments) {
    Scene scene = empty_scene(segments);
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 20 * degree;
    scene.motion.lift_is_angle = true;
    scene.motion.rise = 90 * degree;
    scene.cam = disk_spec({.follower = FollowerType::oscillating_roller});
    scene.cam->set(base_radius, 40 * millimetre);
    scene.cam->set(roller_radius, 10 * millimetre);
    scene.cam->set(center_distance, 100 * millimetre);
    scene.cam->set(arm_length, 80 * millimetre);
    scene.limits.pressure_angle = degrees(26);
    return scene;
}

ProgramSegment dwell(double angle) {
    return {SegmentKind::dwell, angle * degree, "", {}};
}

ProgramSegment spline(double angle, double to) {
    return {SegmentKind::spline, angle * degree, "", to};
}

/// Two rises with a dwell between, and a return: three splines of so many segments.
Scene two_rises(int segments) {
    Scene scene = empty_scene(segments);
    scene.motion.type = MotionType::program;
    scene.motion.segments = {dwell(40), spline(80, 0.5), dwell(30), spline(80, 1), dwell(20), spline(110, 0)};
    scene.cam->set(base_radius, 25 * millimetre);
    scene.cam->set(roller_radius, 8 * millimetre);
    scene.cam->set(offset, 4 * millimetre);
    scene.limits.pressure_angle = degrees(25);
    return scene;
}

void add(std::vector<CamCase>& cases, const std::string& name, Scene (*scene)(int)) {
    for (const int segments : {12, 24, 48}) cases.push_back({name, segments, scene(segments)});
}

}  // namespace

std::string CamBackend::name() const {
    return fmt::format("{}, {}", solver, hessian);
}

std::vector<CamCase> cam_cases() {
    std::vector<CamCase> cases;
    for (const int prime_radius : {40, 35, 30})
        for (const int segments : {12, 24, 48})
            cases.push_back({fmt::format("pressure angle {} mm", prime_radius), segments,
                             pressure_angle(prime_radius, segments)});
    add(cases, "quintic 40 mm", quintic);
    add(cases, "free base radius", variable_base);
    add(cases, "free offset", variable_offset);
    add(cases, "flat face with free base", flat_face);
    add(cases, "cam radius of a roller", roller_radius_limit);
    add(cases, "swinging roller", swinging_roller);
    add(cases, "two rises with dwells", two_rises);
    return cases;
}

std::vector<CamBackend> cam_backends() {
    return {{"structured", "exact", {}},
            {"ipopt", "exact", {}},
            {"ipopt", "limited-memory", {{"hessian_approximation", std::string("limited-memory")}}},
            {"nlopt.slsqp", "BFGS", {}},
            {"nlopt.cobyla", "none", {}}};
}

bool is_too_large(const CamBackend& backend, const CamCase& one) {
    const int splines = one.scene.motion.type == MotionType::program ? 3 : 1;
    return backend.solver == "nlopt.cobyla" && splines * one.segments > most_segments_without_derivatives;
}

}  // namespace camopt::benchmarks

// SPDX-License-Identifier: MIT
#include "objectives/scene_family.hpp"

namespace camopt {

namespace {

std::vector<PointCondition> scene_conditions(const Scene& scene) {
    std::vector<PointCondition> conditions;
    const MotionSpec& motion = scene.motion;
    const double length = motion.length();
    if (motion.type == MotionType::rr) {
        conditions.push_back({1.0, 0, Side::right, 1.0, "top of the rise: y(1) = 1", false});
        conditions.push_back({1.0, 1, Side::right, 0.0, "top of the rise: y'(1) = 0", false});
    }
    for (PointCondition& condition : rest_conditions(0.0, Side::right, scene.rest_order()))
        conditions.push_back(std::move(condition));
    for (PointCondition& condition : rest_conditions(length, Side::left, scene.rest_order()))
        conditions.push_back(std::move(condition));
    for (const PlacedPoint& point : placed_points(motion)) {
        const std::vector<PointCondition> own = conditions_of(motion, point, scene.spline.degree, length);
        conditions.insert(conditions.end(), own.begin(), own.end());
    }
    for (PointCondition& condition : turning_points(scene)) conditions.push_back(std::move(condition));
    for (PointCondition& condition : points_at_limits(scene, placed_points(motion), -1, {}))
        conditions.push_back(std::move(condition));
    return conditions;
}

/// Half of the segments for either stroke: the shorter of two unequal strokes determines the optimum, and
/// uniform segments may leave it one or none.
SplineSpec with_breakpoints_by_stroke(SplineSpec spline, const MotionSpec& motion) {
    const double length = motion.length();
    if (motion.type != MotionType::rr || !spline.by_stroke || !spline.breakpoints.empty() || length == 2.0)
        return spline;
    const int rise = (spline.segments + 1) / 2, back = std::max(1, spline.segments / 2);
    for (int i = 0; i < rise; ++i) spline.breakpoints.push_back(static_cast<double>(i) / rise);
    for (int i = 0; i <= back; ++i) spline.breakpoints.push_back(1.0 + (length - 1.0) * i / back);
    spline.breakpoints.back() = length;
    return spline;
}

}  // namespace

DesignRequest spline_request(const Scene& scene, DesignKind kind) {
    const MotionSpec& motion = scene.motion;
    const SplineSpec spline = with_breakpoints_by_stroke(scene.spline, motion);
    const bool rise = motion.type == MotionType::drd;
    const std::vector<std::array<double, 2>> regions = regions_of(motion, placed_points(motion), -1);
    SplineSpace space =
        spline.breakpoints.empty() && regions.empty()
            ? SplineSpace::uniform(spline.degree, spline.smoothness(), spline.segments, motion.length())
            : SplineSpace(spline.degree, spline.smoothness(),
                          regions.empty() ? spline.breakpoints
                                          : breakpoints_of(spline, 0.0, motion.length(), regions));
    const Symmetry symmetry = !motion.symmetric ? Symmetry::none : rise ? Symmetry::odd : Symmetry::even;
    const std::array<double, 2> start = end_velocities(motion, false), end = end_velocities(motion, true);
    return {std::move(space),        kind,    {0.0, start[0], start[1]}, {rise ? 1.0 : 0.0, end[0], end[1]},
            scene_conditions(scene), symmetry};
}

MotionFamily scene_family(const Scene& scene, DesignKind kind, const std::vector<StrokeDirection>& of_free) {
    if (scene.motion.type == MotionType::program) return program_family(scene, kind, of_free);
    return DesignVector::make(spline_request(scene, kind));
}

DerivativeCombination cam_of_output(const Scene& scene) {
    const DynamicsSpec& train = scene.dynamics.value();
    const double stiffness = train.output().stiffness, pace = *scene.motion.speed / scene.motion.unit_angle();
    return {{1.0 + train.return_stiffness / stiffness, train.ground_damping / stiffness * pace,
             train.mass / stiffness * pace * pace}};
}

DerivativeCombination torque_of_output(const Scene& scene) {
    const DriveSpec& drive = scene.drive.value();
    const double square = drive.transmission * drive.transmission;
    DerivativeCombination torque = cam_of_output(scene);
    torque.weights[0] += scene.dynamics.value().mass * square / (drive.load * square + drive.motor_inertia);
    return torque;
}

std::vector<double> start_breakpoints(const Scene& scene) {
    if (scene.motion.type == MotionType::program) return breakpoints_of(scene.spline, 0.0, 1.0, {});
    return spline_request(scene, DesignKind::states).space.breakpoints();
}

std::vector<double> held_breakpoints(const Scene& scene) {
    std::vector<double> held;
    if (scene.motion.type == MotionType::program) return held;
    for (const auto& [begin, end] : regions_of(scene.motion, placed_points(scene.motion), -1))
        held.insert(held.end(), {begin, end});
    return held;
}

Scene with_breakpoints(Scene scene, std::vector<double> breakpoints) {
    scene.spline.breakpoints = std::move(breakpoints);
    scene.spline.segments = static_cast<int>(scene.spline.breakpoints.size()) - 1;
    scene.spline.free_knots = false;
    return scene;
}

}  // namespace camopt

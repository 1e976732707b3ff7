// SPDX-License-Identifier: MIT
#include "benchmarks/papers/tappet_shedding.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <initializer_list>

namespace camopt {

namespace {

using enum RemoteDimension;
using units::degree, units::millimetre;

constexpr double lift_mm = 80.0;

ProgramSegment dwell(double angle_deg) {
    return {SegmentKind::dwell, angle_deg * degree, {}, {}};
}

ProgramSegment stroke(double angle_deg, double to) {
    return {SegmentKind::spline, angle_deg * degree, {}, to};
}

}  // namespace

CamSpec tappet_spec(bool farther, PressurePoint where) {
    CamSpec spec = remote_spec(RemoteLinkage::lever_coupler_lever_coupler_slider);
    spec.choices["lever_branch"] = "right";
    spec.choices["pressure_angle_at"] = name_of(where);
    const std::initializer_list<std::pair<RemoteDimension, double>> numbers = {
        {roller_radius, 30},      {roller_arm, 160},     {lever_pivot_x, -160},
        {lever_pivot_y, 85},      {center_x, 0},         {center_y, 0},
        {lever_arm, 240},         {lever_angle, -10},    {coupler, 351.3},
        {rocker_pivot_x, 260},    {rocker_pivot_y, 400}, {rocker_input_arm, 220},
        {rocker_output_arm, 250}, {rocker_angle, 0},     {second_coupler, 200},
        {slider_x, 10},           {slider_y, 560},       {slider_angle, 90},
    };
    for (const auto& [which, number] : numbers) {
        CamDimension& own = spec.dimensions[static_cast<std::size_t>(which)];
        own.value.low = own.value.high = number * own.value.unit;
        own.value.key = std::string(table_of(which)) + "." + own.name + (own.is_angle ? "_deg" : "_mm");
    }
    Dimension& height = spec.dimensions[static_cast<std::size_t>(center_y)].value;
    if (farther) height.low = height.high = -10.0 * millimetre;
    return spec;
}

MotionScale tappet_scale() {
    return {lift_mm * millimetre, degree};
}

MotionChain tappet_motion(const std::string& law, double dwell_deg) {
    const std::shared_ptr<const Motion> shape = make_law(law);
    const double width = 180.0 - dwell_deg;
    return MotionChain({{0.0, dwell_deg, nullptr, 0.0, 1.0, 0.0, 1.0},
                        {dwell_deg, 180.0, shape, dwell_deg, width, 0.0, 1.0},
                        {180.0, 180.0 + dwell_deg, nullptr, 0.0, 1.0, 1.0, 1.0},
                        {180.0 + dwell_deg, 360.0, shape, 180.0 + dwell_deg, width, 1.0, -1.0}});
}

Scene tappet_scene(double dwell_deg, double limit_deg) {
    Scene scene;
    scene.title = "Tappet";
    scene.motion.type = MotionType::program;
    scene.motion.lift = lift_mm * millimetre;
    scene.motion.segments = {dwell(dwell_deg), stroke(180.0 - dwell_deg, 1.0), dwell(dwell_deg),
                             stroke(180.0 - dwell_deg, 0.0)};
    scene.spline.degree = 5;
    scene.spline.segments = 16;
    scene.spline.continuity = 3;
    scene.objective.velocity = 0.2;
    scene.objective.acceleration = 0.5;
    scene.objective.jerk = 0.3;
    scene.objective.reference.law = "modified_trapezoid";
    scene.cam = tappet_spec(false);
    scene.limits.pressure_angle =
        WrittenLimit{limit_deg * degree, "limits.pressure_angle_deg", degree, "deg"};
    scene.limits.cam_radius_min =
        WrittenLimit{10.0 * millimetre, "limits.cam_radius_min_mm", millimetre, "mm"};
    return scene;
}

}  // namespace camopt

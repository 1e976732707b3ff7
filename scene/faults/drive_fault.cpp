// SPDX-License-Identifier: MIT
// The [drive] table: its numbers, and what torque, speed and friction of the motor need.
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

Fault inertia_fault(const DriveSpec& drive) {
    if (drive.load > 0.0 || drive.motor_inertia > 0.0) return std::nullopt;
    return SceneFault{"drive", "no mass and no inertia",
                      "a load or drive.motor_inertia > 0: nothing else resists acceleration"};
}

/// The member of the scene that asks for a motor; empty: none.
std::string member_of_motor(const Scene& scene) {
    for (const ResponseTerm& term : response_terms())
        if (term.needs_drive() && term.weight_in(scene.objective) > 0.0)
            return fmt::format("objective.{}", term.name);
    for (const LimitRow& row : limit_rows())
        if (row.needs_drive && row.in(scene.limits)) return fmt::format("limits.{}", row.name);
    return scene.limits.motor_curve.empty() ? "" : "limits.motor_curve";
}

/// Torque never rises with the speed, and ever more steeply falls: then |τ| below every edge is convex.
Fault curve_fault(const MotorCurve& curve) {
    const char* const allowed =
        "two or more pairs [speed in rpm, torque in N m] from speed 0 on, speeds that ascend, torques >= 0 "
        "that "
        "never rise and fall ever more steeply (concave)";
    const auto fault = [&](const std::string& found) {
        return SceneFault{"limits.motor_curve", found, allowed};
    };
    if (curve.size() < 2) return fault(fmt::format("{} pair(s)", curve.size()));
    if (curve.front()[0] != 0.0)
        return fault(fmt::format("{:.6g} rpm first", curve.front()[0] / units::revolution_per_minute));
    double before = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double rpm = curve[i][0] / units::revolution_per_minute;
        if (!std::isfinite(rpm) || !std::isfinite(curve[i][1]) || curve[i][1] < 0.0)
            return fault(fmt::format("[{:.6g}, {:.6g}]", rpm, curve[i][1]));
        if (i == 0) continue;
        if (!(curve[i][0] > curve[i - 1][0])) return fault(fmt::format("{:.6g} rpm in pair {}", rpm, i + 1));
        const double slope = (curve[i][1] - curve[i - 1][1]) / (curve[i][0] - curve[i - 1][0]);
        constexpr double rounding = 1e-12;
        if (slope > before + rounding * (1.0 + std::abs(before)))
            return fault(fmt::format("a torque of {:.6g} N m at {:.6g} rpm, above the line before it",
                                     curve[i][1], rpm));
        before = slope;
    }
    if (!(curve.front()[1] > 0.0)) return fault("a torque of 0 at rest");
    return std::nullopt;
}

Fault friction_fault(const Scene& scene) {
    if (!(scene.drive->friction > 0.0)) return std::nullopt;
    const char* const why = "its direction must be known: motion.monotone = true, or no friction";
    const MotionSpec& motion = scene.motion;
    const bool moves = motion.prescribed() || motion.monotone;
    if (!moves)
        return SceneFault{"drive.friction", "friction in a motion that may reverse within a stroke", why};
    if (std::ranges::any_of(motion.segments, [](const ProgramSegment& segment) {
            return segment.kind != SegmentKind::dwell && !segment.to;
        }))
        return SceneFault{"drive.friction", "friction in a program with a free displacement",
                          "motion.segments.to of every stroke, or no friction"};
    if (motion.start || motion.end)
        return SceneFault{"drive.friction", "friction with motion.start or motion.end", "no friction"};
    return std::nullopt;
}

Fault cycle_fault(const Scene& scene) {
    if (!scene.drive->cycle) return std::nullopt;
    const MotionSpec& motion = scene.motion;
    const double cycle = *scene.drive->cycle, own = motion.length() * motion.unit_angle();
    const auto degrees = [](double angle) { return fmt::format("{:.6g} deg", angle / units::degree); };
    constexpr double rounding = 1e-9;
    if (motion.periodic() && std::abs(cycle - units::turn) > rounding)
        return SceneFault{"drive.cycle", degrees(cycle), "360 deg, the program's own revolution"};
    if (cycle < own * (1.0 - rounding))
        return SceneFault{"drive.cycle", degrees(cycle),
                          fmt::format("at least {}, the motion itself", degrees(own))};
    return std::nullopt;
}

Fault transmission_fault(const Scene& scene, bool needs_motor) {
    const auto& range = scene.drive->transmission_range;
    if (!range) return std::nullopt;
    const auto fault = [](std::string found, std::string allowed) {
        return SceneFault{"drive.transmission", std::move(found), std::move(allowed)};
    };
    if (!((*range)[0] > 0.0 && (*range)[0] < (*range)[1] && std::isfinite((*range)[1])))
        return fault(fmt::format("{} to {}", (*range)[0], (*range)[1]),
                     "a range { min, max } with 0 < min < max, or a number");
    if (!needs_motor)
        return fault("a range without a limit or a term of the motor",
                     "a number, or a range together with one of them: nothing else depends on it");
    if (scene.objective.sought) return fault("a range where the objective seeks another number", "a number");
    for (const ResponseTerm& term : response_terms())
        if (term.needs_drive() && term.weight_in(scene.objective) > 0.0 &&
            !(scene.objective.reference.*term.reference))
            return fault("a range, with which the torque of the reference law changes",
                         fmt::format("a number, or objective.reference.{} as a number", term.name));
    return std::nullopt;
}

}  // namespace

DriveTorque drive_torque(const DriveSpec& drive, const MotionSpec& motion) {
    const double time = motion.unit_angle() / motion.speed.value(), velocity = motion.lift / time;
    return {(drive.load * drive.transmission + drive.motor_inertia / drive.transmission) * velocity / time,
            drive.viscous * drive.transmission * velocity, drive.force * drive.transmission,
            drive.friction * drive.transmission, velocity / drive.transmission};
}

Fault drive_fault(const Scene& scene) {
    const std::string member = member_of_motor(scene);
    if (!scene.drive) {
        if (member.empty()) return std::nullopt;
        return SceneFault{member, "a figure of a motor without one", "only together with a [drive] table"};
    }
    if (Fault fault = inertia_fault(*scene.drive)) return fault;
    if (!scene.motion.speed)
        return SceneFault{"drive", "a motor without a speed", "only where motion.speed is given"};
    if (scene.cam)
        return SceneFault{"drive", "a motor together with a [cam]",
                          "one of the two: the motor is in place of a cam"};
    const LimitSpec& limits = scene.limits;
    if (!limits.motor_curve.empty())
        if (Fault fault = curve_fault(limits.motor_curve)) return fault;
    if (limits.motor_torque_min && limits.motor_torque_max &&
        limits.motor_torque_min->value > limits.motor_torque_max->value)
        return SceneFault{"limits.motor_torque_min",
                          fmt::format("{} above the largest, {}", limits.motor_torque_min->given(),
                                      limits.motor_torque_max->given()),
                          "a least torque below the largest"};
    if (Fault fault = friction_fault(scene)) return fault;
    if (Fault fault = transmission_fault(scene, !member.empty())) return fault;
    return cycle_fault(scene);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The [dynamics] table: its numbers, and the requirements of residual vibration and dynamic forces.
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr std::size_t most_stages = 3;

Fault stage_fault(const DynamicsSpec& spec) {
    using ranges::not_negative, ranges::positive;
    for (std::size_t i = 0; i < spec.stages.size(); ++i) {
        const auto out_of = [i](const Range& range, double value, const char* name) -> Fault {
            if (range.contains(value)) return std::nullopt;
            return SceneFault{entry_key("dynamics.stage", i, name), fmt::format("{}", value),
                              range.number_text()};
        };
        if (Fault fault = out_of(positive, spec.stages[i].mass, "mass")) return fault;
        if (Fault fault = out_of(positive, spec.stages[i].stiffness, "stiffness")) return fault;
        if (Fault fault = out_of(not_negative, spec.stages[i].damping, "damping_ratio")) return fault;
    }
    return std::nullopt;
}

Fault train_choice_fault(const DynamicsSpec& spec) {
    if (spec.natural_frequency.has_value() == spec.stiffness.has_value())
        return SceneFault{
            "dynamics.natural_frequency",
            spec.stiffness ? "a natural frequency together with a stiffness" : "neither it nor a stiffness",
            "one of natural_frequency and stiffness"};
    if (spec.damping_ratio && spec.damping)
        return SceneFault{"dynamics.damping_ratio", "a damping ratio together with a damping",
                          "one of the two"};
    if (spec.stages.size() > most_stages)
        return SceneFault{"dynamics.stage", fmt::format("{} stages", spec.stages.size()),
                          fmt::format("at most {} before the output", most_stages)};
    if (!(spec.output().stiffness > 0.0))
        return SceneFault{"dynamics.natural_frequency",
                          "a frequency that the return spring alone would exceed",
                          "a natural frequency above that of the mass on its return spring"};
    return std::nullopt;
}

Fault speed_range_fault(const Scene& scene) {
    if (!scene.motion.speed)
        return SceneFault{"dynamics", "a follower train without a speed", "only where motion.speed is given"};
    const auto& range = scene.dynamics->speed_range;
    if (range && !((*range)[0] > 0.0 && (*range)[0] <= (*range)[1]))
        return SceneFault{"dynamics.speed_range",
                          fmt::format("{:.6g} to {:.6g} rpm", (*range)[0] / units::revolution_per_minute,
                                      (*range)[1] / units::revolution_per_minute),
                          "two speeds > 0 that ascend"};
    return std::nullopt;
}

bool asks_response(const Scene& scene) {
    return weighs_response(scene.objective) || std::ranges::any_of(limit_rows(), [&](const LimitRow& row) {
               return row.needs_dynamics && row.in(scene.limits).has_value();
           });
}

/// The first member of the scene that requires a response.
std::string asking_member(const Scene& scene) {
    for (const ResponseTerm& term : response_terms())
        if (term.needs_dynamics() && term.weight_in(scene.objective) > 0.0)
            return fmt::format("objective.{}", term.name);
    for (const LimitRow& row : limit_rows())
        if (row.needs_dynamics && row.in(scene.limits)) return fmt::format("limits.{}", row.name);
    return "dynamics";
}

Fault motion_for_response_fault(const Scene& scene) {
    const std::string member = asking_member(scene);
    if (scene.motion.start || scene.motion.end || scene.motion.relative)
        return SceneFault{member, "a response of the train in a motion that does not start and end at rest",
                          "without motion.start, motion.end and closed = \"relative\""};
    if (scene.motion.type != MotionType::program) return std::nullopt;
    const auto& segments = scene.motion.segments;
    if (std::ranges::any_of(segments, [](const ProgramSegment& one) { return one.angle_range.has_value(); }))
        return SceneFault{member, "a response of the train with angles that are searched", "given angles"};
    if (std::ranges::none_of(segments,
                             [](const ProgramSegment& one) { return one.kind == SegmentKind::dwell; }))
        return SceneFault{member, "a program without a dwell",
                          "a program with a dwell, in which vibration appears"};
    return std::nullopt;
}

/// What a motor that moves a prescribed output through a spring leaves out.
Fault elastic_load_fault(const Scene& scene) {
    const DriveSpec& drive = *scene.drive;
    const DynamicsSpec& train = *scene.dynamics;
    const auto fault = [](const char* member, double value, const char* allowed) -> Fault {
        return SceneFault{member, fmt::format("{} with dynamics.prescribe = \"output\"", value), allowed};
    };
    if (drive.viscous != 0.0) return fault("drive.viscous", drive.viscous, "0: torque by acceleration alone");
    if (drive.friction != 0.0)
        return fault("drive.friction", drive.friction, "0: the motor may turn back while the output goes on");
    if (train.return_stiffness != 0.0)
        return fault("dynamics.return_spring", train.return_stiffness, "0 next to a [drive]");
    if (train.ground_damping != 0.0)
        return fault("dynamics.ground_damping", train.ground_damping, "0 next to a [drive]");
    if (train.preload != 0.0)
        return fault("dynamics.preload", train.preload, "0: a constant load is drive.force");
    if (!scene.limits.motor_curve.empty())
        return SceneFault{"limits.motor_curve", "a torque-speed curve with dynamics.prescribe = \"output\"",
                          "limits.motor_torque and limits.motor_speed"};
    return std::nullopt;
}

/// What the cam of a prescribed output needs, and what was not thought through together with it.
Fault prescribed_output_fault(const Scene& scene) {
    constexpr const char* member = "dynamics.prescribe";
    const auto found = [](const std::string& beside) { return fmt::format("\"output\" {}", beside); };
    const SplineSpec& spline = scene.spline;
    if (!scene.dynamics->stages.empty())
        return SceneFault{member, found("with stages between cam and output"), "a train of one mass"};
    if (spline.degree < 5)
        return SceneFault{"spline.degree",
                          fmt::format("{} with dynamics.prescribe = \"output\"", spline.degree),
                          "5 or 7: the cam's acceleration has the output's fourth derivative in it"};
    if (spline.smoothness() < 4)
        return SceneFault{"spline.continuity",
                          fmt::format("{} with dynamics.prescribe = \"output\"", spline.smoothness()),
                          "4 or more: the cam's acceleration has the output's fourth derivative in it"};
    if (spline.free_knots)
        return SceneFault{member, found("with spline.knots = \"free\""), "given breakpoints"};
    if (scene.motion.start || scene.motion.end || scene.motion.relative)
        return SceneFault{member, found("in a motion that does not start and end at rest"),
                          "without motion.start, motion.end and closed = \"relative\""};
    const auto law = std::ranges::find(scene.motion.segments, SegmentKind::law, &ProgramSegment::kind);
    if (law != scene.motion.segments.end())
        return SceneFault{member, found(fmt::format("with the law \"{}\"", law->law)),
                          "splines and dwells: the cam of a law has impulses where the law's jerk jumps"};
    if (scene.tolerance)
        return SceneFault{
            "tolerance", "tolerances with dynamics.prescribe = \"output\"",
            "without one of the two: what an error of the cam does to the output is a vibration"};
    if (scene.drive)
        if (Fault fault = elastic_load_fault(scene)) return fault;
    if (scene.is_given())
        return SceneFault{member, found("with a given cam"),
                          "\"cam\": the motion of a given cam is the cam's"};
    return std::nullopt;
}

/// Residual vibration and forces alone do not bound the motion.
Fault static_term_fault(const Scene& scene) {
    if (!weighs_response(scene.objective)) return std::nullopt;
    const bool weighs = std::ranges::any_of(
        cost_terms(), [&](const CostTerm& term) { return term.weight_in(scene.objective) > 0.0; });
    const bool caps = std::ranges::any_of(
        peak_limit_rows(), [&](const PeakLimitRow& row) { return row.in(scene.limits).has_value(); });
    if (weighs || caps) return std::nullopt;
    return SceneFault{asking_member(scene), "no weight or cap on a peak of the motion itself",
                      "together with a weight or a limit of velocity, acceleration or jerk"};
}

Fault response_limit_fault(const Scene& scene) {
    const LimitSpec& limits = scene.limits;
    if (Fault fault = limit_unit_fault(scene, LimitedFigure::residual)) return fault;
    if (limits.dynamic_contact_force_min && !scene.dynamics->pressed())
        return SceneFault{"limits.dynamic_contact_force_min", "a train without a force towards the cam",
                          "together with dynamics.return_spring or dynamics.preload"};
    if (Fault fault = limit_unit_fault(scene, LimitedFigure::dynamic_contact_force)) return fault;
    const bool wants_residual = limits.residual || scene.objective.residual > 0.0;
    if (wants_residual && scene.dynamics->formulas && !scene.dynamics->formulas->vibrates())
        return SceneFault{limits.residual ? "limits.residual" : "objective.residual",
                          "a train damped above critical, which does not vibrate", "a damping ratio below 1"};
    return std::nullopt;
}

}  // namespace

TrainStage DynamicsSpec::output() const {
    TrainStage stage;
    stage.mass = mass;
    const double total = natural_frequency ? mass * *natural_frequency * *natural_frequency
                                           : stiffness.value_or(0.0) + return_stiffness;
    stage.stiffness = natural_frequency ? total - return_stiffness : stiffness.value_or(0.0);
    stage.damping = damping.value_or(2.0 * damping_ratio.value_or(0.0) * std::sqrt(total * mass));
    return stage;
}

Fault dynamics_fault(const Scene& scene) {
    if (!scene.dynamics) {
        if (!asks_response(scene)) return std::nullopt;
        return SceneFault{asking_member(scene), "a response of an elastic train without one",
                          "only together with a [dynamics] table"};
    }
    if (Fault fault = stage_fault(*scene.dynamics)) return fault;
    if (Fault fault = train_choice_fault(*scene.dynamics)) return fault;
    if (Fault fault = speed_range_fault(scene)) return fault;
    if (scene.prescribes_output())
        if (Fault fault = prescribed_output_fault(scene)) return fault;
    if (!asks_response(scene)) return std::nullopt;
    if (Fault fault = motion_for_response_fault(scene)) return fault;
    if (Fault fault = static_term_fault(scene)) return fault;
    return response_limit_fault(scene);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "objectives/motion_bounds.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "report/words/solution_text.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/written_limits.hpp"

#include <fmt/format.h>

#include <type_traits>

namespace camopt {

namespace {

constexpr int shown_digits = 6;  // of angles that the scene gives

std::string kind_of_motion(const MotionSpec& motion) {
    if (motion.valve) return "a valve lobe";
    if (motion.type == MotionType::program)
        return fmt::format("a program of {} segments over {} deg", motion.segments.size(),
                           short_text(degrees_shown.of(motion.length() * motion.unit_angle())));
    return motion.type == MotionType::drd ? "rise between two dwells"
                                          : "rise and return without a dwell at the top";
}

std::string ramp_words(const Scene& scene, const ValveRamp& ramp) {
    const MotionUnit length = shown_units(scene).motion[0].first;
    const ShownUnit velocity = scene.motion.lift_is_angle              ? unit_named<"deg/deg">
                               : scene.length_unit == LengthUnit::inch ? unit_named<"in/deg">
                                                                       : unit_named<"mm/deg">;
    return fmt::format("{} at {}{}", length.asked_text(ramp.height), velocity.text(ramp.velocity),
                       ramp.end
                           ? fmt::format(" up to {} from the checking point", degrees_shown.text(*ramp.end))
                           : std::string());
}

/// What the scene says of a valve, the follower's own numbers after it.
std::string valve_words(const Scene& scene) {
    const ValveSpec& valve = *scene.motion.valve;
    const ShownUnit length = shown_units(scene).length;
    const ShownUnit crank = unit_named<"crank deg">;
    std::string text = fmt::format(
        "; valve lift {}, lash {}, {} {}, duration {} at {} ({} of it before the nose)",
        length.asked_text(valve.lift), length.asked_text(valve.lash),
        scene.motion.lift_is_angle ? "valve arm" : "rocker ratio",
        scene.motion.lift_is_angle ? length.text(valve.ratio) : short_text(valve.ratio),
        crank.text(valve.duration), length.asked_text(valve.checking_height), crank.text(valve.opening));
    if (valve.centerline) text += fmt::format(", centerline {}", crank.text(*valve.centerline));
    if (scene.motion.speed)
        text += fmt::format(", engine speed {}", rpm_shown.text(2.0 * *scene.motion.speed));
    return text + fmt::format("; opening ramp {}, closing ramp {}", ramp_words(scene, valve.opening_ramp),
                              ramp_words(scene, valve.closing_ramp));
}

std::string motion_line(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    std::string text = fmt::format("Motion: {}, lift {}", kind_of_motion(motion),
                                   shown_units(scene).motion[0].first.text(motion.lift));
    if (motion.type != MotionType::program)
        text += fmt::format(", rise {} deg", short_text(degrees_shown.of(motion.rise)));
    if (motion.type == MotionType::rr)
        text += fmt::format(", return {} deg",
                            short_text(degrees_shown.of(motion.return_angle.value_or(motion.rise))));
    if (motion.speed) text += fmt::format(", at {} rpm", short_text(rpm_shown.of(*motion.speed)));
    if (motion.symmetric) text += ", symmetric";
    if (motion.relative) text += ", going on in the next revolution from where it ends";
    if (motion.repeat > 1) text += fmt::format(", {} equal parts", motion.repeat);
    if (motion.prescribed()) text += ": a prescribed motion, nothing to optimize";
    if (const std::size_t points = placed_points(motion).size(); points > 0)
        text += fmt::format(", with {} set point{}", points, points == 1 ? "" : "s");
    if (motion.valve) text += valve_words(scene);
    return text;
}

/// A closed program comes back: what moves last ends at 0 where it does not say so.
std::string end_text(const Scene& scene, std::size_t index) {
    const MotionSpec& motion = scene.motion;
    const ProgramSegment& segment = motion.segments[index];
    if (segment.kind == SegmentKind::dwell) return "";
    bool last = motion.closed;
    for (std::size_t i = index + 1; i < motion.segments.size(); ++i)
        last = last && motion.segments[i].kind == SegmentKind::dwell;
    if (!segment.to && !last) return " to where it is best";
    const double to = segment.to.value_or(0.0);
    return fmt::format(" to {} ({} of the lift)", shown_units(scene).motion[0].first.normalised_text(to),
                       short_text(to));
}

std::string range_words(const ProgramSegment& segment) {
    if (!segment.angle_range) return {};
    return fmt::format(" (searched {})",
                       angles_words(degrees_shown.of(segment.angle_range->least),
                                    degrees_shown.of(segment.angle_range->most), shown_digits));
}

std::string segment_line(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    std::string text;
    for (std::size_t i = 0; i < motion.own_segments(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const std::string kind =
            segment.kind == SegmentKind::law ? words_of(segment.law) : std::string(name_of(segment.kind));
        append_item(text, fmt::format("{} {} deg{}{}", kind, short_text(degrees_shown.of(segment.angle)),
                                      range_words(segment), end_text(scene, i)));
    }
    return "Segments: " + text;
}

/// Each in the units that a person reads, and normalised beside.
std::string set_point_line(const Scene& scene, const std::vector<PlacedPoint>& points) {
    const ShownUnits shown = shown_units(scene);
    const auto degrees = [&](double x) { return x * shown.degrees_per_x; };
    std::string text;
    for (const PlacedPoint& point : points) {
        std::string values;
        for (std::size_t order = 0; order < point.wanted.size(); ++order) {
            if (!point.wanted[order]) continue;
            const ShownDerivative& unit = shown.motion[order];
            const double wanted = *point.wanted[order];
            append_item(values,
                        fmt::format("{} {} ({}{} normalised)", unit.name, unit.first.normalised_text(wanted),
                                    unit.beside ? unit.beside->normalised_text(wanted) + ", " : "",
                                    short_text(wanted)));
        }
        const std::string where = angles_words(degrees(point.begin), degrees(point.end), shown_digits);
        append_item(text, fmt::format("{} (x = {}) {}", where, short_text(point.begin), values), "; ");
    }
    return "Set points: " + text;
}

/// States at the ends of a motion that does not rest there.
std::string end_state_text(const Scene& scene) {
    const ShownUnits shown = shown_units(scene);
    std::string text;
    for (const bool at_end : {false, true}) {
        const std::array<double, 2> state = end_velocities(scene.motion, at_end);
        if (scene.motion.periodic() || state == std::array<double, 2>{}) continue;
        append_item(
            text,
            fmt::format("{} at the {}, acceleration {}", shown.motion[1].first.normalised_text(state[0]),
                        at_end ? "end" : "start", shown.motion[2].first.normalised_text(state[1])));
    }
    return text;
}

std::string corridor_line(const Scene& scene) {
    const ShownUnits shown = shown_units(scene);
    std::string text;
    for (const MotionBound& bound : motion_bounds(scene))
        if (bound.corridor >= 0)
            append_item(
                text, fmt::format("{} {} {} {}", shown.motion[bound.order].name, bound.sign < 0 ? ">=" : "<=",
                                  bound.unit.empty() ? short_text(bound.given)
                                                     : short_text(bound.given) + " " + bound.unit,
                                  angles_words(bound.from * shown.degrees_per_x,
                                               bound.until * shown.degrees_per_x, shown_digits)));
    return "Corridors: " + text;
}

std::string measured_line(const MeasuredMotion& measured) {
    return fmt::format("Measured motion{}: {} rows, {}",
                       measured.name.empty() ? "" : " " + printable(measured.name), measured.angle.size(),
                       measured.start ? "where searches begin, too" : "for comparison");
}

std::string breakpoint_text(const SplineSpec& spline) {
    std::string text;
    for (const double x : spline.breakpoints) append_item(text, short_text(x));
    return text.empty() ? text : ", breakpoints at x = " + text;
}

std::string spline_line(const Scene& scene) {
    const SplineSpec& spline = scene.spline;
    const std::size_t segments = spline.breakpoints.empty() ? static_cast<std::size_t>(spline.segments)
                                                            : spline.breakpoints.size() - 1;
    const bool by_stroke = spline.by_stroke && spline.breakpoints.empty() &&
                           scene.motion.type == MotionType::rr && scene.motion.length() != 2.0;
    return fmt::format(
        "Spline: degree {}, {} {}segments{}, continuous up to derivative {}{}{}{}{}", spline.degree, segments,
        spline.breakpoints.empty() && !by_stroke ? "uniform " : "",
        scene.motion.type == MotionType::program ? " in each spline segment"
        : by_stroke                              ? ", half of them over the rise"
                                                 : "",
        spline.smoothness(), spline.end_jerk == EndJerk::zero ? ", zero jerk at the dwells" : "",
        spline.free_knots ? ", its breakpoints free" : "", breakpoint_text(spline),
        spline.design == DesignKind::automatic ? ""
                                               : fmt::format(", design vector: {}", name_of(spline.design)));
}

std::string range_text(const Dimension& dimension, const ShownUnit& unit) {
    if (!dimension.is_variable()) return unit.text(dimension.low);
    return fmt::format("free from {} to {}", short_text(unit.of(dimension.low)), unit.text(dimension.high));
}

/// Of a cam that has both: base and roller radius as one range.
std::optional<Dimension> prime_radius(const CamSpec& cam) {
    const Dimension* const base = cam.find(DimensionIndex::base_radius);
    const Dimension* const roller = cam.find(DimensionIndex::roller_radius);
    if (base == nullptr || roller == nullptr) return {};
    return Dimension(base->low + roller->low, base->high + roller->high);
}

std::string cam_line(const Scene& scene) {
    const CamSpec& cam = scene.cam.value();
    std::string text = fmt::format("Cam: {}", cam_text(cam));
    const ShownUnits shown = shown_units(scene);
    for (const CamDimension& dimension : cam.dimensions) {
        if (dimension.value.key.empty()) continue;  // this variant has no such dimension
        append_item(
            text, fmt::format("{} {}", words_of(dimension.name),
                              range_text(dimension.value, dimension.is_angle ? shown.angle : shown.length)));
    }
    if (const std::optional<Dimension> prime = prime_radius(cam))
        append_item(text, fmt::format("prime radius {}", range_text(*prime, shown.length)));
    if (cam.face_radius)
        append_item(text, fmt::format("radius of the round face {}", shown.length.text(*cam.face_radius)));
    else if (cam.face_half_width)
        append_item(text, fmt::format("half width of the face {}", shown.length.text(*cam.face_half_width)));
    return text;
}

std::string material_text(const char* part, const std::string& modulus, double poisson) {
    return fmt::format("modulus of the {} {}, its Poisson's ratio {}", part, modulus, short_text(poisson));
}

std::string damping_text(const Scene& scene, double damping) {
    return fmt::format("damping {} {}", short_text(damping),
                       scene.motion.lift_is_angle ? "N m s/rad" : "N s/m");
}

std::string force_line(const Scene& scene) {
    const ForceSpec& forces = *scene.forces;
    const ShownUnits shown = shown_units(scene);
    std::string text =
        fmt::format("Forces: {} {}, spring {}, preload {}", scene.motion.lift_is_angle ? "inertia" : "mass",
                    shown.mass.text(forces.mass), shown.spring_rate.text(forces.spring_rate),
                    shown.load.text(forces.preload));
    if (forces.damping > 0.0) append_item(text, damping_text(scene, forces.damping));
    if (!forces.load.empty()) {
        const auto [least, most] =
            std::ranges::minmax(forces.load, {}, [](const auto& point) { return point[1]; });
        append_item(text, least[1] == most[1]
                              ? "load " + shown.load.text(least[1])
                              : fmt::format("load {} to {} over the cam angle", shown.load.text(least[1]),
                                            shown.load.text(most[1])));
    }
    if (forces.spring_frequency)
        append_item(text, "natural frequency of the spring " + hertz_shown.text(*forces.spring_frequency));
    if (!forces.contact_width) return text;
    append_item(text, fmt::format("contact width {}", shown.length.text(*forces.contact_width)));
    append_item(text, material_text("cam", shown.modulus.text(forces.cam_modulus), forces.cam_poisson));
    append_item(text, material_text("follower", shown.modulus.text(forces.follower_modulus),
                                    forces.follower_poisson));
    return text;
}

/// What stands between the cam and the output, from the output back to the cam.
std::string train_line(const Scene& scene) {
    const DynamicsSpec& train = *scene.dynamics;
    const ShownUnits shown = shown_units(scene);
    std::string text = fmt::format("Elastic follower: {} {}", scene.motion.lift_is_angle ? "inertia" : "mass",
                                   shown.mass.text(train.mass));
    if (train.natural_frequency)
        append_item(text, "natural frequency " + hertz_shown.text(*train.natural_frequency));
    if (train.stiffness) append_item(text, "stiffness " + shown.spring_rate.text(*train.stiffness));
    if (train.damping_ratio) append_item(text, "damping ratio " + short_text(*train.damping_ratio));
    if (train.damping) append_item(text, damping_text(scene, *train.damping));
    for (const TrainStage& stage : train.stages) {
        append_item(text, fmt::format("a stage before it of {} on {}", shown.mass.text(stage.mass),
                                      shown.spring_rate.text(stage.stiffness)));
        if (stage.damping > 0.0) append_item(text, damping_text(scene, stage.damping), " and ");
    }
    if (train.return_stiffness > 0.0)
        append_item(text, "return spring " + shown.spring_rate.text(train.return_stiffness));
    if (train.preload > 0.0) append_item(text, "preload " + shown.load.text(train.preload));
    if (train.speed_range) append_item(text, speeds_words(*train.speed_range));
    return text;
}

std::string limit_text(const std::string& key, bool least, double given, const std::string& unit) {
    return fmt::format("{} {} {}{}{}", key_words(key).words, least ? ">=" : "<=", short_text(given),
                       unit.empty() ? "" : " ", unit_words(unit));
}

std::string drive_line(const Scene& scene) {
    const DriveSpec& drive = *scene.drive;
    const bool angle = scene.motion.lift_is_angle;
    std::string text =
        fmt::format("Motor in place of a cam: load {} {}", short_text(drive.load), angle ? "kg m²" : "kg");
    append_item(text, fmt::format("inertia of motor and gear {} kg m²", short_text(drive.motor_inertia)));
    const double a_turn = units::turn * drive.transmission;
    append_item(text, angle ? fmt::format("{} deg a revolution", short_text(degrees_shown.of(a_turn)))
                            : fmt::format("{} mm a revolution", short_text(millimetres_shown.of(a_turn))));
    const auto add = [&](const char* name, double value, const char* unit) {
        if (value != 0.0) append_item(text, fmt::format("{} {} {}", name, short_text(value), unit));
    };
    add("viscous friction", drive.viscous, angle ? "N m s/rad" : "N s/m");
    add(angle ? "constant moment" : "constant force", drive.force, angle ? "N m" : "N");
    add("dry friction", drive.friction, angle ? "N m" : "N");
    if (drive.cycle)
        append_item(text, fmt::format("cycle {} deg", short_text(degrees_shown.of(*drive.cycle))));
    return text;
}

/// Empty where nothing is limited.
std::string limit_line(const Scene& scene) {
    std::string text;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits))
            append_item(text, limit_text(limit->key, row.side < 0, limit->given, limit->unit) +
                                  (limit->unit.empty() ? " (normalised)" : ""));
    for (const LimitRow& row : limit_rows())
        if (const auto& limit = row.in(scene.limits))
            append_item(text, limit_text(limit->key, row.is_least(), limit->given(), limit->unit));
    std::string curve;
    for (const auto& [speed, torque] : scene.limits.motor_curve)
        append_item(curve,
                    fmt::format("{} N m at {} rpm", short_text(torque), short_text(rpm_shown.of(speed))));
    if (!curve.empty()) append_item(text, "torque-speed curve of the motor " + curve);
    return text;
}

std::string reference_text(const Reference& reference) {
    if (!reference.numeric) return fmt::format("that of the law {}", words_of(reference.law));
    std::string numbers;
    for (const CostTerm& term : cost_terms())
        if (const std::optional<double>& value = reference.*term.reference)
            append_item(numbers, fmt::format("{} {}", words_of(term.name()), short_text(*value)));
    for (const ResponseTerm& term : response_terms())
        if (const std::optional<double>& value = reference.*term.reference)
            append_item(numbers, fmt::format("{} {}", words_of(term.name), short_text(*value)));
    return fmt::format("that of the reference given as numbers{}", numbers.empty() ? "" : ": " + numbers);
}

std::string objective_line(const ObjectiveSpec& objective) {
    std::string terms;
    const auto term = [&](double weight, const std::string& name) {
        if (weight > 0.0)
            terms += fmt::format("{}{} × {}", terms.empty() ? "" : " + ", short_text(weight), name);
    };
    for (const CostTerm& row : cost_terms()) term(row.weight_in(objective), words_of(row.name()));
    for (const ResponseTerm& row : response_terms()) term(row.weight_in(objective), words_of(row.name));
    const std::size_t of_motion = terms.size();
    for (int i = 0; i < dimension_count; ++i)
        term(objective.dimensions[i], words_of(name_of(static_cast<DimensionIndex>(i))));
    if (terms.empty()) return "Objective: none";
    return fmt::format(
        "Objective: the least {}, each divided by {}{}{}", terms, reference_text(objective.reference),
        terms.size() > of_motion ? "; dimensions are divided by the lift" : "",
        objective.tie_break == TieBreak::none ? "" : "; among equals the one of least mean jerk");
}

std::string option_text(const OptionValue& value) {
    return std::visit(
        [](const auto& held) -> std::string {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, bool>)
                return held ? "true" : "false";
            else
                return fmt::format("{}", held);
        },
        value);
}

std::string solver_line(const SolverSpec& solver) {
    std::string text = fmt::format(
        "Solver: {}, tolerance {}, gap {}, at most {} s", solver.name, short_text(solver.tolerance),
        solver.gap ? short_text(*solver.gap)
                   : fmt::format("{} ({} where not convex)", short_text(solver.wanted_gap()),
                                 short_text(solver.wanted_gap(false))),
        short_text(solver.max_seconds));
    if (solver.starts) append_item(text, fmt::format("{} starts", *solver.starts));
    append_item(text, fmt::format("seed {}", solver.seed));
    for (const auto& [name, value] : solver.options)
        append_item(text, fmt::format("{} = {}", name, option_text(value)));
    return text;
}

}  // namespace

std::vector<std::string> scene_lines(const Scene& given) {
    const Scene scene = with_written_limits(given);
    std::vector<std::string> lines = {motion_line(scene)};
    if (scene.motion.type == MotionType::program) lines.push_back(segment_line(scene));
    if (const auto points = placed_points(scene.motion); !points.empty())
        lines.push_back(set_point_line(scene, points));
    if (const std::string ends = end_state_text(scene); !ends.empty()) lines.push_back("Ends: " + ends);
    if (!scene.motion.corridors.empty()) lines.push_back(corridor_line(scene));
    if (scene.measured) lines.push_back(measured_line(*scene.measured));
    if (!scene.motion.prescribed()) lines.push_back(spline_line(scene));
    if (scene.cam) lines.push_back(cam_line(scene));
    if (scene.forces) lines.push_back(force_line(scene));
    if (scene.dynamics) lines.push_back(train_line(scene));
    if (scene.drive) lines.push_back(drive_line(scene));
    if (const std::string limits = limit_line(scene); !limits.empty()) lines.push_back("Limits: " + limits);
    lines.push_back(objective_line(scene.objective));
    lines.push_back(solver_line(scene.solver));
    return lines;
}

}  // namespace camopt

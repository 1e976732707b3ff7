// SPDX-License-Identifier: MIT
#include "scene/machine_spec.hpp"

#include "core/text/quantity_text.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Fault = std::optional<SceneFault>;

constexpr std::size_t most_axis_name = 64;

bool is_folder_name(const std::string& name) {
    return !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    });
}

Fault speed_fault(const MachineSpec& machine) {
    const auto good = [](double speed) { return speed > 0.0 && std::isfinite(speed); };
    if (good(machine.least_speed) && good(machine.most_speed) && machine.most_speed >= machine.least_speed)
        return {};
    const double rpm = units::revolution_per_minute;
    return SceneFault{"machine.speed",
                      fmt::format("{:g} to {:g} rpm", machine.least_speed / rpm, machine.most_speed / rpm),
                      "a speed > 0, or a range of them with min < max"};
}

/// Why a scene is no axis of a machine.
Fault motion_fault(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    if (motion.type != MotionType::program)
        return SceneFault{
            "motion.type", fmt::format("\"{}\"", name_of(motion.type)),
            "in a machine \"program\": rise, return and dwells over the whole cycle as segments"};
    if (!motion.periodic())
        return SceneFault{"motion.closed", "false",
                          "in a machine a program over the whole cycle: true or \"relative\""};
    // The last stroke of a motion that closes returns to 0.
    const auto last =
        std::ranges::find_if(motion.segments.rbegin(), motion.segments.rend(),
                             [](const ProgramSegment& s) { return s.kind != SegmentKind::dwell; });
    for (std::size_t k = 0; k < motion.segments.size(); ++k) {
        const ProgramSegment& segment = motion.segments[k];
        const bool returns = !motion.relative && last != motion.segments.rend() && &segment == &*last;
        if (segment.kind != SegmentKind::dwell && !segment.to && !returns)
            return SceneFault{segment_key(k), "no displacement at its end",
                              "in a machine a given one: the strokes of its axes are not searched"};
    }
    if (scene.is_given())
        return SceneFault{"measured.use", "\"given\"",
                          "in a machine motions that are designed: the axes of a given cam are not searched"};
    if (scene.spline.free_knots)
        return SceneFault{"spline.knots", "\"free\"", "in a machine fixed breakpoints"};
    if (scene.drive && scene.drive->transmission_range)
        return SceneFault{"drive.transmission", "a range", "in a machine a fixed number"};
    for (const SpringNumber& number : spring_numbers)
        if (scene.forces && (*scene.forces).*number.range)
            return SceneFault{number.key, "a range", "in a machine a fixed number"};
    if (scene.cam)
        for (const CamDimension& dimension : scene.cam->dimensions)
            if (dimension.value.is_variable())
                return SceneFault{dimension.value.key.empty() ? "cam" : dimension.value.key, "a range",
                                  "in a machine a fixed dimension"};
    return {};
}

Fault axis_fault(const MachineSpec& machine, std::size_t index) {
    const AxisSpec& axis = machine.axes[index];
    const std::string member = entry_key("axis", index);
    if (!(std::abs(axis.phase) < units::turn))
        return SceneFault{member + ".phase", fmt::format("{:g} deg", axis.phase / units::degree),
                          "an angle above -360 deg and below 360 deg: within the cycle"};
    if (Fault fault = motion_fault(axis.scene))
        return SceneFault{member + ".scene." + fault->member, fault->found, fault->allowed};
    if (axis.scene.prescribes_output() && machine.most_speed > machine.least_speed)
        return SceneFault{member + ".scene.dynamics.prescribe", "\"output\" where machine.speed is a range",
                          "a given machine.speed: at every speed it is another cam"};
    if (const std::optional<SoughtKey>& sought = axis.scene.objective.sought)
        return SceneFault{
            fmt::format("{}.scene.{}", member, sought->member()), fmt::format("\"{}\"", sought->key),
            "none in an axis: a machine seeks its largest speed, where machine.speed is a range"};
    return {};
}

/// Lengths between axes that translate, angles between axes that swing; in SI without a unit.
Fault clearance_unit_fault(const Clearance& clearance, const AxisSpec& axis, const std::string& member) {
    const bool swings = axis.scene.motion.lift_is_angle;
    if (clearance.unit.empty() || swings == is_angle_unit(clearance.unit)) return {};
    const auto row = std::ranges::find(machine_rows(), "at_least", &KeyRow::name);
    const std::array names = {row->names()};
    const auto fits = [&](const Spelling& one) { return is_angle_unit(one.unit) == swings; };
    return SceneFault{member + ".at_least",
                      fmt::format("{} with \"{}\", whose displacement is {}", clearance.unit, axis.name,
                                  length_or_angle(swings)),
                      keys_text(names, fits)};
}

Fault clearance_fault(const MachineSpec& machine, std::size_t index) {
    const Clearance& clearance = machine.clearances[index];
    const std::string member = name_of_clearance(static_cast<int>(index));
    if (clearance.axes.empty()) return SceneFault{member + ".between", "no axis", "one axis or more"};
    for (std::size_t k = 0; k < clearance.axes.size(); ++k) {
        const int axis = clearance.axes[k];
        if (axis < 0 || axis >= static_cast<int>(machine.axes.size()))
            return SceneFault{member + ".between", fmt::format("axis {}", axis),
                              fmt::format("0 to {}", static_cast<int>(machine.axes.size()) - 1)};
        const AxisSpec& used = machine.axes[static_cast<std::size_t>(axis)];
        if (std::ranges::count(clearance.axes, axis) > 1)
            return SceneFault{member + ".between", fmt::format("\"{}\" twice", used.name), "each axis once"};
        const AxisSpec& first = machine.axes[static_cast<std::size_t>(clearance.axes.front())];
        if (used.scene.motion.lift_is_angle != first.scene.motion.lift_is_angle)
            return SceneFault{
                member + ".between",
                fmt::format("\"{}\", a length, together with \"{}\", an angle",
                            used.scene.motion.lift_is_angle ? first.name : used.name,
                            used.scene.motion.lift_is_angle ? used.name : first.name),
                "axes that all translate or all swing: a sum of lengths and angles has no unit"};
    }
    const AxisSpec& any_axis = machine.axes[static_cast<std::size_t>(clearance.axes.front())];
    if (Fault fault = clearance_unit_fault(clearance, any_axis, member)) return fault;
    if (clearance.factors.size() != clearance.axes.size())
        return SceneFault{member + ".factors", fmt::format("{} numbers", clearance.factors.size()),
                          fmt::format("{}: one for each axis of `between`", clearance.axes.size())};
    for (const double factor : clearance.factors)
        if (!std::isfinite(factor))
            return SceneFault{member + ".factors", fmt::format("{}", factor), "finite numbers"};
    if (std::ranges::all_of(clearance.factors, [](double factor) { return factor == 0.0; }))
        return SceneFault{member + ".factors", "only 0", "one number or more other than 0"};
    if (!std::isfinite(clearance.at_least))
        return SceneFault{member + ".at_least", fmt::format("{}", clearance.at_least), "a finite number"};
    const auto inside = [](double angle) { return angle >= 0.0 && angle <= units::turn; };
    if (!inside(clearance.from) || !inside(clearance.to) || clearance.from == clearance.to)
        return SceneFault{
            member + ".from",
            fmt::format("{:g} deg to {:g} deg", clearance.from / units::degree, clearance.to / units::degree),
            "two different angles from 0 to 360 deg; from > to passes 360 deg"};
    return {};
}

}  // namespace

std::optional<SceneFault> find_name_fault(const MachineSpec& machine, std::size_t index) {
    const AxisSpec& axis = machine.axes[index];
    const std::string member = entry_key("axis", index, "name");
    if (!is_folder_name(axis.name))
        return SceneFault{member, fmt::format("\"{}\"", axis.name),
                          "letters, digits, '_' and '-': the folder of its results has this name"};
    if (axis.name.size() > most_axis_name)
        return SceneFault{member, fmt::format("a name of {} letters", axis.name.size()),
                          fmt::format("at most {}: the folder of its results has this name", most_axis_name)};
    for (std::size_t other = 0; other < index; ++other)
        if (machine.axes[other].name == axis.name)
            return SceneFault{member, fmt::format("\"{}\" a second time", axis.name),
                              "another name for every axis"};
    return {};
}

std::optional<SceneFault> find_fault(const MachineSpec& machine) {
    if (Fault fault = speed_fault(machine)) return fault;
    if (machine.axes.empty()) return SceneFault{"axis", "none", "one [[axis]] or more"};
    for (std::size_t k = 0; k < machine.axes.size(); ++k)
        if (Fault fault = find_name_fault(machine, k)) return fault;
    for (std::size_t k = 0; k < machine.axes.size(); ++k)
        if (Fault fault = axis_fault(machine, k)) return fault;
    for (std::size_t k = 0; k < machine.clearances.size(); ++k)
        if (Fault fault = clearance_fault(machine, k)) return fault;
    return {};
}

std::string name_of_clearance(int index) {
    return entry_key("clearance", index);
}

}  // namespace camopt

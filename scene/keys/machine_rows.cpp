// SPDX-License-Identifier: MIT
// The rows of a machine file.
#include "scene/key_place.hpp"
#include "scene/machine_spec.hpp"

#include <fmt/ranges.h>

namespace camopt {
namespace {

using enum KeyType;
using namespace spellings;
using key_place::each;

/// A number is a range of one.
KeyPlace speed_place() {
    return {.assign =
                [](MachineSpec& machine, const KeyValue& value, const KeyAt&) {
                    const auto* const range = std::get_if<KeyBounds>(&value);
                    machine.least_speed = range != nullptr ? *range->least : std::get<double>(value);
                    machine.most_speed = range != nullptr ? *range->most : machine.least_speed;
                },
            .value = [](const MachineSpec& machine, const KeyAt&) -> std::optional<KeyValue> {
                if (!machine.searches_speed()) return machine.least_speed;
                return KeyBounds{machine.least_speed, machine.most_speed};
            }};
}

KeyPlace name_place() {
    KeyPlace place = stored_in(&MachineSpec::axes, each, &AxisSpec::name);
    place.assign = [](MachineSpec& machine, const KeyValue& value, const KeyAt& at) {
        machine.axes.at(at.entry[0]).name = std::get<std::string>(value);
        if (const auto fault = find_name_fault(machine, at.entry[0]))
            throw RefusedValue(0, fault->found, fault->allowed);
    };
    return place;
}

/// Names of axes, which are read before; each has the factor 1 until others are read.
void assign_axes(MachineSpec& machine, const KeyValue& value, const KeyAt& at) {
    Clearance& clearance = machine.clearances.at(at.entry[0]);
    std::vector<std::string> names(machine.axes.size());
    std::ranges::transform(machine.axes, names.begin(), &AxisSpec::name);
    const auto& between = std::get<std::vector<std::string>>(value);
    for (std::size_t i = 0; i < between.size(); ++i) {
        const auto found = std::ranges::find(names, between[i]);
        if (found == names.end())
            throw RefusedValue(i, fmt::format("\"{}\"", between[i]),
                               fmt::format("{}{}", fmt::join(names, ", "), spelling_hint(between[i], names)));
        clearance.axes.push_back(static_cast<int>(found - names.begin()));
    }
    clearance.factors.assign(clearance.axes.size(), 1.0);
}

KeyPlace axes_place() {
    return {.assign = assign_axes,
            .value = [](const MachineSpec& machine, const KeyAt& at) -> std::optional<KeyValue> {
                std::vector<std::string> names;
                for (const int axis : machine.clearances.at(at.entry[0]).axes)
                    names.push_back(machine.axes.at(axis).name);
                return names;
            },
            .entries = 1};
}

/// With its key and unit as written, for messages.
KeyPlace least_place() {
    KeyPlace place = stored_in(&MachineSpec::clearances, each, &Clearance::at_least);
    place.assign = [](MachineSpec& machine, const KeyValue& value, const KeyAt& at) {
        Clearance& clearance = machine.clearances.at(at.entry[0]);
        clearance.at_least = std::get<double>(value);
        clearance.unit = at.spelling->unit;
        clearance.unit_value = at.spelling->factor;
        clearance.key = fmt::format("{}.at_least{}", name_of_clearance(static_cast<int>(at.entry[0])),
                                    at.spelling->suffix);
    };
    place.unit = [](const MachineSpec& machine, const KeyAt& at) {
        return machine.clearances.at(at.entry[0]).unit;
    };
    return place;
}

template <class Member>
KeyPlace in_axis(Member member) {
    return stored_in(&MachineSpec::axes, each, member);
}

template <class Member>
KeyPlace in_clearance(Member member) {
    return stored_in(&MachineSpec::clearances, each, member);
}

// A row is read as a row.
// clang-format off
std::vector<KeyRow> rows_of_machine() {
    return {
        {"", "title", text, plain, any, {}, "none", "Appears in reports.", stored_in(&MachineSpec::title)},
        {"", "machine", table, plain, any, {}, "required", "What all axes share."},
        {"", "axis", tables, plain, any, {}, "required", "The axes.", stored_in(&MachineSpec::axes)},
        {"", "clearance", tables, plain, any, {}, "none",
         "Σ factor · displacement >= at_least, at every angle of the master between `from` and `to`.", stored_in(&MachineSpec::clearances)},
        {"machine", "speed", number_or_range, speed, positive, {}, "required",
         "Speed of the master: the least total objective is found at it. A range: the largest feasible speed in it is searched.",
         speed_place()},
        {"axis", "name", text, plain, any, {}, "required",
         "Letters, digits, `_` and `-`: the folder of its results has this name.", name_place()},
        {"axis", "scene", text, plain, any, {}, "required",
         "Its scene file, a program over one revolution, by its path from this file. The speed of the machine replaces its own.",
         in_axis(&AxisSpec::file)},
        {"axis", "phase", number, angle, any, {}, "0", "Angle of the master at which its motion starts, above -360 and below 360 deg.",
         in_axis(&AxisSpec::phase)},
        {"clearance", "between", texts, plain, any, {}, "required", "Names of axes, all of which translate or all swing.", axes_place()},
        {"clearance", "factors", numbers, plain, any, {}, "1", "A factor for each of these axes.", in_clearance(&Clearance::factors)},
        {"clearance", "at_least", number, lift, any, {}, "required", "Of the sum: a length of axes that translate, an angle of axes that swing.",
         least_place()},
        {"clearance", "from", number, angle, any, {}, "0", "Angle of the master where it begins to hold; `from` > `to` passes 360 deg.",
         in_clearance(&Clearance::from)},
        {"clearance", "to", number, angle, any, {}, "360 deg", "Angle of the master where it ends.", in_clearance(&Clearance::to)},
    };
}
// clang-format on

}  // namespace

const std::vector<KeyRow>& machine_rows() {
    static const std::vector<KeyRow> rows = rows_of_machine();
    return rows;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using Figure = LimitedFigure;
using Sense = LimitRow::Sense;
using Cams = LimitRow::Cams;
using Size = LimitRow::Size;

constexpr std::string_view names_of_velocity[] = {"max_velocity", "velocity_max"};
constexpr std::string_view names_of_acceleration[] = {"max_acceleration", "acceleration_max"};
constexpr std::string_view names_of_jerk[] = {"max_jerk", "jerk_max"};
constexpr std::string_view names_of_pressure_angle[] = {"max_pressure_angle", "pressure_angle_max",
                                                        "transmission_angle"};
constexpr std::string_view names_of_convex_radius[] = {"min_radius", "radius_min"};
constexpr std::string_view names_of_regularity[] = {"undercut"};

using ranges::not_negative, ranges::positive;

constexpr Range right_angle = {
    .low = 0.0, .high = 0.5 * std::numbers::pi, .low_included = false, .high_included = false};
constexpr Range below_one = {.low = 0.0, .high = 1.0, .high_included = false};

// A row is read as a row.
// clang-format off
constexpr std::array<PeakLimitRow, 18> peak_rows = {{
    {CostFigure::velocity, "velocity", spellings::velocity, &LimitSpec::velocity,
     "Cap on the velocity: on the normalised peak V, by the cam angle, or in time (needs a speed).", names_of_velocity},
    {CostFigure::acceleration, "acceleration", spellings::acceleration, &LimitSpec::acceleration,
     "Cap on the acceleration: on the normalised peak A, by the cam angle, or in time (needs a speed).", names_of_acceleration},
    {CostFigure::jerk, "jerk", spellings::jerk, &LimitSpec::jerk,
     "Cap on the jerk: on the normalised peak J, by the cam angle, or in time (needs a speed).", names_of_jerk},
    {CostFigure::velocity, "velocity", spellings::velocity, &LimitSpec::velocity_min, "", {}, -1, "velocity_min"},
    {CostFigure::velocity, "velocity", spellings::velocity, &LimitSpec::velocity_max, "", {}, 1, "velocity_max"},
    {CostFigure::acceleration, "acceleration", spellings::acceleration, &LimitSpec::acceleration_min, "", {}, -1, "acceleration_min"},
    {CostFigure::acceleration, "acceleration", spellings::acceleration, &LimitSpec::acceleration_max, "", {}, 1, "acceleration_max"},
    {CostFigure::jerk, "jerk", spellings::jerk, &LimitSpec::jerk_min, "", {}, -1, "jerk_min"},
    {CostFigure::jerk, "jerk", spellings::jerk, &LimitSpec::jerk_max, "", {}, 1, "jerk_max"},
    {CostFigure::velocity, "cam_velocity", spellings::velocity, &LimitSpec::cam_velocity,
     "Cap on the velocity of the cam's own motion, in the spellings of velocity; only where the output is prescribed (dynamics.prescribe).", {}, 0, nullptr, true},
    {CostFigure::acceleration, "cam_acceleration", spellings::acceleration, &LimitSpec::cam_acceleration,
     "Cap on the acceleration of the cam's own motion, in the spellings of acceleration; only where the output is prescribed (dynamics.prescribe).", {}, 0, nullptr, true},
    {CostFigure::jerk, "cam_jerk", spellings::jerk, &LimitSpec::cam_jerk,
     "Cap on the jerk of the cam's own motion, in the spellings of jerk; only where the output is prescribed (dynamics.prescribe).", {}, 0, nullptr, true},
    {CostFigure::velocity, "cam_velocity", spellings::velocity, &LimitSpec::cam_velocity_min, "", {}, -1, "cam_velocity_min", true},
    {CostFigure::velocity, "cam_velocity", spellings::velocity, &LimitSpec::cam_velocity_max, "", {}, 1, "cam_velocity_max", true},
    {CostFigure::acceleration, "cam_acceleration", spellings::acceleration, &LimitSpec::cam_acceleration_min, "", {}, -1, "cam_acceleration_min", true},
    {CostFigure::acceleration, "cam_acceleration", spellings::acceleration, &LimitSpec::cam_acceleration_max, "", {}, 1, "cam_acceleration_max", true},
    {CostFigure::jerk, "cam_jerk", spellings::jerk, &LimitSpec::cam_jerk_min, "", {}, -1, "cam_jerk_min", true},
    {CostFigure::jerk, "cam_jerk", spellings::jerk, &LimitSpec::cam_jerk_max, "", {}, 1, "cam_jerk_max", true},
}};
// clang-format on

constexpr std::array<LimitRow, limited_figure_count> cam_limit_rows = {{
    {.figure = Figure::pressure_angle,
     .name = "pressure_angle",
     .limit = &LimitSpec::pressure_angle,
     .spellings = spellings::angle,
     .sense = Sense::most,
     .range = right_angle,
     .meaning = "Cap on the pressure angle at every cam angle; where the two below replace it still at rest "
                "and in dwells.",
     .words = figure_words::pressure_angle,
     .also_called = names_of_pressure_angle},
    {.figure = Figure::rise_pressure_angle,
     .name = "rise_pressure_angle",
     .limit = &LimitSpec::rise_pressure_angle,
     .spellings = spellings::angle,
     .sense = Sense::most,
     .range = right_angle,
     .cams = Cams::disk,
     .default_text = "pressure_angle",
     .meaning = "Cap on the pressure angle while the follower rises; at rest and in dwells the least of the "
                "three holds.",
     .words = figure_words::rise_pressure_angle},
    {.figure = Figure::return_pressure_angle,
     .name = "return_pressure_angle",
     .limit = &LimitSpec::return_pressure_angle,
     .spellings = spellings::angle,
     .sense = Sense::most,
     .range = right_angle,
     .cams = Cams::disk,
     .default_text = "pressure_angle",
     .meaning = "Cap on the pressure angle while the follower returns; at rest and in dwells the least of "
                "the three holds.",
     .words = figure_words::return_pressure_angle},
    {.figure = Figure::convex_radius,
     .name = "cam_radius_min",
     .limit = &LimitSpec::cam_radius_min,
     .spellings = spellings::length,
     .sense = Sense::least,
     .range = not_negative,
     .cams = Cams::planar,
     .size = Size::base_radius,
     .meaning = "Least convex radius of curvature of the cam surface; 0: just no undercut.",
     .words = figure_words::convex_radius,
     .also_called = names_of_convex_radius},
    {.figure = Figure::concave_radius,
     .name = "concave_radius_min",
     .limit = &LimitSpec::concave_radius_min,
     .spellings = spellings::length,
     .sense = Sense::least,
     .range = not_negative,
     .cams = Cams::planar,
     .may_be_infinite = true,  // a cam that is nowhere concave
     .size = Size::base_radius,
     .refusal = {ContactKind::flat, "a concave radius",
                 "only with rollers and knife edges: a flat face touches no concave cam"},
     .meaning = "Least concave radius of curvature of the cam surface; not for flat faces, which touch no "
                "concave cam.",
     .words = figure_words::concave_radius},
    {.figure = Figure::regularity,
     .name = "undercut_margin",
     .limit = &LimitSpec::undercut_margin,
     .spellings = spellings::plain,
     .sense = Sense::least,
     .range = below_one,
     .size = Size::one,
     .meaning = "Least distance from undercut: 1 - roller radius / radius of the pitch curve (roller), cam "
                "radius / base radius (flat face); 0: just no undercut.",
     .words = figure_words::regularity,
     .also_called = names_of_regularity},
    {.figure = Figure::contact_force,
     .name = "contact_force_min",
     .limit = &LimitSpec::contact_force_min,
     .spellings = spellings::force,
     .sense = Sense::least,
     .range = not_negative,
     .needs_forces = true,
     .size = Size::largest_force,
     .meaning = "Least force that presses a translating follower on the cam.",
     .swinging = {"contact_moment_min", spellings::moment,
                  "Least moment that presses an oscillating follower on the cam."}},
    {.figure = Figure::contact_force_most,
     .name = "contact_force_max",
     .limit = &LimitSpec::contact_force_max,
     .spellings = spellings::force,
     .sense = Sense::most,
     .range = positive,
     .needs_forces = true,
     .meaning =
         "Cap on the force that presses a translating follower on the cam; in a groove, on two flanks or "
         "two cams to either side.",
     .swinging =
         {"contact_moment_max", spellings::moment,
          "Cap on the moment that presses an oscillating follower on the cam; to either side where both "
          "carry."}},
    {.figure = Figure::torque,
     .name = "torque_max",
     .limit = &LimitSpec::torque_max,
     .spellings = spellings::moment,
     .sense = Sense::most,
     .range = positive,
     .needs_forces = true,
     .needs_contact = true,  // it can be computed without a contact, but not exerted
     .meaning = "Cap on the torque of the camshaft, to either side.",
     .words = figure_words::torque},
    {.figure = Figure::hertz_pressure,
     .name = "hertz_pressure_max",
     .limit = &LimitSpec::hertz_pressure_max,
     .spellings = spellings::pressure,
     .sense = Sense::most,
     .range = positive,
     .needs_forces = true,
     .needs_contact_width = true,
     .needs_contact = true,
     .refusal = {ContactKind::edge, "a pressure",
                 "only with rollers and flat faces: under an edge it is infinite"},
     .meaning = "Cap on the Hertz pressure; needs `forces.contact_width`.",
     .words = figure_words::hertz_pressure},
    {.figure = Figure::residual,
     .name = "residual",
     .limit = &LimitSpec::residual,
     .spellings = spellings::vibration,
     .sense = Sense::most,
     .range = positive,
     .needs_dynamics = true,
     .meaning = "Cap on the amplitude of the output's free vibration after each rise and return, over "
                "`dynamics.speed_range`.",
     .words = "largest residual vibration"},
    {.figure = Figure::dynamic_contact_force,
     .name = "dynamic_contact_force_min",
     .limit = &LimitSpec::dynamic_contact_force_min,
     .spellings = spellings::force_or_moment,
     .sense = Sense::least,
     .range = not_negative,
     .needs_dynamics = true,
     .size = Size::one,
     .meaning =
         "Least force (swinging: moment) of the elastic train on the cam, over `dynamics.speed_range`; "
         "needs a return spring or a preload."},
    {.figure = Figure::motor_torque,
     .name = "motor_torque",
     .limit = &LimitSpec::motor_torque,
     .spellings = spellings::moment,
     .sense = Sense::most,
     .range = positive,
     .needs_drive = true,
     .meaning =
         "Cap on the magnitude of the motor's torque at every angle; a table `{ min, max }`: one limit "
         "for each side."},
    {.figure = Figure::motor_torque_min,
     .name = "motor_torque_min",
     .limit = &LimitSpec::motor_torque_min,
     .spellings = spellings::moment,
     .sense = Sense::least,
     .range = ranges::any,
     .needs_drive = true,
     .side = "min",
     .table = "motor_torque"},
    {.figure = Figure::motor_torque_max,
     .name = "motor_torque_max",
     .limit = &LimitSpec::motor_torque_max,
     .spellings = spellings::moment,
     .sense = Sense::most,
     .range = ranges::any,
     .needs_drive = true,
     .side = "max",
     .table = "motor_torque"},
    {.figure = Figure::motor_torque_rms,
     .name = "motor_torque_rms",
     .limit = &LimitSpec::motor_torque_rms,
     .spellings = spellings::moment,
     .sense = Sense::most,
     .range = positive,
     .needs_drive = true,
     .meaning = "Cap on the root mean square of the motor's torque over the cycle, rests included."},
    {.figure = Figure::motor_speed,
     .name = "motor_speed",
     .limit = &LimitSpec::motor_speed,
     .spellings = spellings::speed,
     .sense = Sense::most,
     .range = positive,
     .needs_drive = true,
     .meaning = "Cap on the speed of the motor."},
    {.figure = Figure::spring_harmonic,
     .name = "spring_harmonic",
     .limit = &LimitSpec::spring_harmonic,
     .spellings = spellings::vibration,
     .sense = Sense::most,
     .range = positive,
     .needs_forces = true,
     .meaning = "Cap on the amplitude of the harmonics of the lift that excite the spring; needs "
                "`forces.spring_frequency`."},
}};

constexpr bool limits_in_order() {
    for (std::size_t i = 0; i < cam_limit_rows.size(); ++i)
        if (cam_limit_rows[i].figure != static_cast<Figure>(i)) return false;
    return true;
}
static_assert(limits_in_order(), "a row stands where its figure does in LimitedFigure");

}  // namespace

std::string LimitRow::first_key() const {
    return fmt::format("{}{}", name, spellings.front().suffix);
}

std::span<const PeakLimitRow> peak_limit_rows() {
    return peak_rows;
}

std::span<const LimitRow> limit_rows() {
    return cam_limit_rows;
}

const LimitRow& limit_row(LimitedFigure figure) {
    return cam_limit_rows.at(static_cast<std::size_t>(figure));
}

const std::optional<WrittenLimit>& limit_on(const LimitSpec& limits, LimitedFigure figure) {
    return limit_row(figure).in(limits);
}

const LimitRow* limit_named(std::string_view name) {
    for (const LimitRow& row : cam_limit_rows)
        if (name == row.name || (row.swinging.name != nullptr && name == row.swinging.name)) return &row;
    return nullptr;
}

const char* limit_name_in(std::string_view key) {
    const char* longest = nullptr;  // "rise_pressure_angle" has "pressure_angle" in it
    for (const LimitRow& row : cam_limit_rows)
        for (const char* name : {row.name, row.swinging.name}) {
            if (name == nullptr || key.find(name) == std::string_view::npos) continue;
            if (longest == nullptr || std::string_view(name).size() > std::string_view(longest).size())
                longest = name;
        }
    return longest;
}

bool is_least_limit(std::string_view name) {
    if (const LimitRow* const row = limit_named(name)) return row->is_least();
    if (name.starts_with("corridor_")) return name.ends_with("_min");
    return std::ranges::any_of(peak_rows,
                               [&](const PeakLimitRow& row) { return row.side < 0 && name == row.name(); });
}

bool limits_cam(const LimitSpec& limits) {
    return std::ranges::any_of(
        cam_limit_rows, [&](const LimitRow& row) { return row.of_cam() && row.in(limits).has_value(); });
}

bool limits_forces(const LimitSpec& limits) {
    return std::ranges::any_of(
        cam_limit_rows, [&](const LimitRow& row) { return row.needs_forces && row.in(limits).has_value(); });
}

bool limits_spring(const LimitSpec& limits) {
    LimitSpec without = limits;
    without.spring_harmonic.reset();  // of the motion alone
    return limits_forces(without);
}

}  // namespace camopt

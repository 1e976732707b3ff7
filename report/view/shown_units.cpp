// SPDX-License-Identifier: MIT
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr std::size_t derivatives = 4;
constexpr std::array<const char*, derivatives> symbols_in_time = {"s", "v", "a", "j"};
constexpr std::array<const char*, derivatives> symbols_by_angle = {"s", "ds/dθ", "d²s/dθ²", "d³s/dθ³"};
constexpr std::array<const char*, derivatives> columns_by_angle = {"s", "ds", "dds", "ddds"};

/// Of the displacement and its derivatives, seen in one way.
using UnitRows = std::array<Spelling, derivatives>;

constexpr UnitRows millimetres_in_time = units_named<"mm", "mm/s", "m/s^2", "m/s^3">;
constexpr UnitRows millimetres_by_angle = units_named<"mm", "mm/rad", "mm/rad^2", "mm/rad^3">;
constexpr UnitRows inches_in_time = units_named<"in", "in/s", "in/s^2", "in/s^3">;
constexpr UnitRows inches_by_angle = units_named<"in", "in/rad", "in/rad^2", "in/rad^3">;
constexpr UnitRows swing_in_time = units_named<"deg", "deg/s", "deg/s^2", "deg/s^3">;
constexpr UnitRows swing_by_angle = units_named<"deg", "deg/deg", "deg/deg^2", "deg/deg^3">;

const UnitRows& rows_of(const MotionSpec& motion, LengthUnit length, bool in_time) {
    if (motion.lift_is_angle) return in_time ? swing_in_time : swing_by_angle;
    if (length == LengthUnit::inch) return in_time ? inches_in_time : inches_by_angle;
    return in_time ? millimetres_in_time : millimetres_by_angle;
}

MotionUnit motion_unit(const MotionSpec& motion, LengthUnit length, std::size_t order, bool in_time) {
    const Spelling& shown = rows_of(motion, length, in_time)[order];
    const double rate = in_time ? *motion.speed / motion.unit_angle() : 1.0 / motion.unit_angle();
    MotionUnit unit{shown};
    unit.order = order;
    unit.per_normalised = motion.lift / unit.size * std::pow(rate, static_cast<int>(order));
    unit.symbol = (in_time ? symbols_in_time : symbols_by_angle)[order];
    unit.column = fmt::format("{}{}", (in_time ? symbols_in_time : columns_by_angle)[order], shown.suffix);
    return unit;
}

ShownDerivative shown_derivative(const MotionSpec& motion, LengthUnit length, std::size_t order) {
    const bool in_time = motion.speed.has_value();
    ShownDerivative shown{derivative_names[order], motion_unit(motion, length, order, in_time), {}};
    if (in_time && order > 0) shown.beside = motion_unit(motion, length, order, false);
    return shown;
}

std::string with_unit_name(double value, const std::string& name, int digits) {
    return short_text(value, digits) + (name.empty() ? "" : " " + unit_words(name));
}

}  // namespace

std::string ShownUnit::text(double si, int digits) const {
    return with_unit_name(of(si), name, digits);
}

std::string ShownUnit::asked_text(double si) const {
    const double thousandths = 1e3 * of(si);
    const bool whole = name == "in" && std::abs(thousandths - std::round(thousandths)) < 1e-6;
    return whole ? fmt::format("{:.3f} in", of(si)) : text(si);
}

std::string MotionUnit::normalised_text(double y, int digits) const {
    return with_unit_name(per_normalised * y, name, digits);
}

ShownUnit length_shown(LengthUnit length) {
    return length == LengthUnit::inch ? unit_named<"in"> : unit_named<"mm">;
}

ShownUnit weight_shown(LengthUnit length) {
    return length == LengthUnit::inch ? unit_named<"lb"> : unit_named<"kg">;
}

namespace {

/// Those that do not depend on whether the follower swings.
ShownUnits units_in(LengthUnit length) {
    ShownUnits shown;
    const bool inches = length == LengthUnit::inch;
    shown.length = length_shown(length);
    shown.curvature.name = "1/" + shown.length.name;
    shown.curvature.size = 1.0 / shown.length.size;
    shown.angle = degrees_shown;
    shown.speed = rpm_shown;
    shown.force = inches ? unit_named<"lbf"> : unit_named<"N">;
    shown.torque = inches ? unit_named<"lbf in"> : unit_named<"N m">;
    shown.pressure = inches ? unit_named<"ksi"> : unit_named<"MPa">;
    shown.modulus = inches ? unit_named<"ksi"> : unit_named<"GPa">;
    return shown;
}

}  // namespace

ShownUnits shown_units(const MotionSpec& motion, LengthUnit length) {
    ShownUnits shown = units_in(length);
    for (std::size_t order = 0; order < derivatives; ++order)
        shown.motion[order] = shown_derivative(motion, length, order);
    shown.in_time = motion.speed.has_value();
    shown.degrees_per_x = motion.unit_angle() / units::degree;
    const bool inches = length == LengthUnit::inch;
    if (motion.lift_is_angle) {
        shown.spring_rate = inches ? unit_named<"lbf in/rad"> : unit_named<"N m/rad">;
        shown.vibration = unit_named<"mdeg">;
        shown.mass = unit_named<"kg m^2">;
        shown.load = shown.torque;
    } else {
        shown.spring_rate = inches ? unit_named<"lbf/in"> : unit_named<"N/mm">;
        shown.vibration = inches ? unit_named<"mil"> : unit_named<"um">;
        shown.mass = weight_shown(length);
        shown.load = shown.force;
    }
    return shown;
}

ShownUnits shown_units(const Scene& scene) {
    return shown_units(scene.motion, scene.length_unit);
}

double acceleration_at(const Scene& scene, double normalised, double speed) {
    const double faster = speed / scene.motion.speed.value();
    return normalised * shown_units(scene).motion[2].first.per_normalised * faster * faster;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr std::size_t derivatives = 4;
constexpr std::array<const char*, derivatives> derivative_names = {"displacement", "velocity", "acceleration",
                                                                   "jerk"};
constexpr std::array<const char*, derivatives> symbols_in_time = {"s", "v", "a", "j"};
constexpr std::array<const char*, derivatives> symbols_by_angle = {"s", "ds/dθ", "d²s/dθ²", "d³s/dθ³"};

/// How one way to see the motion is written: units, their sizes in SI, columns of tables.
struct UnitRow {
    const char* name;
    double size;
    const char* column;
};
using UnitRows = std::array<UnitRow, derivatives>;

constexpr UnitRows millimetres_in_time = {{{"mm", millimetre, "s_mm"},
                                           {"mm/s", millimetre, "v_mm_s"},
                                           {"m/s²", 1.0, "a_m_s2"},
                                           {"m/s³", 1.0, "j_m_s3"}}};
constexpr UnitRows millimetres_by_angle = {{{"mm", millimetre, "s_mm"},
                                            {"mm/rad", millimetre, "ds_mm_rad"},
                                            {"mm/rad²", millimetre, "dds_mm_rad2"},
                                            {"mm/rad³", millimetre, "ddds_mm_rad3"}}};
constexpr UnitRows inches_in_time = {{{"in", units::inch, "s_in"},
                                      {"in/s", units::inch, "v_in_s"},
                                      {"in/s²", units::inch, "a_in_s2"},
                                      {"in/s³", units::inch, "j_in_s3"}}};
constexpr UnitRows inches_by_angle = {{{"in", units::inch, "s_in"},
                                       {"in/rad", units::inch, "ds_in_rad"},
                                       {"in/rad²", units::inch, "dds_in_rad2"},
                                       {"in/rad³", units::inch, "ddds_in_rad3"}}};
constexpr UnitRows swing_in_time = {{{"deg", degree, "s_deg"},
                                     {"deg/s", degree, "v_deg_s"},
                                     {"deg/s²", degree, "a_deg_s2"},
                                     {"deg/s³", degree, "j_deg_s3"}}};
constexpr UnitRows swing_by_angle = {{{"deg", degree, "s_deg"},
                                      {"deg/deg", 1.0, "ds_deg_deg"},
                                      {"deg/deg²", 1.0 / degree, "dds_deg_deg2"},
                                      {"deg/deg³", 1.0 / (degree * degree), "ddds_deg_deg3"}}};

const UnitRows& rows_of(const MotionSpec& motion, LengthUnit length, bool in_time) {
    if (motion.lift_is_angle) return in_time ? swing_in_time : swing_by_angle;
    if (length == LengthUnit::inch) return in_time ? inches_in_time : inches_by_angle;
    return in_time ? millimetres_in_time : millimetres_by_angle;
}

MotionUnit motion_unit(const MotionSpec& motion, LengthUnit length, std::size_t order, bool in_time) {
    const UnitRow& row = rows_of(motion, length, in_time)[order];
    const double rate = in_time ? *motion.speed / motion.unit_angle() : 1.0 / motion.unit_angle();
    MotionUnit unit;
    unit.name = row.name;
    unit.order = order;
    unit.size = row.size;
    unit.per_normalised = motion.lift / row.size * std::pow(rate, static_cast<int>(order));
    unit.symbol = (in_time ? symbols_in_time : symbols_by_angle)[order];
    unit.column = row.column;
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

ShownUnit weight_shown(LengthUnit length) {
    return length == LengthUnit::inch ? ShownUnit{"lb", units::pound} : ShownUnit{"kg", 1.0};
}

ShownUnits shown_units(const MotionSpec& motion, LengthUnit length) {
    ShownUnits shown;
    for (std::size_t order = 0; order < derivatives; ++order)
        shown.motion[order] = shown_derivative(motion, length, order);
    shown.in_time = motion.speed.has_value();
    const double one = metres_of(length);
    const std::string name = name_of(length);
    const bool swings = motion.lift_is_angle;
    shown.length = {name, one};
    shown.curvature = {"1/" + name, 1.0 / one};
    shown.angle = degrees_shown;
    if (length == LengthUnit::inch) {
        shown.force = {"lbf", units::pound_force};
        shown.torque = {"lbf in", units::pound_force * one};
        shown.pressure = shown.modulus = {"ksi", units::ksi};
        shown.spring_rate = swings ? ShownUnit{"lbf in/rad", shown.torque.size}
                                   : ShownUnit{"lbf/in", units::pound_force / one};
    } else {
        shown.force = {"N", 1.0};
        shown.torque = {"N m", 1.0};
        shown.pressure = {"MPa", units::megapascal};
        shown.modulus = {"GPa", 1e3 * units::megapascal};
        shown.spring_rate = swings ? ShownUnit{"N m/rad", 1.0} : ShownUnit{"N/mm", 1.0 / millimetre};
    }
    shown.vibration = swings                       ? ShownUnit{"mdeg", 1e-3 * degree}
                      : length == LengthUnit::inch ? ShownUnit{"mil", 1e-3 * one}
                                                   : ShownUnit{"µm", 1e-6};
    shown.mass = swings ? ShownUnit{"kg m²", 1.0} : weight_shown(length);
    shown.load = swings ? shown.torque : shown.force;
    shown.speed = rpm_shown;
    shown.degrees_per_x = motion.unit_angle() / degree;
    return shown;
}

ShownUnits shown_units(const Scene& scene) {
    return shown_units(scene.motion, scene.length_unit);
}

}  // namespace camopt

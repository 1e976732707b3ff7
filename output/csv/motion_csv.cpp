// SPDX-License-Identifier: MIT
#include "output/csv/motion_csv.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv/csv_line.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

void append_cell(std::string& line, double value) {
    line += ',';
    line += round_trip_text(value);
}

void append_values(std::string& line, const MotionPoint& point, const DerivativeScale& scale,
                   std::size_t first) {
    for (std::size_t r = first; r < scale.factor.size(); ++r)
        append_cell(line, scale.factor[r] * point.derivative[r]);
}

/// What people read and no column shows yet: "a_m_s2", "v_rad_s".
std::vector<MotionUnit> further_units(const DisplayScale& scale, const MotionSpec& spec) {
    std::vector<MotionUnit> units;
    if (!scale.by_time) return units;
    for (const ShownDerivative& shown : shown_units(spec).motion)
        if (std::ranges::find(scale.by_time->column, shown.first.column) == scale.by_time->column.end())
            units.push_back(shown.first);
    return units;
}

std::string header(const DisplayScale& scale, const MotionSpec& spec) {
    std::string line = "theta_deg";
    for (const std::string& column : scale.by_angle.column) line += "," + column;
    line += ",x,y,dy,ddy,dddy";
    if (scale.by_time) {
        line += ",t_s";
        for (std::size_t r = 1; r < 4; ++r) line += "," + scale.by_time->column[r];
        for (const MotionUnit& unit : further_units(scale, spec)) line += "," + unit.column;
    }
    return line + "\n";
}

using units::degree, units::millimetre;

std::string header(const ProfileColumns& columns) {
    return fmt::format(
        "theta_deg,{},pitch_x_mm,pitch_y_mm,cam_x_mm,cam_y_mm,normal_x,normal_y,pressure_angle_deg,"
        "pitch_radius_mm,cam_radius_mm,regularity{}{}{}\n",
        columns.swings ? "s_deg" : "s_mm", columns.face ? ",contact_offset_mm" : "",
        columns.loads.empty() ? ""
        : columns.swings      ? ",moment_nm,torque_nm,normal_force_n"
                              : ",force_n,torque_nm,normal_force_n",
        columns.pressure ? ",hertz_pressure_mpa" : "");
}

void add_load(CsvLine& line, const FollowerLoads& load, bool pressure) {
    line.number(load.force).number(load.torque).number(load.normal_force);
    if (pressure)
        line.number(load.hertz_pressure ? std::optional(*load.hertz_pressure / units::megapascal)
                                        : std::nullopt);
}

}  // namespace

std::string motion_csv(const Motion& motion, const Peaks& peaks, const MotionSpec& spec) {
    const DisplayScale scale = display_scale(spec);
    const std::vector<MotionUnit> further = further_units(scale, spec);
    std::string text = header(scale, spec);
    for (const MotionRow& row : motion_rows(motion, peaks)) {
        const MotionPoint point = motion.at(row.x, row.side);
        text += round_trip_text(scale.degrees_per_x * row.x);
        append_values(text, point, scale.by_angle, 0);
        append_cell(text, row.x);
        for (const double value : point.derivative) append_cell(text, value);
        if (scale.by_time) {
            append_cell(text, scale.seconds_per_x * row.x);
            append_values(text, point, *scale.by_time, 1);
            for (const MotionUnit& unit : further)
                append_cell(text, unit.per_normalised * point.derivative[unit.order]);
        }
        text += "\n";
    }
    return text;
}

std::string profile_csv(const MechanismProfile& profile, const ProfileColumns& columns) {
    if (profile.points.size() != profile.outputs.size())
        throw InputError(fmt::format("profile.csv: {} points and {} displacements", profile.points.size(),
                                     profile.outputs.size()));
    if (!columns.loads.empty() && columns.loads.size() != profile.points.size())
        throw InputError(
            fmt::format("profile.csv: {} points and {} loads", profile.points.size(), columns.loads.size()));
    std::string text = header(columns);
    const double unit = columns.swings ? degree : millimetre;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const MechanismPoint& point = profile.points[i];
        CsvLine line;
        line.number(point.theta / degree).number(profile.outputs[i] / unit);
        for (const Eigen::Vector3d& place : {point.pitch, point.contact})
            line.number(place.x() / millimetre).number(place.y() / millimetre);
        line.number(point.normal.x()).number(point.normal.y()).number(point.pressure_angle / degree);
        line.number(1.0 / (point.pitch_curvature * millimetre)).number(point.cam_radius / millimetre);
        line.number(point.regularity);
        if (columns.face) line.number(point.contact_offset / millimetre);
        if (!columns.loads.empty()) add_load(line, columns.loads[i], columns.pressure);
        text += line.finish();
    }
    return text;
}

}  // namespace camopt

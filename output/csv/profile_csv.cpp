// SPDX-License-Identifier: MIT
#include "output/csv/profile_csv.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv/csv_line.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

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

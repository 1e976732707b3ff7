// SPDX-License-Identifier: MIT
#include "output/csv/profile_csv.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv/csv_line.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using units::degree, units::millimetre;

std::string header(const Follower& follower) {
    return fmt::format(
        "theta_deg,{},pitch_x_mm,pitch_y_mm,cam_x_mm,cam_y_mm,normal_x,normal_y,pressure_angle_deg,"
        "pitch_radius_mm,cam_radius_mm,regularity{}\n",
        follower.oscillates ? "s_deg" : "s_mm",
        follower.contact == ContactKind::flat ? ",contact_offset_mm" : "");
}

}  // namespace

std::string profile_csv(std::span<const ProfilePoint> points, std::span<const double> displacements,
                        const Follower& follower) {
    if (points.size() != displacements.size())
        throw InputError(
            fmt::format("profile.csv: {} points and {} displacements", points.size(), displacements.size()));
    std::string text = header(follower);
    const double unit = follower.oscillates ? degree : millimetre;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ProfilePoint& point = points[i];
        CsvLine line;
        line.number(point.theta / degree).number(displacements[i] / unit);
        for (const Eigen::Vector2d& place : {point.pitch, point.contact})
            line.number(place.x() / millimetre).number(place.y() / millimetre);
        line.number(point.normal.x()).number(point.normal.y()).number(point.pressure_angle / degree);
        line.number(1.0 / (point.pitch_curvature * millimetre)).number(point.cam_radius / millimetre);
        line.number(point.regularity);
        if (follower.contact == ContactKind::flat) line.number(point.contact_offset / millimetre);
        text += line.finish();
    }
    return text;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "input/set_point_reader.hpp"

#include "core/units.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

// Of a turn: the rounding of angles written with ten digits.
constexpr double turn_rounding = 1e-9;

/// The set points of one stretch.
class SetPointReader {
 public:
    SetPointReader(const SceneSource& source, const MotionSpec& motion, double angle, std::string table)
        : source_(source), motion_(motion), angle_(angle), table_(std::move(table)) {}

    /// `path`: as the user wrote it, "motion.segments[1].via[0]".
    [[nodiscard]] SetPoint read(const Node& node, const std::string& path) const {
        const auto find = [&](std::string_view name) { return SceneSource::find_in(node, table_, name); };
        const auto key = [&](const Given& given) { return joined_key(path, given.member->name); };
        SetPoint point;
        const auto at = find("at"), from = find("from"), to = find("to");
        if (from || to) {
            if (!from || !to)
                source_.fail(node.place, joined_key(path, from ? "to" : "from"),
                             "missing; allowed: both ends of a region, from and to");
            point.at = place(*from, point);
            point.until = place(*to, point);
        } else if (at) {
            point.at = place(*at, point);
        } else {
            source_.fail(node.place, joined_key(path, "at"),
                         "missing; allowed: at (at_deg, at_rad) of a point, or from and to of a region");
        }
        if (const auto given = find("displacement")) {
            point.units.displacement = given->spelling->unit;
            point.displacement = displacement_in_lifts(source_, *given, key(*given), motion_);
        }
        if (const auto given = find("velocity")) {
            point.units.velocity = given->spelling->unit;
            point.velocity = derivative(*given, key(*given), 1);
        }
        if (const auto given = find("acceleration")) {
            point.units.acceleration = given->spelling->unit;
            point.acceleration = derivative(*given, key(*given), 2);
        }
        return point;
    }

 private:
    const SceneSource& source_;
    const MotionSpec& motion_;
    double angle_;  ///< rad, of the unit of places
    std::string table_;

    [[nodiscard]] double place(const Given& given, SetPoint& point) const {
        if (given.spelling->unit.empty()) return given.number();
        point.units.place = given.spelling->unit;
        return given.number() / angle_;
    }

    [[nodiscard]] double derivative(const Given& given, const std::string& key, int order) const {
        const std::string_view unit = given.spelling->unit;
        if (unit.empty()) return given.number();
        if (is_angle_unit(unit) != motion_.lift_is_angle)
            source_.fail(
                given.member->place, key,
                fmt::format("found a value in {} where the lift is {}; allowed: a unit with {}, or a "
                            "normalised value",
                            unit, motion_.lift_is_angle ? "an angle" : "a length",
                            motion_.lift_is_angle ? "deg or rad" : "mm, in or m"));
        const bool in_time = is_unit_of_time(unit);
        if (in_time && !motion_.speed)
            source_.fail(given.member->place, key,
                         fmt::format("found a value in {} without a speed; allowed: together with "
                                     "motion.speed_rpm or motion.speed_rad_s, or by the cam angle ({})",
                                     unit, motion_.lift_is_angle ? "velocity_rad_rad" : "velocity_mm_rad"));
        return given.number() / set_point_unit({angle_, motion_.lift, motion_.speed}, order, in_time);
    }
};

}  // namespace

double displacement_in_lifts(const SceneSource& source, const Given& given, const std::string& key,
                             const MotionSpec& motion) {
    const std::string_view unit = given.spelling->unit;
    if (unit.empty()) return given.number();
    if (is_angle_unit(unit) != motion.lift_is_angle) {
        const std::string_view name = given.row->name;
        source.fail(
            given.member->place, key,
            motion.lift_is_angle
                ? fmt::format("found {0} where the lift is an angle; allowed: {1}, {1}_deg or {1}_rad",
                              given.member->name, name)
                : fmt::format("found {0} where the lift is a length; allowed: {1}, {1}_mm, {1}_in or "
                              "{1}_m",
                              given.member->name, name));
    }
    return given.number() / motion.lift;
}

void read_set_points(const SceneSource& source, MotionSpec& motion) {
    if (const auto via = source.find("motion", "via")) {
        const SetPointReader reader(source, motion, motion.unit_angle(), "motion.via");
        for (const Node& point : via->value().items)
            motion.via.push_back(reader.read(point, fmt::format("motion.via[{}]", motion.via.size())));
    }
    const auto segments = source.find("motion", "segments");
    if (!segments) return;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const auto via = SceneSource::find_in(segments->value().items[i], "motion.segments", "via");
        if (!via) continue;
        std::vector<SetPoint>& points = motion.segments[i].via;
        const SetPointReader reader(source, motion, motion.segments[i].angle, "motion.segments.via");
        for (const Node& point : via->value().items)
            points.push_back(
                reader.read(point, fmt::format("motion.segments[{}].via[{}]", i, points.size())));
    }
}

void settle_angle_ranges(const SceneSource& source, MotionSpec& motion) {
    double least = 0.0, most = 0.0;
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const bool searched = segment.angle_range.has_value();
        if (searched && !first) first = i;
        least += searched ? segment.angle_range->least : segment.angle;
        most += searched ? segment.angle_range->most : segment.angle;
    }
    if (!first || !motion.closed) return;
    const double slack = turn_rounding * units::turn;
    if (least > units::turn + slack || most < units::turn - slack)
        source.fail_member(fmt::format("motion.segments[{}].angle", *first),
                           fmt::format("found ranges that let the angles add up to {:.10g} to {:.10g} deg; "
                                       "allowed: ranges with 360 deg between",
                                       least / units::degree, most / units::degree));
    const double part = std::clamp((units::turn - least) / (most - least), 0.0, 1.0);
    for (ProgramSegment& segment : motion.segments)
        if (segment.angle_range)
            segment.angle =
                segment.angle_range->least + part * (segment.angle_range->most - segment.angle_range->least);
}

}  // namespace camopt::input

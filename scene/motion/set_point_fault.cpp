// SPDX-License-Identifier: MIT
// Set points and regions of all lists: locations inside their stretch, one per location, consistent values.
#include "scene/faults/scene_faults.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

/// The context for validating the set points of one list.
struct PointStretch {
    std::string member;   ///< of the list
    double length = 1.0;  ///< largest location
    double angle = 1.0;   ///< rad, of the unit of locations
    /// Why no region may begin at 0, or end at `length`; empty: allowed.
    std::string at_begin = {}, at_end = {};
    bool segment = false;  ///< of a program
};

std::string place_text(const PointStretch& stretch, const SetPoint& point, double at) {
    if (point.units.place.empty()) return fmt::format("{}", at);
    return fmt::format("{:.10g} {}", at * stretch.angle / spelling_of_place(point.units.place).factor,
                       point.units.place);
}

std::string inside_text(const PointStretch& stretch, const SetPoint& point) {
    if (!stretch.segment && point.units.place.empty())
        return Range::between(0.0, stretch.length).number_text();
    const std::string end = place_text(stretch, point, stretch.length);
    return stretch.segment ? fmt::format("a location after 0 and before {}, the end of the segment", end)
                           : fmt::format("a location from 0 to {}", end);
}

bool is_inside(const PointStretch& stretch, double at) {
    if (stretch.segment) return at > same_place && at < stretch.length - same_place;
    return Range::between(0.0, stretch.length).contains(at);
}

Fault numbers_fault(const SetPoint& point, const std::string& member) {
    for (const auto& [name, value] :
         {std::pair{"displacement", point.displacement}, std::pair{"velocity", point.velocity},
          std::pair{"acceleration", point.acceleration}})
        if (value && !std::isfinite(*value))
            return SceneFault{fmt::format("{}.{}", member, name), fmt::format("{}", *value),
                              Range{}.number_text()};
    return std::nullopt;
}

Fault region_fault(const PointStretch& stretch, const SetPoint& point, const std::string& member) {
    const bool begins = stretch.at_begin.empty() ? point.at >= -same_place : point.at > same_place;
    const double left = stretch.length - *point.until;
    const bool ends = stretch.at_end.empty() ? left >= -same_place : left > same_place;
    if (!begins || !std::isfinite(point.at))
        return SceneFault{
            member + ".from", place_text(stretch, point, point.at),
            stretch.at_begin.empty()
                ? "a location at or after the beginning"
                : fmt::format("a location after {}, {}", place_text(stretch, point, 0.0), stretch.at_begin)};
    if (!ends || !std::isfinite(*point.until))
        return SceneFault{member + ".to", place_text(stretch, point, *point.until),
                          fmt::format("{} {}{}", stretch.at_end.empty() ? "at most" : "before",
                                      place_text(stretch, point, stretch.length),
                                      stretch.at_end.empty() ? "" : ", " + stretch.at_end)};
    if (!(*point.until > point.at + same_place))
        return SceneFault{member + ".to", place_text(stretch, point, *point.until),
                          fmt::format("a location after {}, where the region begins",
                                      place_text(stretch, point, point.at))};
    if (!point.velocity)
        return SceneFault{member, "a region without a velocity",
                          "the velocity that holds from its beginning to its end"};
    if (point.acceleration)
        return SceneFault{member + ".acceleration", "an acceleration in a region of constant velocity",
                          "none: it is 0 there"};
    return numbers_fault(point, member);
}

Fault point_fault(const PointStretch& stretch, const SetPoint& point, const std::string& member) {
    if (!is_inside(stretch, point.at))
        return SceneFault{member + ".at", place_text(stretch, point, point.at), inside_text(stretch, point)};
    if (!point.displacement && !point.velocity && !point.acceleration)
        return SceneFault{member, "no value", "at least one of displacement, velocity, acceleration"};
    return numbers_fault(point, member);
}

Fault pair_fault(const PointStretch& stretch, const std::vector<SetPoint>& points, std::size_t i,
                 std::size_t j) {
    const SetPoint &one = points[i], &other = points[j];
    const std::string member = entry_key(stretch.member, i);
    if (one.is_region() && other.is_region() && one.at < *other.until - same_place &&
        other.at < *one.until - same_place)
        return SceneFault{member + ".from",
                          fmt::format("{} to {}, which overlaps {}", place_text(stretch, one, one.at),
                                      place_text(stretch, one, *one.until), entry_key(stretch.member, j)),
                          "regions that do not overlap"};
    const bool points_both = !one.is_region() && !other.is_region();
    if (points_both && std::abs(one.at - other.at) <= same_place)
        return SceneFault{member + ".at",
                          fmt::format("{}, the location of {}", place_text(stretch, one, one.at),
                                      entry_key(stretch.member, j)),
                          "one point at each location"};
    return std::nullopt;
}

Fault list_fault(const PointStretch& stretch, const std::vector<SetPoint>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string member = entry_key(stretch.member, i);
        if (Fault fault = points[i].is_region() ? region_fault(stretch, points[i], member)
                                                : point_fault(stretch, points[i], member))
            return fault;
        for (std::size_t j = 0; j < i; ++j)
            if (Fault fault = pair_fault(stretch, points, i, j)) return fault;
    }
    return std::nullopt;
}

/// Why no region of constant velocity may touch an end of a segment; empty: its neighbour is a spline, which
/// joins with that velocity.
std::string end_words(const MotionSpec& motion, std::size_t segment, bool after) {
    const std::size_t count = motion.segments.size();
    const bool outer = segment == (after ? count - 1 : 0);
    if (outer && !motion.periodic()) return "";  // the motion ends, or starts, with this velocity
    const std::size_t other = (segment + (after ? 1 : count - 1)) % count;
    const SegmentKind kind = motion.segments[other].kind;
    if (kind != SegmentKind::spline)
        return fmt::format("where {}, a {}, gives the velocity", segment_key(other), name_of(kind));
    return outer ? "where the turn closes" : "";
}

}  // namespace

Fault set_point_fault(const MotionSpec& motion) {
    if (motion.type != MotionType::program)
        return list_fault({"motion.via", motion.length(), motion.unit_angle()}, motion.via);
    const auto is_spline = [&](std::size_t i) { return motion.segments[i].kind == SegmentKind::spline; };
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        const std::string member = segment_key(i, "via");
        if (segment.via.empty()) continue;
        if (!is_spline(i))
            return SceneFault{member,
                              fmt::format("set points in a segment of kind \"{}\"", name_of(segment.kind)),
                              "only in kind \"spline\""};
        const PointStretch stretch{
            member, 1.0, segment.angle, end_words(motion, i, false), end_words(motion, i, true), true};
        if (Fault fault = list_fault(stretch, segment.via)) return fault;
    }
    return std::nullopt;
}

}  // namespace camopt

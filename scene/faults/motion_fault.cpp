// SPDX-License-Identifier: MIT
// The segments of a program: each separately, then their angles and their final displacement.
#include "core/units.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/key_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace {

// Of a revolution. Angles written with ten digits add up closer than this; a forgotten units::degree is far
// above.
constexpr double turn_tolerance = 1e-9;
// rad: the same rounding at the ends of a range.
constexpr double range_slack = 1e-9;

Fault segment_fault(const ProgramSegment& segment, const std::string& member) {
    const Range angles = Range::above_up_to(0.0, units::turn);
    if (!angles.contains(segment.angle))
        return SceneFault{member + ".angle", fmt::format("{}", segment.angle), angles.number_text()};
    if (segment.angle_range) {
        const AngleRange& range = *segment.angle_range;
        if (!angles.contains(range.least) || !angles.contains(range.most) || !(range.least < range.most))
            return SceneFault{member + ".angle",
                              fmt::format("a range from {:.10g} to {:.10g} deg", range.least / units::degree,
                                          range.most / units::degree),
                              "min below max, both > 0 and <= 360 deg"};
        if (!(segment.angle >= range.least - range_slack && segment.angle <= range.most + range_slack))
            return SceneFault{member + ".angle", fmt::format("{} rad outside of its range", segment.angle),
                              fmt::format("from {} to {} rad", range.least, range.most)};
    }
    if (segment.kind == SegmentKind::law && segment.law.empty())
        return SceneFault{member + ".law", "no law in a segment of kind \"law\"", "a law of the catalogue"};
    if (segment.kind != SegmentKind::law && !segment.law.empty())
        return SceneFault{
            member + ".law",
            fmt::format("\"{}\" in a segment of kind \"{}\"", segment.law, name_of(segment.kind)),
            "a law only in kind \"law\""};
    if (!segment.to) return std::nullopt;
    if (segment.kind == SegmentKind::dwell)
        return SceneFault{member + ".to", "a displacement in a segment of kind \"dwell\"",
                          "only in kind \"law\" or \"spline\"; a dwell keeps its displacement"};
    if (!std::isfinite(*segment.to))
        return SceneFault{member + ".to", fmt::format("{}", *segment.to), Range{}.number_text()};
    return std::nullopt;
}

Fault turn_fault(const MotionSpec& motion) {
    double total = 0.0;
    for (const ProgramSegment& segment : motion.segments) total += segment.angle;
    const double excess = total / units::turn - 1.0;
    const bool allowed = motion.closed ? std::abs(excess) <= turn_tolerance : excess <= turn_tolerance;
    if (allowed) return std::nullopt;
    return SceneFault{"motion.segments",
                      fmt::format("angles that add up to {:.12g} deg", total / units::degree),
                      motion.closed ? "360 deg, or motion.closed = false for part of a revolution"
                                    : "at most 360 deg, one revolution"};
}

/// Only angles with a fixed sum are distributed by a search.
Fault angle_range_fault(const MotionSpec& motion) {
    const auto searched = [](const ProgramSegment& segment) { return segment.angle_range.has_value(); };
    const auto first = std::ranges::find_if(motion.segments, searched);
    if (first == motion.segments.end()) return std::nullopt;
    const std::string member = fmt::format("motion.segments[{}].angle", first - motion.segments.begin());
    if (!motion.closed)
        return SceneFault{member, "a range in a program that is not closed",
                          "a number, or a closed program, whose angles add up to 360 deg"};
    if (std::ranges::count_if(motion.segments, searched) < 2)
        return SceneFault{member, "the only range of the program",
                          "a number: the angles add up to 360 deg, so at least two ranges are needed"};
    return std::nullopt;
}

/// A closed program ends where it began: at 0.
Fault end_fault(const MotionSpec& motion) {
    if (!motion.closed) return std::nullopt;
    const auto last = std::find_if(motion.segments.rbegin(), motion.segments.rend(),
                                   [](const auto& segment) { return segment.kind != SegmentKind::dwell; });
    if (last == motion.segments.rend() || last->to.value_or(0.0) == 0.0) return std::nullopt;
    const auto index = std::distance(last, motion.segments.rend()) - 1;
    return SceneFault{fmt::format("motion.segments[{}].to", index),
                      fmt::format("a closed program that ends at {} lifts", *last->to),
                      "0, where it began, or no `to`, or motion.closed = false"};
}

/// A program whose every displacement is free or 0 is solved by a dwell: it prescribes nothing.
Fault idle_fault(const MotionSpec& motion) {
    const auto moves = [](const ProgramSegment& segment) {
        return segment.to.value_or(0.0) != 0.0 || std::ranges::any_of(segment.via, [](const SetPoint& point) {
                   return point.displacement.value_or(0.0) != 0.0 || point.velocity.value_or(0.0) != 0.0 ||
                          point.acceleration.value_or(0.0) != 0.0;
               });
    };
    if (std::ranges::any_of(motion.segments, moves)) return std::nullopt;
    const auto first = std::ranges::find_if(
        motion.segments, [](const auto& segment) { return segment.kind != SegmentKind::dwell; });
    const auto others = std::count_if(first + 1, motion.segments.end(),
                                      [](const auto& segment) { return segment.kind != SegmentKind::dwell; });
    const bool alone = motion.closed && others == 0;  // each rise has its return
    return SceneFault{fmt::format("motion.segments[{}].to", std::distance(motion.segments.begin(), first)),
                      "a program in which nothing has to move: every displacement is 0 or free",
                      alone ? "two segments that move, the first with `to`, or motion.closed = false"
                            : "a displacement other than 0 for at least one segment (lifts: `to = 1`)"};
}

}  // namespace

Fault program_fault(const MotionSpec& motion) {
    if (motion.segments.empty())
        return SceneFault{"motion.segments", "no segment",
                          "the segments of the program, at least one of kind \"spline\""};
    for (std::size_t i = 0; i < motion.segments.size(); ++i)
        if (Fault fault = segment_fault(motion.segments[i], fmt::format("motion.segments[{}]", i)))
            return fault;
    if (std::ranges::none_of(motion.segments,
                             [](const auto& segment) { return segment.kind == SegmentKind::spline; }))
        return SceneFault{"motion.segments", "no segment to optimise",
                          "at least one with kind = \"spline\", its angle and, where needed, the "
                          "displacement `to` at its end"};
    if (Fault fault = angle_range_fault(motion)) return fault;
    if (Fault fault = turn_fault(motion)) return fault;
    if (Fault fault = end_fault(motion)) return fault;
    return idle_fault(motion);
}

// Relations between the members of a motion.

namespace {

/// Members without a meaning in a motion of this type.
Fault type_fault(const MotionSpec& motion) {
    const auto wrong = [&](const char* member, std::string_view what, const char* allowed) {
        return SceneFault{member, fmt::format("{} in a motion of type \"{}\"", what, name_of(motion.type)),
                          allowed};
    };
    const bool program = motion.type == MotionType::program;
    if (motion.type != MotionType::rr && motion.return_angle)
        return wrong("motion.return_angle", "a return", "only in type \"RR\"");
    if (program && motion.symmetric)
        return wrong("motion.symmetric", "true", "false, or type \"DRD\" or \"RR\"");
    if (program && !motion.via.empty())
        return wrong("motion.via", "exact points",
                     "only in type \"DRD\" or \"RR\"; a program has them in its segments");
    if (!program && !motion.segments.empty())
        return wrong("motion.segments", "segments", "only in type \"program\"");
    if (!program && !motion.closed) return wrong("motion.closed", "false", "only in type \"program\"");
    return std::nullopt;
}

Fault return_fault(const MotionSpec& motion) {
    if (motion.type != MotionType::rr) return std::nullopt;
    const double total = motion.rise + motion.return_angle.value_or(motion.rise);
    if (!Range::above_up_to(0.0, units::turn).contains(total))
        return SceneFault{"motion.return_angle", fmt::format("{} rad for rise and return together", total),
                          fmt::format("at most one revolution, {} rad", units::turn)};
    if (motion.symmetric && std::abs(motion.length() - 2.0) > same_place)
        return SceneFault{"motion.symmetric", "true with a return different from the rise",
                          "false, or equal angles for rise and return"};
    return std::nullopt;
}

}  // namespace

Fault motion_fault(const MotionSpec& motion) {
    if (Fault fault = type_fault(motion)) return fault;
    if (Fault fault = motion.type == MotionType::program ? program_fault(motion) : return_fault(motion))
        return fault;
    return set_point_fault(motion);
}

}  // namespace camopt

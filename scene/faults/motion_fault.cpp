// SPDX-License-Identifier: MIT
// The segments of a program: each separately, then their angles and their final displacement.
#include "scene/faults/scene_faults.hpp"
#include "scene/key_row.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Of a revolution. Angles written with ten digits add up closer than this; a forgotten units::degree is far
// above.
constexpr double turn_tolerance = 1e-9;
// rad: the same rounding at the ends of a range.
constexpr double range_slack = 1e-9;

Fault segment_fault(const ProgramSegment& segment, const std::string& member) {
    const Range angles = Range::above_up_to(0.0, units::turn);
    if (segment.angle == 0.0 && segment.kind == SegmentKind::dwell)
        return SceneFault{member + ".angle", "a dwell of 0",
                          "an angle > 0; for a turning point without a dwell leave this segment out and give "
                          "the segment before it end = { velocity = 0 }"};
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
    const bool allowed = motion.periodic() ? std::abs(excess) <= turn_tolerance : excess <= turn_tolerance;
    if (allowed) return std::nullopt;
    return SceneFault{
        "motion.segments", fmt::format("angles that add up to {:.12g} deg", total / units::degree),
        !motion.periodic()   ? "at most 360 deg, one revolution"
        : motion.repeat == 1 ? "360 deg, or motion.closed = false for part of a revolution"
                             : fmt::format("360 deg: those of one of the {} copies add up to {:.10g} deg",
                                           motion.repeat, 360.0 / motion.repeat)};
}

/// Only angles with a fixed sum are distributed by a search.
Fault angle_range_fault(const MotionSpec& motion) {
    const auto searched = [](const ProgramSegment& segment) { return segment.angle_range.has_value(); };
    const auto first = std::ranges::find_if(motion.segments, searched);
    if (first == motion.segments.end()) return std::nullopt;
    const std::string member = segment_key(first - motion.segments.begin(), "angle");
    if (motion.repeat > 1)
        return SceneFault{member, "a range in a program that is repeated", "a number, or motion.repeat = 1"};
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
    return SceneFault{segment_key(index, "to"),
                      fmt::format("a closed program that ends at {} lifts", *last->to),
                      "0, where it began, or no `to`, or motion.closed = false"};
}

/// Without a spline every law says where it ends.
Fault prescribed_fault(const MotionSpec& motion) {
    if (!motion.prescribed()) return std::nullopt;
    bool moves = false;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        moves = moves || segment.kind == SegmentKind::law;
        if (segment.kind == SegmentKind::law && !segment.to)
            return SceneFault{segment_key(i, "to"), "no displacement, in a program of laws and dwells only",
                              "the displacement at its end: nothing is optimised that could choose it"};
    }
    if (moves) return std::nullopt;
    return SceneFault{"motion.segments", "dwells only",
                      "at least one segment with kind = \"law\" or kind = \"spline\""};
}

/// What joins with a state that the scene may give.
bool joins_with_states(const ProgramSegment& segment) {
    return segment.kind == SegmentKind::spline || segment.takes_states();
}

/// `end` of a segment: at a joint of splines and polynomials.
Fault joint_fault(const MotionSpec& motion) {
    const std::size_t count = motion.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        const ProgramSegment& segment = motion.segments[i];
        if (!segment.end) continue;
        const std::string member = segment_key(i, "end");
        const bool last = i + 1 == count && !motion.periodic();
        const ProgramSegment& next = motion.segments[(i + 1) % count];
        if (last)
            return SceneFault{member, "a state at the end of a program that is not closed", "motion.end"};
        if (!joins_with_states(segment) || !joins_with_states(next))
            return SceneFault{
                member,
                fmt::format("a state between segments of kind \"{}\" and \"{}\"", name_of(segment.kind),
                            name_of(next.kind)),
                "only between segments of kind \"spline\" or of the law \"polynomial\": dwells and other "
                "laws give the state where they join"};
        if (!segment.end->velocity && !segment.end->acceleration)
            return SceneFault{member, "no value", "velocity, acceleration or both"};
    }
    return std::nullopt;
}

}  // namespace

Fault program_fault(const MotionSpec& motion) {
    if (motion.segments.empty())
        return SceneFault{"motion.segments", "no segment", "the segments of the program"};
    if (motion.repeat < 1 || motion.segments.size() % static_cast<std::size_t>(motion.repeat) != 0)
        return SceneFault{"motion.repeat", fmt::to_string(motion.repeat),
                          "an integer >= 1 that divides the number of segments"};
    if (motion.repeat > 1 && !motion.closed)
        return SceneFault{"motion.repeat", fmt::format("{} in a program that is not closed", motion.repeat),
                          "1, or motion.closed = true"};
    for (std::size_t i = 0; i < motion.segments.size(); ++i)
        if (Fault fault = segment_fault(motion.segments[i], segment_key(i))) return fault;
    if (Fault fault = prescribed_fault(motion)) return fault;
    if (Fault fault = joint_fault(motion)) return fault;
    if (Fault fault = angle_range_fault(motion)) return fault;
    if (Fault fault = turn_fault(motion)) return fault;
    return end_fault(motion);
}

Fault idle_fault(const MotionSpec& motion) {
    if (motion.type != MotionType::program) return std::nullopt;
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
    return SceneFault{segment_key(std::distance(motion.segments.begin(), first), "to"),
                      "a program in which nothing has to move: every displacement is 0 or free",
                      alone ? "two segments that move, the first with `to`, or motion.closed = false"
                            : "a displacement other than 0 for at least one segment (lifts: `to = 1`)"};
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
    if (!program && (!motion.closed || motion.relative))
        return wrong("motion.closed", "false", "only in type \"program\"");
    if (!program && motion.repeat != 1) return wrong("motion.repeat", "a number", "only in type \"program\"");
    if (motion.closed && motion.relative)
        return SceneFault{"motion.relative", "true in a closed program", "motion.closed = false with it"};
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

/// motion.start and motion.end.
Fault end_state_fault(const MotionSpec& motion) {
    const bool program = motion.type == MotionType::program;
    for (const bool at_end : {false, true}) {
        const std::optional<SetPoint>& state = at_end ? motion.end : motion.start;
        if (!state) continue;
        const std::string member = at_end ? "motion.end" : "motion.start";
        if (motion.periodic())
            return SceneFault{member, "a state in a program that goes on where it ends",
                              "motion.closed = false, or set points in its segments"};
        if (motion.symmetric)
            return SceneFault{member, "a state of a symmetric motion", "motion.symmetric = false"};
        if (program) {
            const ProgramSegment& own = at_end ? motion.segments.back() : motion.segments.front();
            if (!joins_with_states(own))
                return SceneFault{
                    member, fmt::format("a state at a {}", name_of(own.kind)),
                    "only where the first, or the last, segment is a spline or the law \"polynomial\""};
        }
        if (!state->velocity && !state->acceleration)
            return SceneFault{member, "no value", "velocity, acceleration or both"};
        for (const std::optional<double>& value : {state->velocity, state->acceleration})
            if (value && !std::isfinite(*value))
                return SceneFault{member, fmt::format("{}", *value), Range{}.number_text()};
    }
    return std::nullopt;
}

Fault corridor_fault(const MotionSpec& motion) {
    const double whole = motion.length() * motion.unit_angle();
    for (std::size_t i = 0; i < motion.corridors.size(); ++i) {
        const Corridor& corridor = motion.corridors[i];
        const std::string member = entry_key("motion.corridor", i);
        if (!(corridor.to > corridor.from) || !(corridor.from >= 0.0) ||
            !(corridor.to <= whole * (1.0 + turn_tolerance)))
            return SceneFault{
                member,
                fmt::format("a stretch from {:.10g} to {:.10g} deg", corridor.from / units::degree,
                            corridor.to / units::degree),
                fmt::format("from below to, both from 0 to {:.10g} deg", whole / units::degree)};
        bool bounded = false;
        for (const Corridor::Bounds& bounds : corridor.bounds) {
            for (const std::optional<double>& side : {bounds.least, bounds.most}) {
                if (side && !std::isfinite(*side))
                    return SceneFault{(bounds.key.empty() ? member : joined_key(member, bounds.key)),
                                      fmt::format("{}", *side), Range{}.number_text()};
                bounded = bounded || side;
            }
            if (bounds.least && bounds.most && !(*bounds.least < *bounds.most))
                return SceneFault{(bounds.key.empty() ? member : joined_key(member, bounds.key)),
                                  "min not below max", "min below max"};
        }
        if (!bounded)
            return SceneFault{member, "no bound",
                              "min or max of displacement, velocity, acceleration or jerk"};
    }
    return std::nullopt;
}

}  // namespace

Fault motion_fault(const MotionSpec& motion) {
    if (Fault fault = type_fault(motion)) return fault;
    if (Fault fault = motion.type == MotionType::program ? program_fault(motion) : return_fault(motion))
        return fault;
    if (Fault fault = end_state_fault(motion)) return fault;
    if (Fault fault = corridor_fault(motion)) return fault;
    return set_point_fault(motion);
}

}  // namespace camopt

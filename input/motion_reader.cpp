// SPDX-License-Identifier: MIT
#include "input/motion_reader.hpp"

#include "core/numbers/range.hpp"
#include "core/units.hpp"
#include "input/keys/key_check.hpp"
#include "input/set_point_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

class MotionReader {
 public:
    MotionReader(const SceneSource& source, const KnownNames& known) : source_(source), known_(known) {}

    MotionSpec read() const {
        MotionSpec motion;
        source_.read_choice("motion", "type", {MotionType::drd, MotionType::rr, MotionType::program},
                            motion.type);
        refuse_keys_of_other_types(motion.type);
        if (const auto lift = source_.find("motion", "lift")) {
            motion.lift = lift->number();
            motion.lift_is_angle = is_angle_unit(lift->spelling->unit);
        }
        source_.read_number("motion", "rise", motion.rise);
        motion.return_angle = source_.number("motion", "return");
        motion.speed = source_.number("motion", "speed");
        if (const auto symmetric = source_.find("motion", "symmetric"))
            motion.symmetric = symmetric->value().boolean;
        if (const auto within = source_.find("motion", "within_lift"))
            motion.within_lift = within->value().boolean;
        if (const auto monotone = source_.find("motion", "monotone"))
            motion.monotone = monotone->value().boolean;
        if (const auto closed = source_.find("motion", "closed")) motion.closed = closed->value().boolean;
        if (const auto segments = source_.find("motion", "segments"))
            for (const Node& segment : segments->value().items)
                motion.segments.push_back(read_segment(segment, motion));
        settle_angle_ranges(source_, motion);
        check_moving_laws(motion);
        check_turn(motion);
        read_set_points(source_, motion);
        return motion;
    }

 private:
    const SceneSource& source_;
    const KnownNames& known_;

    void refuse_keys_of_other_types(MotionType type) const {
        const bool program = type == MotionType::program;
        const auto refuse = [&](std::initializer_list<const char*> names, const char* allowed) {
            for (const char* name : names)
                if (const auto given = source_.find("motion", name))
                    source_.fail(given->member->place, joined_key("motion", given->member->name),
                                 fmt::format("found this key in a motion of type \"{}\"; allowed: only in {}",
                                             name_of(type), allowed));
        };
        if (!program) return refuse({"segments", "closed"}, "type \"program\"");
        refuse({"rise", "return"},
               "type \"DRD\" or \"RR\"; a program says the angle of each of its segments");
        refuse({"symmetric"}, "type \"DRD\" or \"RR\"");
        refuse({"via"}, "type \"DRD\" or \"RR\"; a program has set points in its segments, via in each");
    }

    ProgramSegment read_segment(const Node& table, const MotionSpec& motion) const {
        const auto find = [&](std::string_view name) {
            return SceneSource::find_in(table, "motion.segments", name);
        };
        const auto key = [&](const Given& given) {
            return fmt::format("motion.segments[{}].{}", motion.segments.size(), given.member->name);
        };
        ProgramSegment segment;
        for (const SegmentKind kind : {SegmentKind::dwell, SegmentKind::law, SegmentKind::spline})
            if (const auto given = find("kind"); given && given->value().text == name_of(kind))
                segment.kind = kind;
        if (const auto angle = find("angle")) {
            const Dimension written = angle->dimension();
            segment.angle = written.low;
            if (written.is_variable()) segment.angle_range = AngleRange{written.low, written.high};
        }
        if (const auto law = find("law")) {
            check_name(source_, *law, key(*law), {known_.laws, "a law of the catalogue: ", ""});
            segment.law = law->value().text;
        }
        if (const auto to = find("to")) {
            segment.to = displacement_in_lifts(source_, *to, key(*to), motion);
            segment.to_unit = to->spelling->unit;
        }
        return segment;
    }

    /// objectives/ checks this too, without the place.
    void check_moving_laws(const MotionSpec& motion) const {
        const std::size_t count = motion.segments.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string& law = motion.segments[i].law;
            if (std::ranges::find(known_.moving_laws, law) == known_.moving_laws.end()) continue;
            const auto joins = [&](bool open, std::size_t other) {
                return !open && motion.segments[other].kind == SegmentKind::spline;
            };
            const bool first = i == 0 && !motion.closed, last = i + 1 == count && !motion.closed;
            if (joins(first, (i + count - 1) % count) && joins(last, (i + 1) % count)) continue;
            source_.fail_member(
                fmt::format("motion.segments[{}].law", i),
                fmt::format("found \"{}\", a law whose ends move; allowed: between two segments "
                            "of kind \"spline\", which join with its velocity",
                            law));
        }
    }

    /// core/ checks this too, but in radians.
    void check_turn(const MotionSpec& motion) const {
        if (motion.type != MotionType::rr) return;
        auto given = source_.find("motion", "return");
        if (!given) given = source_.find("motion", "rise");
        if (!given) return;
        const double factor = given->spelling->factor;
        const double total = (motion.rise + motion.return_angle.value_or(motion.rise)) / factor;
        const Range allowed = Range::above_up_to(0.0, 360.0).scaled(units::degree / factor);
        if (!allowed.contains(total))
            source_.fail(
                given->value().place, joined_key("motion", given->member->name),
                fmt::format("found {0}, together {1:.10g} {2} of rise and return; allowed: a whole turn, "
                            "{3:.10g} {2}, at most",
                            given->value().shown(), total, given->spelling->unit, allowed.high));
    }
};

}  // namespace

MotionSpec read_motion(const SceneSource& source, const KnownNames& known) {
    return MotionReader(source, known).read();
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
#include "input/motion_reader.hpp"

#include "core/range.hpp"
#include "core/units.hpp"
#include "input/keys/key_check.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

class MotionReader {
 public:
    MotionReader(const SceneSource& source, const std::vector<std::string>& laws)
        : source_(source), laws_(laws) {}

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
        if (const auto via = source_.find("motion", "via"))
            for (const Node& point : via->value().items) motion.via.push_back(read_point(point));
        if (const auto closed = source_.find("motion", "closed")) motion.closed = closed->value().boolean;
        if (const auto segments = source_.find("motion", "segments"))
            for (const Node& segment : segments->value().items)
                motion.segments.push_back(read_segment(segment, motion));
        check_turn(motion);
        return motion;
    }

 private:
    const SceneSource& source_;
    const std::vector<std::string>& laws_;

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
        refuse({"symmetric", "via"}, "type \"DRD\" or \"RR\"");
    }

    static SetPoint read_point(const Node& table) {
        const auto number = [&](std::string_view name) {
            const auto given = SceneSource::find_in(table, "motion.via", name);
            return given ? std::optional(given->number()) : std::nullopt;
        };
        return {.at = number("at").value_or(0.0),
                .displacement = number("displacement"),
                .velocity = number("velocity"),
                .acceleration = number("acceleration")};
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
        if (const auto angle = find("angle")) segment.angle = angle->number();
        if (const auto law = find("law")) {
            check_name(source_, *law, key(*law), {laws_, "a law of the catalogue: ", ""});
            segment.law = law->value().text;
        }
        if (const auto to = find("to")) segment.to = read_displacement(*to, key(*to), motion);
        return segment;
    }

    /// In lifts.
    double read_displacement(const Given& to, const std::string& key, const MotionSpec& motion) const {
        const std::string_view unit = to.spelling->unit;
        if (unit.empty()) return to.number();
        if (is_angle_unit(unit) != motion.lift_is_angle)
            source_.fail(to.member->place, key,
                         fmt::format("found {} where the lift is {}", to.member->name,
                                     motion.lift_is_angle ? "an angle; allowed: to, to_deg or to_rad"
                                                          : "a length; allowed: to, to_mm, to_in or to_m"));
        return to.number() / motion.lift;
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

MotionSpec read_motion(const SceneSource& source, const std::vector<std::string>& laws) {
    return MotionReader(source, laws).read();
}

}  // namespace camopt::input

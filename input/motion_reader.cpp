// SPDX-License-Identifier: MIT
#include "input/row_reader.hpp"
#include "input/scene_parts.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

// Of a revolution: the rounding of angles written with ten digits.
constexpr double turn_rounding = 1e-9;

/// A point has one location, a region two.
void check_points(const SceneSource& source, const Given& via, const std::string& path) {
    const std::array names = {find_row("motion.via", "at")->names()};
    const std::string points = keys_text(names, [](const Spelling&) { return true; });
    for (std::size_t i = 0; i < via.value().items.size(); ++i) {
        const Node& point = via.value().items[i];
        const std::string own = entry_key(path, i);
        const auto has = [&](std::string_view name) {
            return source.find_in(point, joined_key(via.row->table, via.row->name), name).has_value();
        };
        if (has("from") != has("to"))
            source.fail(point.place, joined_key(own, has("from") ? "to" : "from"),
                        "missing; allowed: both ends of a region, from and to");
        if (!has("from") && !has("at"))
            source.fail(point.place, joined_key(own, "at"),
                        fmt::format("missing; allowed: {} of a point, or from and to of a region", points));
    }
}

/// Angles to begin a search with: each at the same fraction of its range, so that they add up to one
/// revolution. No effect without ranges.
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
        source.fail_member(segment_key(*first, "angle"),
                           fmt::format("found ranges that let the angles add up to {:.10g} to {:.10g} deg; "
                                       "allowed: ranges with 360 deg between",
                                       least / units::degree, most / units::degree));
    const double part = std::clamp((units::turn - least) / (most - least), 0.0, 1.0);
    for (ProgramSegment& segment : motion.segments)
        if (segment.angle_range)
            segment.angle =
                segment.angle_range->least + part * (segment.angle_range->most - segment.angle_range->least);
}

/// The segments of the whole turn: those that are written, `repeat` times.
void repeat_segments(MotionSpec& motion) {
    const std::vector<ProgramSegment> own = motion.segments;
    for (int i = 1; i < motion.repeat; ++i)
        motion.segments.insert(motion.segments.end(), own.begin(), own.end());
}

/// type = "valve": makes the motion that of the lobe. The lift is the valve's.
void read_valve(const SceneSource& source, MotionSpec& motion) {
    const auto need = [&](std::string_view table, std::initializer_list<const char*> names) {
        for (const char* const name : names)
            if (!source.find(table, name))
                source.fail_member(joined_key(table, name), "missing; allowed: needed by type \"valve\"");
    };
    if (motion.lift_is_angle)
        source.fail_member("motion.lift", "found an angle; allowed: a length, the lift of the valve");
    need("motion", {"lift", "checking_height", "duration"});
    const bool swings = source.find("motion", "valve_arm").has_value();
    const auto check_ramp = [&](const std::string& table) {
        for (const char* name : {"height", "velocity"})
            if (const auto given = source.find(table, name);
                given && is_angle_unit(given->spelling->unit) != swings)
                source.fail(given->member->place, joined_key(table, given->member->name),
                            swings ? "found a length; allowed: an angle of the follower, which swings by "
                                     "motion.valve_arm"
                                   : "found an angle; allowed: a length");
        need(table, {"height", "velocity"});
    };
    ValveSpec valve = *motion.valve;
    if (!source.find("motion", "opening")) valve.opening = 0.5 * valve.duration;
    check_ramp("motion.opening_ramp");
    if (source.table("motion.closing_ramp"))
        check_ramp("motion.closing_ramp");
    else
        valve.closing_ramp = valve.opening_ramp;
    if (const std::optional<SceneFault> fault = find_valve_fault(valve))
        source.fail_member(fault->member, words_of(*fault));
    motion.lift_is_angle = swings;
    make_valve_lobe(motion, valve);
    if (swings) return;
    // Words name the checking point in the unit of its height.
    const std::string unit(source.find("motion", "checking_height")->spelling->unit);
    for (ProgramSegment& segment : motion.segments)
        for (SetPoint& point : segment.via) point.units.displacement = unit;
}

class MotionReader {
 public:
    MotionReader(const SceneSource& source, const KnownNames& known) : source_(source), known_(known) {}

    void read(Scene& scene) const {
        MotionSpec& motion = scene.motion;
        refuse_keys_of_other_types(motion.valve ? "valve" : name_of(motion.type));
        check_segments();
        if (motion.valve) read_valve(source_, motion);
        // A given cam needs no task: one stroke around the turn.
        const bool given = scene.measured_rows && scene.measured_rows->use == "given";
        if (given && motion.type == MotionType::program && motion.segments.empty())
            motion.segments.push_back({SegmentKind::spline, units::turn, "", {}});
        settle_angle_ranges(source_, motion);
        check_turn(motion);
        place_states(motion);
        read_scaled_rows(source_, "motion", scene, [&](const GivenAt& key) {
            const bool is_angle_of_cam = key.given.row->spellings.data() == spellings::place.data();
            if (!is_angle_of_cam) check_unit(source_, key.given, key.key, motion);
        });
        check_stops(motion);
        repeat_segments(motion);
        for (Corridor& corridor : motion.corridors)  // one without an end
            if (corridor.to == 0.0) corridor.to = motion.length() * motion.unit_angle();
    }

 private:
    const SceneSource& source_;
    const KnownNames& known_;

    /// An indexing output advances by whole stops.
    void check_stops(const MotionSpec& motion) const {
        const auto stops = source_.find("motion", "stops");
        if (!stops || !motion.relative) return;
        double travel = 0.0;
        for (const ProgramSegment& segment : motion.segments) travel = segment.to.value_or(travel);
        constexpr double same_stop = 1e-9;
        if (travel != 0.0 && std::abs(travel - std::round(travel)) <= same_stop) return;
        const double step = motion.lift / units::degree;
        source_.fail(
            stops->member->place, "motion.stops",
            fmt::format("found {} stops, which are {:.9g} deg apart, and segments that end at {:.9g} deg; "
                        "allowed: segments that end at {:.9g} deg (to = 1) or a multiple of it",
                        stops->value().integer, step, travel * step, step));
    }

    void refuse_keys_of_other_types(std::string_view type) const {
        for (const KeyRow& row : scene_keys()) {
            const std::string_view only = row.table == "motion" ? motion_types_of(row.name, type) : "";
            if (only.empty()) continue;
            if (const auto given = source_.find("motion", row.name))
                source_.fail(given->member->place, joined_key("motion", given->member->name),
                             fmt::format("found this key in a motion of type \"{}\"; allowed: only in {}",
                                         type, only));
        }
    }

    /// Names of laws, and the locations of set points.
    void check_segments() const {
        if (const auto via = source_.find("motion", "via")) check_points(source_, *via, "motion.via");
        const auto segments = source_.find("motion", "segments");
        if (!segments) return;
        for (std::size_t i = 0; i < segments->value().items.size(); ++i) {
            const Node& segment = segments->value().items[i];
            const std::string path = segment_key(i);
            if (const auto law = source_.find_in(segment, "motion.segments", "law"))
                check_law(source_, *law, joined_key(path, law->member->name), known_, {known_.laws});
            if (const auto via = source_.find_in(segment, "motion.segments", "via"))
                check_points(source_, *via, joined_key(path, "via"));
        }
    }

    /// Of the ends of the motion, and of joints.
    static void place_states(MotionSpec& motion) {
        const bool program = motion.type == MotionType::program && !motion.segments.empty();
        if (motion.end) motion.end->at = program ? 1.0 : motion.length();
        for (ProgramSegment& segment : motion.segments)
            if (segment.end) segment.end->at = 1.0;
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
                fmt::format("found {0}, together {1:.10g} {2} of rise and return; allowed: one revolution, "
                            "{3:.10g} {2}, at most",
                            given->value().shown(), total, given->spelling->unit, allowed.high));
    }
};

}  // namespace

void check_law(const SceneSource& source, const Given& given, const std::string& key, const KnownNames& known,
               const AllowedLaws& allowed) {
    check_name(source, given, key, {allowed.keys, "a law of the catalogue: ", allowed.after, '('});
    const Node& name = given.value();
    if (name.text.find('(') == std::string::npos || !known.law_shape) return;
    try {
        (void)known.law_shape(name.text);
    } catch (const InputError& error) {
        source.fail(name.place, key,
                    fmt::format("found {}; allowed: numbers of this law: {}", name.shown(), error.what()));
    }
}

void read_motion(const SceneSource& source, const KnownNames& known, Scene& scene) {
    MotionReader(source, known).read(scene);
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
#include "input/scene_parts.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

// Set points, regions and searched angles of a validated scene file, once the rest of the motion is read.
// Errors: InputError for units that do not fit the lift or need a speed, angles that cannot add up to 360
// deg. Internal to input/.

// Of a revolution: the rounding of angles written with ten digits.
constexpr double turn_rounding = 1e-9;
constexpr std::string_view valve_type = "valve";

/// In lifts; `key`: as written by the user.
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

/// The set points of one stretch.
class SetPointReader {
 public:
    SetPointReader(const SceneSource& source, const MotionSpec& motion, double angle, std::string table)
        : source_(source), motion_(motion), angle_(angle), table_(std::move(table)) {}

    /// `path`: as written by the user, "motion.segments[1].via[0]".
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

    /// Velocity and acceleration at a location, in units of the stretch.
    [[nodiscard]] SetPoint read_state(const Node& node, const std::string& path, double at) const {
        SetPoint point;
        point.at = at;
        for (const int order : {1, 2}) {
            const auto given = SceneSource::find_in(node, table_, order == 1 ? "velocity" : "acceleration");
            if (!given) continue;
            (order == 1 ? point.units.velocity : point.units.acceleration) = given->spelling->unit;
            value_of(point, order) = derivative(*given, joined_key(path, given->member->name), order);
        }
        return point;
    }

    /// SI value of one normalised unit of a quantity in the unit it was written in; 1: normalised.
    [[nodiscard]] double unit_of(const Given& given, const std::string& key, int order) const {
        if (given.spelling->unit.empty()) return 1.0;
        check_unit(given, key);
        return set_point_unit({angle_, motion_.lift, motion_.speed}, order,
                              is_unit_of_time(given.spelling->unit)) /
               given.spelling->factor;
    }

 private:
    const SceneSource& source_;
    const MotionSpec& motion_;
    double angle_;  ///< rad, of the unit of locations
    std::string table_;

    [[nodiscard]] double place(const Given& given, SetPoint& point) const {
        if (given.spelling->unit.empty()) return given.number();
        point.units.place = given.spelling->unit;
        return given.number() / angle_;
    }

    [[nodiscard]] double derivative(const Given& given, const std::string& key, int order) const {
        return given.value().as_number() / unit_of(given, key, order);
    }

    void check_unit(const Given& given, const std::string& key) const {
        const std::string_view unit = given.spelling->unit;
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
    }
};

/// motion.corridor: in lifts, by x of the whole motion.
void read_corridors(const SceneSource& source, MotionSpec& motion) {
    constexpr std::array names = {"displacement", "velocity", "acceleration", "jerk"};
    const auto tables = source.find("motion", "corridor");
    if (!tables) return;
    const SetPointReader reader(source, motion, motion.unit_angle(), "motion.corridor");
    for (const Node& node : tables->value().items) {
        const std::string path = fmt::format("motion.corridor[{}]", motion.corridors.size());
        const auto find = [&](std::string_view name) {
            return SceneSource::find_in(node, "motion.corridor", name);
        };
        Corridor corridor;
        corridor.to = motion.length() * motion.unit_angle();
        if (const auto from = find("from")) corridor.from = from->number();
        if (const auto to = find("to")) corridor.to = to->number();
        for (std::size_t order = 0; order < names.size(); ++order) {
            const auto given = find(names[order]);
            if (!given) continue;
            const std::string key = joined_key(path, given->member->name);
            const double unit = reader.unit_of(*given, key, static_cast<int>(order));
            Corridor::Bounds& bounds = corridor.bounds[order];
            bounds.key = given->member->name;
            bounds.unit = given->spelling->unit;
            if (const Member* const least = given->value().find("min"))
                bounds.least = least->value.as_number() / unit;
            if (const Member* const most = given->value().find("max"))
                bounds.most = most->value.as_number() / unit;
        }
        motion.corridors.push_back(std::move(corridor));
    }
}

/// motion.via, and via of every segment, in units of their stretch.
void read_set_points(const SceneSource& source, MotionSpec& motion) {
    if (const auto via = source.find("motion", "via")) {
        const SetPointReader reader(source, motion, motion.unit_angle(), "motion.via");
        for (const Node& point : via->value().items)
            motion.via.push_back(reader.read(point, fmt::format("motion.via[{}]", motion.via.size())));
    }
    const auto read_end = [&](const char* name, double angle, double at) -> std::optional<SetPoint> {
        const auto given = source.find("motion", name);
        if (!given) return std::nullopt;
        const std::string path = joined_key("motion", name);
        return SetPointReader(source, motion, angle, path).read_state(given->value(), path, at);
    };
    const bool program = motion.type == MotionType::program && !motion.segments.empty();
    motion.start = read_end("start", program ? motion.segments.front().angle : motion.unit_angle(), 0.0);
    motion.end = read_end("end", program ? motion.segments.back().angle : motion.unit_angle(),
                          program ? 1.0 : motion.length());
    const auto segments = source.find("motion", "segments");
    if (!segments) return;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const Node& own = segments->value().items[i];
        if (const auto end = SceneSource::find_in(own, "motion.segments", "end"))
            motion.segments[i].end =
                SetPointReader(source, motion, motion.segments[i].angle, "motion.segments.end")
                    .read_state(end->value(), fmt::format("motion.segments[{}].end", i), 1.0);
        const auto via = SceneSource::find_in(own, "motion.segments", "via");
        if (!via) continue;
        std::vector<SetPoint>& points = motion.segments[i].via;
        const SetPointReader reader(source, motion, motion.segments[i].angle, "motion.segments.via");
        for (const Node& point : via->value().items)
            points.push_back(
                reader.read(point, fmt::format("motion.segments[{}].via[{}]", i, points.size())));
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

/// The segments of the whole turn: those that are written, `repeat` times.
void repeat_segments(MotionSpec& motion) {
    const std::vector<ProgramSegment> own = motion.segments;
    for (int i = 1; i < motion.repeat; ++i)
        motion.segments.insert(motion.segments.end(), own.begin(), own.end());
}

/// type = "valve": makes the motion that of the lobe. The lift is the valve's.
void read_valve(const SceneSource& source, MotionSpec& motion) {
    ValveSpec valve;
    const auto needed = [&](std::string_view table, const char* name) {
        const std::optional<double> number = source.number(table, name);
        if (!number)
            source.fail_member(joined_key(table, name), "missing; allowed: needed by type \"valve\"");
        return *number;
    };
    if (motion.lift_is_angle)
        source.fail_member("motion.lift", "found an angle; allowed: a length, the lift of the valve");
    valve.lift = needed("motion", "lift");
    source.read_number("motion", "rocker_ratio", valve.ratio);
    source.read_number("motion", "valve_arm", valve.ratio);
    source.read_number("motion", "lash", valve.lash);
    valve.checking_height = needed("motion", "checking_height");
    valve.duration = needed("motion", "duration");
    valve.opening = source.number("motion", "opening").value_or(0.5 * valve.duration);
    valve.centerline = source.number("motion", "centerline");
    const bool swings = source.find("motion", "valve_arm").has_value();
    const auto read_ramp = [&](const std::string& table) {
        for (const char* name : {"height", "velocity"})
            if (const auto given = source.find(table, name);
                given && is_angle_unit(given->spelling->unit) != swings)
                source.fail(given->member->place, joined_key(table, given->member->name),
                            swings ? "found a length; allowed: an angle of the follower, which swings by "
                                     "motion.valve_arm"
                                   : "found an angle; allowed: a length");
        return ValveRamp{needed(table, "height"), needed(table, "velocity"), source.number(table, "end")};
    };
    valve.opening_ramp = read_ramp("motion.opening_ramp");
    valve.closing_ramp =
        source.table("motion.closing_ramp") ? read_ramp("motion.closing_ramp") : valve.opening_ramp;
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

    void read(MotionSpec& motion) const {
        source_.read_choice("motion", "type", {MotionType::drd, MotionType::rr, MotionType::program},
                            motion.type);
        const auto type = source_.find("motion", "type");
        const bool is_valve = type && type->value().text == valve_type;
        refuse_keys_of_other_types(is_valve ? valve_type : name_of(motion.type));
        if (const auto lift = source_.find("motion", "lift")) {
            motion.lift = lift->number();
            motion.lift_is_angle = is_angle_unit(lift->spelling->unit);
        }
        if (const auto stops = source_.find("motion", "stops")) {
            motion.lift = units::turn / static_cast<double>(stops->value().integer);
            motion.lift_is_angle = true;
        }
        if (const auto engine = source_.number("motion", "engine_speed")) motion.speed = 0.5 * *engine;
        if (const auto closed = source_.find("motion", "closed")) {
            motion.relative = closed->value().kind == NodeKind::text;
            motion.closed = closed->value().kind == NodeKind::boolean && closed->value().boolean;
        }
        if (const auto segments = source_.find("motion", "segments"))
            for (const Node& segment : segments->value().items)
                motion.segments.push_back(read_segment(segment, motion));
        check_stops(motion);
        if (is_valve) read_valve(source_, motion);
        settle_angle_ranges(source_, motion);
        check_turn(motion);
        read_set_points(source_, motion);
        repeat_segments(motion);
        read_corridors(source_, motion);
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

void read_motion(const SceneSource& source, const KnownNames& known, MotionSpec& motion) {
    MotionReader(source, known).read(motion);
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// The rows of [motion] and [measured].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"
#include "scene/set_point_scale.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;
using key_place::each, key_place::each_inner;

const Range within_turn = Range::above_up_to(0.0, 360.0);
const Range within_phase{.low = -360.0, .high = 360.0, .low_included = false, .high_included = false};

bool is_written(const Scene& scene, const char* key) {
    return scene.written.contains(key);
}

/// "valve" makes the motion a program once all of the lobe is read.
KeyPlace type_place() {
    KeyPlace place = stored_in(&Scene::motion, &MotionSpec::type);
    place.assign = [type = place.assign](Scene& scene, const KeyValue& value, KeyAt at) {
        if (value == KeyValue("valve")) {
            scene.motion.valve.emplace();
            return;
        }
        at.choices = 3;  // of MotionType
        type(scene, value, at);
    };
    place.value = [type = place.value](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        return scene.motion.valve ? "valve" : type(scene, at);
    };
    return place;
}

/// Of an indexing output stops say it, of a valve that of the follower follows.
bool lift_is_stops(const Scene& scene) {
    return is_written(scene, "motion.stops") && scene.motion.lift_is_angle &&
           scene.motion.lift == units::turn / std::round(units::turn / scene.motion.lift);
}

KeyPlace lift_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt& at) {
                    MotionSpec& motion = scene.motion;
                    (motion.valve ? motion.valve->lift : motion.lift) = std::get<double>(value);
                    motion.lift_is_angle = at.spelling != nullptr && is_angle_unit(at.spelling->unit);
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (lift_is_stops(scene)) return std::nullopt;
                return scene.motion.valve ? scene.motion.valve->lift : scene.motion.lift;
            }};
}

KeyPlace stops_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    scene.motion.lift = units::turn / static_cast<double>(std::get<long long>(value));
                    scene.motion.lift_is_angle = true;
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (!lift_is_stops(scene)) return std::nullopt;
                return std::llround(units::turn / scene.motion.lift);
            }};
}

KeyPlace speed_place() {
    return unless(stored_in(&Scene::motion, &MotionSpec::speed),
                  [](const Scene& scene, const KeyAt&) { return is_written(scene, "motion.engine_speed"); });
}

KeyPlace engine_speed_place() {
    return {.assign = [](Scene& scene, const KeyValue& value,
                         const KeyAt&) { scene.motion.speed = 0.5 * std::get<double>(value); },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (!scene.motion.speed || !is_written(scene, "motion.engine_speed")) return std::nullopt;
                return 2.0 * *scene.motion.speed;
            }};
}

/// true, false, or "relative".
KeyPlace closed_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    const bool* const closed = std::get_if<bool>(&value);
                    scene.motion.relative = closed == nullptr;
                    scene.motion.closed = closed != nullptr && *closed;
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (scene.motion.relative) return "relative";
                return scene.motion.closed;
            }};
}

/// Those of one part of a repeated program; a valve lobe says its own.
KeyPlace segments_place() {
    KeyPlace place = stored_in(&Scene::motion, &MotionSpec::segments);
    place.value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        const MotionSpec& motion = scene.motion;
        return motion.valve ? 0LL : static_cast<long long>(motion.own_segments());
    };
    return place;
}

template <class Member>
KeyPlace of_valve(Member member) {
    return stored_in(&Scene::motion, &MotionSpec::valve, member);
}

/// Valve travel by follower travel; an arm where the follower swings.
KeyPlace ratio_place(bool arm) {
    return unless(of_valve(&ValveSpec::ratio),
                  [arm](const Scene& scene, const KeyAt&) { return scene.motion.lift_is_angle != arm; });
}

KeyPlace opening_place() {
    return unless(of_valve(&ValveSpec::opening), [](const Scene& scene, const KeyAt&) {
        return scene.motion.valve && scene.motion.valve->opening == 0.5 * scene.motion.valve->duration;
    });
}

KeyPlace closing_ramp_place() {
    return unless(of_valve(&ValveSpec::closing_ramp), [](const Scene& scene, const KeyAt&) {
        return scene.motion.valve && scene.motion.valve->closing_ramp == scene.motion.valve->opening_ramp;
    });
}

/// A number, or the range that is searched.
KeyPlace segment_angle_place() {
    const KeyPlace angle = stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::angle);
    KeyPlace place = angle;
    place.assign = [angle](Scene& scene, const KeyValue& value, const KeyAt& at) {
        const auto* const range = std::get_if<KeyBounds>(&value);
        angle.assign(scene, range != nullptr ? KeyValue(*range->least) : value, at);
        if (range != nullptr)
            scene.motion.segments[at.entry[0]].angle_range = AngleRange{*range->least, *range->most};
    };
    place.value = [angle](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        const std::optional<KeyValue> number = angle.value(scene, at);
        if (!number || !scene.motion.segments[at.entry[0]].angle_range) return number;
        const AngleRange& range = *scene.motion.segments[at.entry[0]].angle_range;
        return KeyBounds{range.least, range.most};
    };
    return place;
}

/// The unit of a number that remembers it: where the number is normalised it is empty.
KeyPlace in_unit(KeyPlace place, const KeyPlace& unit) {
    place.assign = [assign = place.assign, unit](Scene& scene, const KeyValue& value, const KeyAt& at) {
        assign(scene, value, at);
        if (at.spelling != nullptr && !at.spelling->unit.empty())
            unit.assign(scene, std::string(at.spelling->unit), at);
    };
    place.unit = [unit](const Scene& scene, const KeyAt& at) {
        const std::optional<KeyValue> known = unit.value(scene, at);
        return known ? std::get<std::string>(*known) : std::string();
    };
    return place;
}

KeyPlace segment_to_place() {
    KeyPlace place =
        in_unit(stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::to),
                stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::to_unit));
    place.stored = [](const Scene& scene, const KeyAt& at, double written) {
        return at.spelling->unit.empty() ? written : written * at.spelling->factor / scene.motion.lift;
    };
    return place;
}

/// The angle that x of a set point counts in, rad.
using StretchAngle = double (*)(const MotionSpec& motion, const KeyAt& at);

double whole_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.unit_angle();
}
double segment_angle(const MotionSpec& motion, const KeyAt& at) {
    return motion.segments.at(at.entry[0]).angle;
}
double first_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.segments.empty() ? motion.unit_angle() : motion.segments.front().angle;
}
double last_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.segments.empty() ? motion.unit_angle() : motion.segments.back().angle;
}

constexpr int location = -1;  // in place of the order of a derivative

/// In a unit: by the angle of the stretch, the lift and, in time, the speed.
void normalise(KeyPlace& place, StretchAngle angle, int order) {
    place.stored = [=](const Scene& scene, const KeyAt& at, double written) {
        const MotionSpec& motion = scene.motion;
        if (at.spelling->unit.empty()) return written;
        const double si = written * at.spelling->factor, own = angle(motion, at);
        if (order == location) return si / own;
        return si /
               set_point_unit({own, motion.lift, motion.speed}, order, is_unit_of_time(at.spelling->unit));
    };
}

/// The places of a set point's numbers; `path` leads to it.
template <class... Path>
struct SetPointPlaces {
    StretchAngle angle;
    std::tuple<Path...> path;

    SetPointPlaces(StretchAngle own_angle, Path... own_path) : angle(own_angle), path(own_path...) {}

    template <class... Member>
    [[nodiscard]] KeyPlace of(Member... member) const {
        return std::apply([&](auto... step) { return stored_in(step..., member...); }, path);
    }
    template <class Member>
    [[nodiscard]] KeyPlace number(Member member, std::string SetPointUnits::*unit, int order) const {
        KeyPlace place = in_unit(of(member), of(&SetPoint::units, unit));
        normalise(place, angle, order);
        return place;
    }
    /// A region has `from` and `to`, a point `at`.
    [[nodiscard]] KeyPlace begin(bool of_region) const {
        return unless(number(&SetPoint::at, &SetPointUnits::place, location),
                      [of_region, until = of(&SetPoint::until)](const Scene& scene, const KeyAt& at) {
                          return until.value(scene, at).has_value() != of_region;
                      });
    }
    /// With `to` at its place until that is read.
    [[nodiscard]] KeyPlace from() const {
        KeyPlace place = begin(true);
        place.assign = [first = place.assign, until = of(&SetPoint::until)](
                           Scene& scene, const KeyValue& value, const KeyAt& at) {
            first(scene, value, at);
            until.assign(scene, value, at);
        };
        return place;
    }
    [[nodiscard]] KeyPlace until() const { return number(&SetPoint::until, &SetPointUnits::place, location); }
    [[nodiscard]] KeyPlace displacement() const {
        return number(&SetPoint::displacement, &SetPointUnits::displacement, 0);
    }
    [[nodiscard]] KeyPlace velocity() const {
        return number(&SetPoint::velocity, &SetPointUnits::velocity, 1);
    }
    [[nodiscard]] KeyPlace acceleration() const {
        return number(&SetPoint::acceleration, &SetPointUnits::acceleration, 2);
    }
};

/// Bounds of the derivative of `order`, and how they are written.
KeyPlace corridor_bounds(std::string_view name, std::size_t order) {
    using Bounds = Corridor::Bounds;
    const auto of = [order](auto member) {
        return stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::bounds, order, member);
    };
    KeyPlace place = in_unit(of(&Bounds::least), of(&Bounds::unit));
    place.assign = [=, unit = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        Bounds& bounds = scene.motion.corridors.at(at.entry[0]).bounds[order];
        const KeyBounds& given = std::get<KeyBounds>(value);
        unit(scene, 0.0, at);
        bounds.least = given.least;
        bounds.most = given.most;
        bounds.key = std::string(name) + std::string(at.spelling->suffix);
    };
    place.value = [order](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        if (at.entry[0] >= scene.motion.corridors.size()) return std::nullopt;
        const Bounds& bounds = scene.motion.corridors[at.entry[0]].bounds[order];
        if (!bounds.least && !bounds.most) return std::nullopt;
        return KeyBounds{bounds.least, bounds.most};
    };
    normalise(place, whole_angle, static_cast<int>(order));
    return place;
}

KeyPlace corridor_end() {
    return unless(stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::to),
                  [](const Scene& scene, const KeyAt& at) {
                      const MotionSpec& motion = scene.motion;
                      return at.entry[0] < motion.corridors.size() &&
                             motion.corridors[at.entry[0]].to == motion.length() * motion.unit_angle();
                  });
}

template <class Member>
KeyPlace of_measured(Member member) {
    return stored_in(&Scene::measured_rows, member);
}

/// A word, or a table with an angle.
KeyPlace zero_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    if (!scene.measured_rows) return;
                    if (const auto* const word = std::get_if<std::string>(&value))
                        scene.measured_rows->zero = *word;
                    else
                        scene.measured_rows->zero_angle.emplace();
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (!scene.measured_rows) return std::nullopt;
                return scene.measured_rows->zero_angle ? KeyValue() : KeyValue(scene.measured_rows->zero);
            }};
}

// A row is read as a row.
// clang-format off
Rows top_level() {
    return {
        {"", "title", text, plain, any, {}, "empty", "What the scene is; repeated in every output.",
         stored_in(&Scene::title)},
        {"", "motion", table, plain, any, {}, "required", "What must move.", stored_in(&Scene::motion)},
        {"", "spline", table, plain, any, {}, "its defaults", "The family of curves that is searched.",
         stored_in(&Scene::spline)},
        {"", "objective", table, plain, any, {}, "needed by a spline",
         "What makes one curve better than another; a program of laws and dwells needs none.", stored_in(&Scene::objective)},
        {"", "cam", table, plain, any, {}, "no cam", "The cam and its follower.", stored_in(&Scene::cam)},
    };
}

Rows motion() {
    return {
        {"motion", "type", text, plain, any, {"DRD", "RR", "program", "valve"}, "required",
         "`\"DRD\"`: rise between two dwells. `\"RR\"`: rise and return without a dwell at the top. "
         "`\"program\"`: the segments of one revolution, without `rise`, `return`, `symmetric` and `via` outside "
         "them; each segment may have its own `via`. `\"valve\"`: a valve lobe.", type_place()},
        {"motion", "lift", number, lift, positive, {}, "1 mm",
         "Lift of the follower; an angle for a swinging or indexing output. Of type `\"valve\"` the lift of the valve "
         "at the nose, needed.", lift_place()},
        {"motion", "rise", number, cam_angle, within_turn, {}, "180 deg", "Cam angle of the rise.",
         stored_in(&Scene::motion, &MotionSpec::rise)},
        {"motion", "return", number, cam_angle, within_turn, {}, "the rise",
         "Cam angle of the return, RR only; rise and return together at most 360 deg.",
         stored_in(&Scene::motion, &MotionSpec::return_angle)},
        {"motion", "speed", number, speed, positive, {}, "none",
         "Speed of the cam; only limits and outputs in time need it.", speed_place()},
        {"motion", "symmetric", boolean, plain, any, {}, "false",
         "Force y(x) + y(1 - x) = 1 (DRD) or y(x) = y(2 - x) (RR with equal angles).",
         stored_in(&Scene::motion, &MotionSpec::symmetric)},
        {"motion", "within_lift", boolean, plain, any, {}, "true",
         "Each stroke stays between the displacements at its ends (set points outside widen the range); false: the "
         "motion may leave it.", stored_in(&Scene::motion, &MotionSpec::within_lift)},
        {"motion", "monotone", boolean, plain, any, {}, "false",
         "A rise only rises, a return only falls: the velocity never changes its sign within a stroke.",
         stored_in(&Scene::motion, &MotionSpec::monotone)},
        {"motion", "via", tables, plain, any, {}, "none",
         "Points the curve meets exactly, and regions of constant velocity, one table each.",
         stored_in(&Scene::motion, &MotionSpec::via)},
        {"motion", "segments", tables, plain, any, {}, "none",
         "The segments of a program, one table each, from displacement 0 on.", segments_place()},
        {"motion", "closed", boolean_or_text, plain, any, {"relative"}, "true",
         "The program is one revolution: its angles add up to 360 deg and it ends at displacement 0. "
         "`\"relative\"`: one revolution that goes on in the next one from the displacement it has reached. "
         "`false`: a part of a revolution.", closed_place()},
        {"motion", "repeat", integer, plain, Range::between(1, 1000), {}, "1",
         "Of a closed program: the segments fill so many equal parts of the revolution, each with the same motion.",
         stored_in(&Scene::motion, &MotionSpec::repeat)},
        {"motion", "stops", integer, plain, Range::between(1, 10000), {}, "none",
         "Of an indexing output: the lift is 360 deg divided by this.", stops_place(), Availability::now, "lift"},
        {"motion", "phase", number, cam_angle, within_phase, {}, "0",
         "Of a program of one revolution: the angle of the master at which the motion begins. Motion tables, tables of "
         "controllers and reports are by the master's angle; a machine sets it.",
         stored_in(&Scene::motion, &MotionSpec::phase)},
        {"motion", "start", table, plain, any, {}, "at rest",
         "State at the start of a motion that is not closed; what is not given is 0.",
         stored_in(&Scene::motion, &MotionSpec::start)},
        {"motion", "end", table, plain, any, {}, "at rest",
         "State at its end, after the last segment of a program.", stored_in(&Scene::motion, &MotionSpec::end)},
        {"motion", "corridor", tables, plain, any, {}, "none",
         "Inequalities on a stretch of the cam angle, one table each.",
         stored_in(&Scene::motion, &MotionSpec::corridors)},
        {"motion", "duration", number, cam_angle, within_turn, {}, "needed by a valve",
         "Type `\"valve\"`: between the two angles at which the valve has lifted `checking_height`.",
         of_valve(&ValveSpec::duration)},
        {"motion", "checking_height", number, length, positive, {}, "needed by a valve",
         "Type `\"valve\"`: lift of the valve at which the duration is measured.", of_valve(&ValveSpec::checking_height)},
        {"motion", "lash", number, length, not_negative, {}, "0", "Type `\"valve\"`: clearance, at the valve.",
         of_valve(&ValveSpec::lash)},
        {"motion", "rocker_ratio", number, plain, positive, {}, "1",
         "Type `\"valve\"`: valve travel by follower travel.", ratio_place(false)},
        {"motion", "valve_arm", number, length, positive, {}, "none",
         "Type `\"valve\"` with an oscillating (finger) follower: valve travel by radian of the follower.",
         ratio_place(true), Availability::now, "rocker_ratio"},
        {"motion", "opening", number, cam_angle, within_turn, {}, "half the duration",
         "Type `\"valve\"`: the part of the duration before the nose.", opening_place()},
        {"motion", "centerline", number, cam_angle, any, {}, "none",
         "Type `\"valve\"`: of the nose after top dead centre, negative before it (exhaust); events alone use it.",
         of_valve(&ValveSpec::centerline)},
        {"motion", "engine_speed", number, speed, positive, {}, "none",
         "Type `\"valve\"`: twice the cam's speed.", engine_speed_place(), Availability::now, "speed"},
        {"motion", "opening_ramp", table, plain, any, {}, "needed by a valve",
         "Type `\"valve\"`: from the base circle smoothly to a constant velocity, and on to the opening flank.",
         of_valve(&ValveSpec::opening_ramp)},
        {"motion", "closing_ramp", table, plain, any, {}, "as the opening ramp",
         "Type `\"valve\"`: from the closing flank to the base circle.", closing_ramp_place()},
        {"motion.segments", "kind", text, plain, any, {"dwell", "law", "spline"}, "required",
         "`\"dwell\"` keeps the displacement, `\"law\"` is a classical law, `\"spline\"` is optimised.",
         stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::kind)},
        {"motion.segments", "angle", number_or_range, cam_angle, within_turn, {}, "required",
         "Cam angle of the segment; a range is searched, and the angles still add up to 360 deg (closed programs, "
         "two ranges or more).", segment_angle_place()},
        {"motion.segments", "law", text, plain, any, {}, "none",
         "A law of the catalogue; kind `\"law\"` only, and needed there.",
         stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::law)},
        {"motion.segments", "to", number, displacement, any, {}, "free",
         "Displacement at its end, in lifts or in a unit of the lift; not for dwells. Free: the optimizer "
         "chooses it, and the peaks are measured by what it finds; but the last one of a closed program is 0.",
         segment_to_place()},
        {"motion.segments", "end", table, plain, any, {}, "free",
         "State at the joint of two segments of kind `\"spline\"`: `{ velocity = 0 }` is a turning point without a "
         "dwell.", stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::end)},
        {"motion.segments", "via", tables, plain, any, {}, "none",
         "Set points and regions of a segment of kind `\"spline\"`, as `motion.via`, counted from its start.",
         stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::via)},
    };
}

/// Set points of the whole motion, or of a segment: `unit` is that of their locations.
template <class Places>
Rows set_points(const char* table, const char* unit, const Places& places) {
    static const std::string in_rise = "Where, in units of the rise (DRD 0 to 1, RR 0 to 1 + return/rise) or as "
                                       "a cam angle.";
    static const std::string in_segment = "Where, in units of the segment (0 to 1) or as a cam angle from its "
                                          "start.";
    const bool whole = std::string_view(unit) == "rise";
    return {
        {table, "at", number, place, not_negative, {}, "needed by a point",
         whole ? in_rise : in_segment, places.begin(false)},
        {table, "from", number, place, not_negative, {}, "needed by a region",
         "Where a region begins, in the units of `at`. Its `velocity` holds exactly from here to its end, and "
         "both are breakpoints of the spline.", places.from(), Availability::now, "at"},
        {table, "to", number, place, not_negative, {}, "needed by a region",
         "Where the region ends.", places.until(), Availability::now, "at"},
        {table, "displacement", number, spellings::displacement, any, {}, "free",
         "There; of a region where it begins. In lifts (s/lift) or in a unit of the lift.", places.displacement()},
        {table, "velocity", number, spellings::velocity, any, {}, "free",
         whole ? "There, or all along the region: dy/dx, by the cam angle, or in time (needs a speed)."
               : "There, or all along the region: lifts per segment, by the cam angle, or in time (needs a "
                 "speed).", places.velocity()},
        {table, "acceleration", number, spellings::acceleration, any, {}, "free",
         whole ? "There: d²y/dx², by the cam angle, or in time; not in a region, where it is 0."
               : "There: lifts per segment squared, by the cam angle, or in time; not in a region, where it is "
                 "0.", places.acceleration()},
    };
}

/// Velocity and acceleration at an end of the motion, or of a segment.
template <class Places>
Rows end_state(const char* table, const Places& places) {
    const bool joint = std::string_view(table) == "motion.segments.end";
    const char* const otherwise = joint ? "free" : "0";
    return {
        {table, "velocity", number, spellings::velocity, any, {}, otherwise,
         joint ? "There: lifts per segment, by the cam angle, or in time (needs a speed)."
               : "There: dy/dx (programs: lifts per segment), by the cam angle, or in time (needs a speed).",
         places.velocity()},
        {table, "acceleration", number, spellings::acceleration, any, {}, otherwise, "There, likewise.",
         places.acceleration()},
    };
}

/// A ramp of a valve lobe.
Rows valve_ramp(const char* table) {
    const bool opening = std::string_view(table) == "motion.opening_ramp";
    const auto of_ramp = [opening](auto member) {
        return stored_in(&Scene::motion, &MotionSpec::valve, opening ? &ValveSpec::opening_ramp : &ValveSpec::closing_ramp,
                         member);
    };
    return {
        {table, "height", number, lift, positive, {}, "required",
         "Of the follower above the base circle, where the ramp meets the flank.", of_ramp(&ValveRamp::height)},
        {table, "velocity", number, ramp_velocity, positive, {}, "required",
         "Of the follower by the cam angle, constant over the last two thirds of the height.", of_ramp(&ValveRamp::velocity)},
        {table, "end", number, cam_angle, positive, {}, "by half of a typical flank",
         opening ? "Where the ramp ends, before the opening checking point; only where that point, at the follower "
                   "displacement s, is above the ramp."
                 : "Where the ramp begins, after the closing checking point, likewise.", of_ramp(&ValveRamp::end)},
    };
}

Rows corridor() {
    constexpr const char* table = "motion.corridor";
    return {
        {table, "from", number, angle, not_negative, {}, "0 deg",
         "Where it begins, counted from the start of the motion; it holds there too.",
         stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::from)},
        {table, "to", number, angle, positive, {}, "the end", "Where it ends; it holds there too.", corridor_end()},
        {table, "displacement", bounds, spellings::displacement, any, {}, "none",
         "Bounds of the displacement, in lifts or in a unit of the lift.", corridor_bounds("displacement", 0)},
        {table, "velocity", bounds, spellings::velocity, any, {}, "none",
         "Bounds of the velocity: dy/dx (programs: x = 1 is the first spline segment), by the cam angle, or in "
         "time.", corridor_bounds("velocity", 1)},
        {table, "acceleration", bounds, spellings::acceleration, any, {}, "none",
         "Bounds of the acceleration, likewise.", corridor_bounds("acceleration", 2)},
        {table, "jerk", bounds, spellings::jerk, any, {}, "none", "Bounds of the jerk, likewise.",
         corridor_bounds("jerk", 3)},
    };
}

Rows measured() {
    return {
        {"measured", "table", text, plain, any, {}, "none",
         "A CSV file in the scene's folder (or a path from there), also one that camopt wrote. Its first line names "
         "the columns, in any order: `theta_deg`, `theta_rad` or `crank_deg`, the angle, and `s_mm`, `s_in`, `s_m`, "
         "`s_deg` or `s_rad`, or of points of a disk cam `x_mm` and `y_mm`, or `r_mm` (`_in`, `_m`) and the angle; "
         "others are ignored.", of_measured(&MeasuredRows::table)},
        {"measured", "columns", texts, plain, any, {}, "the file's first line",
         "Names of the columns, in the order of the file: of a file without such a line, or in place of it.",
         of_measured(&MeasuredRows::columns)},
        {"measured", "decimal", text, plain, any, {".", ","}, "\".\"",
         "Decimal point or comma of the file; with a comma, columns are separated by semicolons or tabs.",
         of_measured(&MeasuredRows::decimal)},
        {"measured", "scale", numbers, plain, any, {}, "1",
         "A number for each column of the file: what one unit of a cell is in the unit that the column's name says.",
         of_measured(&MeasuredRows::scale)},
        {"measured", "offset", numbers, plain, any, {}, "0",
         "A number for each column, added after `scale`, in the unit that the column's name says.",
         of_measured(&MeasuredRows::offset)},
        {"measured", "skip_lines", integer, plain, Range::between(0, 10000), {}, "0",
         "Lines at the beginning of the file that are not read. Needed only where they hold numbers: text above the "
         "names, or with `columns` above the first row, is passed over.", of_measured(&MeasuredRows::skip_lines)},
        {"measured", "theta", numbers, cam_angle, any, {}, "none",
         "The angles themselves, ascending or descending.", of_measured(&MeasuredRows::theta), Availability::now, "table"},
        {"measured", "s", numbers, lift, any, {}, "none", "The displacements at these angles.",
         of_measured(&MeasuredRows::s), Availability::now, "table"},
        {"measured", "x", numbers, length, any, {}, "none",
         "With `y`: points of the surface of the disk cam of `[cam]`, which become the motion of its follower. In the "
         "cam's frame: at cam angle 0 a pushed follower rises along +y, the pivot of a swinging one lies on +x.",
         of_measured(&MeasuredRows::x), Availability::needs_cam, "table"},
        {"measured", "y", numbers, length, any, {}, "none", "With `x`.", of_measured(&MeasuredRows::y), Availability::needs_cam, "table"},
        {"measured", "r", numbers, length, positive, {}, "none",
         "Such points in polar coordinates, with `theta` from +x counterclockwise.", of_measured(&MeasuredRows::r),
         Availability::needs_cam, "table"},
        {"measured", "probe_radius", number, length, not_negative, {}, "0",
         "Points are the centres of a ball of this radius that touches the cam.", of_measured(&MeasuredRows::probe_radius),
         Availability::needs_cam},
        {"measured", "step", number, cam_angle, positive, {}, "none",
         "The angle from row to row, from 0 on, of displacements without angles.", of_measured(&MeasuredRows::step), Availability::now, "theta"},
        {"measured", "zero", text_or_table, plain, any, {"start", "nose"}, "\"start\"",
         "What angle 0 of the table is: the start of the motion, its nose (the end of the rise; in a program the "
         "middle of its largest displacement), or the cam angle `{ deg = 30 }` of the motion. Rows of one revolution "
         "may begin anywhere.", zero_place()},
        {"measured", "angles", text, plain, any, {"cam", "crank"}, "\"cam\"",
         "`\"crank\"`: `theta` and `step` are crank angles, two for one of the cam.", of_measured(&MeasuredRows::angles)},
        {"measured.zero", "deg", number, degrees, any, {}, "required", "Cam angle from the start of the motion.",
         of_measured(&MeasuredRows::zero_angle)},
        {"measured", "register", texts, plain, any, {"angle", "radius"}, "nothing",
         "What is not known of the table and searched: `\"angle\"`, the angle where the motion starts (instead of "
         "`zero`); `\"radius\"`, the displacement, or the base radius of points, where the motion has 0.", of_measured(&MeasuredRows::registered)},
        {"measured", "outliers", text, plain, any, {"keep", "exclude"}, "\"keep\"",
         "Rows far from their neighbours are named in reports. `\"exclude\"`: they are not used.",
         of_measured(&MeasuredRows::outliers)},
        {"measured", "use", text, plain, any, {"compare", "start", "nearest"}, "\"compare\"",
         "`\"compare\"`: what the optimum gains over it. `\"start\"`: searches begin from it, too. `\"nearest\"`: the "
         "optimum is the motion nearest to its rows (objective.deviation, or deviation_rms by `norm`).", of_measured(&MeasuredRows::use)},
        {"measured", "norm", text, plain, any, {"peak", "rms"}, "\"peak\"",
         "Of `\"nearest\"`: the largest deviation, or the root mean square of all.", of_measured(&MeasuredRows::norm)},
        {"measured", "name", text, plain, any, {}, "the file's", "Its name in reports.", of_measured(&MeasuredRows::name)},
    };
}
// clang-format on

}  // namespace

// clang-format off
Rows other_tables() {
    return {
        {"cam", "rotation", text, plain, any, {"counterclockwise", "clockwise"}, "\"counterclockwise\"",
         "The sense in which the cam turns.", stored_in(&Scene::cam, &CamSpec::rotation)},
        {"", "forces", table, plain, any, {}, "no forces",
         "What the follower carries; needs a speed.", stored_in(&Scene::forces), Availability::needs_cam},
        {"", "measured", table, plain, any, {}, "none",
         "A motion that was measured: compared with the optimum, or where searches begin.",
         stored_in(&Scene::measured_rows)},
        {"", "dynamics", table, plain, any, {}, "a rigid follower",
         "The elastic follower train between cam and output; needs a speed.", stored_in(&Scene::dynamics)},
        {"", "drive", table, plain, any, {}, "no motor",
         "A motor in place of a cam: a servo axis; needs a speed.", stored_in(&Scene::drive)},
        {"", "limits", table, plain, any, {}, "no limits", "What no curve may exceed.", stored_in(&Scene::limits)},
        {"", "solver", table, plain, any, {}, "its defaults", "How the optimum is found.", stored_in(&Scene::solver)},
    };
}
// clang-format on

Rows of_motion() {
    const SetPointPlaces via(whole_angle, &Scene::motion, &MotionSpec::via, each);
    const SetPointPlaces start(first_angle, &Scene::motion, &MotionSpec::start);
    const SetPointPlaces end(last_angle, &Scene::motion, &MotionSpec::end);
    const SetPointPlaces of_segment(segment_angle, &Scene::motion, &MotionSpec::segments, each,
                                    &ProgramSegment::via, each_inner);
    const SetPointPlaces joint(segment_angle, &Scene::motion, &MotionSpec::segments, each,
                               &ProgramSegment::end);
    return joined({top_level(), motion(), set_points("motion.via", "rise", via),
                   end_state("motion.start", start), end_state("motion.end", end),
                   valve_ramp("motion.opening_ramp"), valve_ramp("motion.closing_ramp"), corridor(),
                   set_points("motion.segments.via", "segment", of_segment),
                   end_state("motion.segments.end", joint), measured()});
}

}  // namespace camopt::key_rows

// SPDX-License-Identifier: MIT
// The rows of the top level, of [motion] with its segments and ramps, and of the tables after [cam].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;
using key_place::each;

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
        std::optional<KeyValue> number = angle.value(scene, at);
        if (!number || !scene.motion.segments[at.entry[0]].angle_range) return number;
        const AngleRange& range = *scene.motion.segments[at.entry[0]].angle_range;
        return KeyBounds{range.least, range.most};
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

template <class Member>
KeyPlace of_piece(Member member) {
    return stored_in(&Scene::cam, &CamSpec::pieces, each, member);
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
        called("kind of motion", {"motion", "type", text, plain, any, {"DRD", "RR", "program", "valve"}, "required",
         "`\"DRD\"`: rise between two dwells. `\"RR\"`: rise and return without a dwell at the top. "
         "`\"program\"`: the segments of one revolution, without `rise`, `return`, `symmetric` and `via` outside "
         "them; each segment may have its own `via`. `\"valve\"`: a valve lobe.", type_place()}),
        {"motion", "lift", number, lift, positive, {}, "1 mm",
         "Lift of the follower; an angle for a swinging or indexing output. Of type `\"valve\"` the lift of the valve "
         "at the nose, needed.", lift_place()},
        called("rise, cam angle", {"motion", "rise", number, cam_angle, within_turn, {}, "180 deg", "Cam angle of the rise.",
         stored_in(&Scene::motion, &MotionSpec::rise)}),
        called("return, cam angle", {"motion", "return", number, cam_angle, within_turn, {}, "the rise",
         "Cam angle of the return, RR only; rise and return together at most 360 deg.",
         stored_in(&Scene::motion, &MotionSpec::return_angle)}),
        called("cam speed", {"motion", "speed", number, speed, positive, {}, "none",
         "Speed of the cam; only limits and outputs in time need it.", speed_place()}),
        called("symmetric motion", {"motion", "symmetric", boolean, plain, any, {}, "false",
         "Force y(x) + y(1 - x) = 1 (DRD) or y(x) = y(2 - x) (RR with equal angles).",
         stored_in(&Scene::motion, &MotionSpec::symmetric)}),
        called("each stroke stays between its ends", {"motion", "within_lift", boolean, plain, any, {}, "true",
         "Each stroke stays between the displacements at its ends (set points outside widen the range); false: the "
         "motion may leave it.", stored_in(&Scene::motion, &MotionSpec::within_lift)}),
        called("no reversal within a stroke", {"motion", "monotone", boolean, plain, any, {}, "false",
         "A rise only rises, a return only falls: the velocity never changes its sign within a stroke.",
         stored_in(&Scene::motion, &MotionSpec::monotone)}),
        {"motion", "via", tables, plain, any, {}, "none",
         "Points the curve meets exactly, and regions of constant velocity, one table each.",
         stored_in(&Scene::motion, &MotionSpec::via)},
        {"motion", "segments", tables, plain, any, {}, "none",
         "The segments of a program, one table each, from displacement 0 on.", segments_place()},
        called("closed after one revolution", {"motion", "closed", boolean_or_text, plain, any, {"relative"}, "true",
         "The program is one revolution: its angles add up to 360 deg and it ends at displacement 0. "
         "`\"relative\"`: one revolution that goes on in the next one from the displacement it has reached. "
         "`false`: a part of a revolution.", closed_place()}),
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
        called("cam angle", {"motion.segments", "angle", number_or_range, cam_angle, within_turn, {}, "required",
         "Cam angle of the segment; a range is searched, and the angles still add up to 360 deg (closed programs, "
         "two ranges or more).", segment_angle_place()}),
        {"motion.segments", "law", text, plain, any, {}, "none",
         "A law of the catalogue, with other numbers in brackets (`modified_sine(0.2)`); kind `\"law\"` only, and needed there.",
         stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::law)},
        called("displacement at its end", {"motion.segments", "to", number, displacement, any, {}, "free",
         "Displacement at its end, in lifts or in a unit of the lift; not for dwells. Free: the optimizer "
         "chooses it, and the peaks are measured by what it finds; but the last one of a closed program is 0.",
         segment_to_place()}),
        {"motion.segments", "end", table, plain, any, {}, "free",
         "State at the joint of two segments of kind `\"spline\"`: `{ velocity = 0 }` is a turning point without a "
         "dwell.", stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::end)},
        {"motion.segments", "via", tables, plain, any, {}, "none",
         "Set points and regions of a segment of kind `\"spline\"`, as `motion.via`, counted from its start.",
         stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::via)},
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

// clang-format on

}  // namespace

// clang-format off
Rows other_tables() {
    return {
        called("sense of rotation", {"cam", "rotation", text, plain, any, {"counterclockwise", "clockwise"}, "\"counterclockwise\"",
         "The sense in which the cam turns.", stored_in(&Scene::cam, &CamSpec::rotation)}),
        {"cam", "piece", tables, plain, any, {}, "none",
         "Of a cam that exists (`measured.use = \"given\"`): the lines and arcs of the path of its roller's centre, in "
         "the cam's frame, in order.", stored_in(&Scene::cam, &CamSpec::pieces)},
        {"cam.piece", "to", numbers, length, any, {}, "required", "x and y of its end.", of_piece(&CamPiece::to)},
        {"cam.piece", "center", numbers, length, any, {}, "a line",
         "Of an arc, the shorter one: x and y of its centre.", of_piece(&CamPiece::center)},
        {"cam.piece", "from", numbers, length, any, {}, "the end of the last piece",
         "Of the first piece: where it begins.", of_piece(&CamPiece::from)},
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
    return joined(top_level(), motion(), points_of_motion(), valve_ramp("motion.opening_ramp"),
                  valve_ramp("motion.closing_ramp"), points_of_segments());
}

}  // namespace camopt::key_rows

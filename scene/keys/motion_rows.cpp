// SPDX-License-Identifier: MIT
// The rows of [motion] and [measured].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;

const Range within_turn = Range::above_up_to(0.0, 360.0);
const Range within_phase{.low = -360.0, .high = 360.0, .low_included = false, .high_included = false};

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
        {"", "cam", table, plain, any, {}, "no cam", "The cam and its follower."},
    };
}

Rows motion() {
    return {
        {"motion", "type", text, plain, any, {"DRD", "RR", "program", "valve"}, "required",
         "`\"DRD\"`: rise between two dwells. `\"RR\"`: rise and return without a dwell at the top. "
         "`\"program\"`: the segments of one revolution, without `rise`, `return`, `symmetric` and `via` outside "
         "them; each segment may have its own `via`. `\"valve\"`: a valve lobe."},
        {"motion", "lift", number, lift, positive, {}, "1 mm",
         "Lift of the follower; an angle for a swinging or indexing output. Of type `\"valve\"` the lift of the valve "
         "at the nose, needed.",
         KeyPlace{.value = [](const Scene& scene) -> std::optional<KeyValue> { return scene.motion.lift; }}},
        {"motion", "rise", number, cam_angle, within_turn, {}, "180 deg", "Cam angle of the rise.",
         stored_in(&Scene::motion, &MotionSpec::rise)},
        {"motion", "return", number, cam_angle, within_turn, {}, "the rise",
         "Cam angle of the return, RR only; rise and return together at most 360 deg.",
         stored_in(&Scene::motion, &MotionSpec::return_angle)},
        {"motion", "speed", number, speed, positive, {}, "none",
         "Speed of the cam; only limits and outputs in time need it.", stored_in(&Scene::motion, &MotionSpec::speed)},
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
         "Points the curve meets exactly, and regions of constant velocity, one table each."},
        {"motion", "segments", tables, plain, any, {}, "none",
         "The segments of a program, one table each, from displacement 0 on."},
        {"motion", "closed", boolean_or_text, plain, any, {"relative"}, "true",
         "The program is one revolution: its angles add up to 360 deg and it ends at displacement 0. "
         "`\"relative\"`: one revolution that goes on in the next one from the displacement it has reached. "
         "`false`: a part of a revolution."},
        {"motion", "repeat", integer, plain, Range::between(1, 1000), {}, "1",
         "Of a closed program: the segments fill so many equal parts of the revolution, each with the same motion.",
         stored_in(&Scene::motion, &MotionSpec::repeat)},
        {"motion", "stops", integer, plain, Range::between(1, 10000), {}, "none",
         "Of an indexing output: the lift is 360 deg divided by this.", {}, Availability::now, "lift"},
        {"motion", "phase", number, cam_angle, within_phase, {}, "0",
         "Of a program of one revolution: the angle of the master at which the motion begins. Motion tables, tables of "
         "controllers and reports are by the master's angle; a machine sets it.",
         stored_in(&Scene::motion, &MotionSpec::phase)},
        {"motion", "start", table, plain, any, {}, "at rest",
         "State at the start of a motion that is not closed; what is not given is 0."},
        {"motion", "end", table, plain, any, {}, "at rest",
         "State at its end, after the last segment of a program."},
        {"motion", "corridor", tables, plain, any, {}, "none",
         "Inequalities on a stretch of the cam angle, one table each."},
        {"motion", "duration", number, cam_angle, within_turn, {}, "needed by a valve",
         "Type `\"valve\"`: between the two angles at which the valve has lifted `checking_height`."},
        {"motion", "checking_height", number, length, positive, {}, "needed by a valve",
         "Type `\"valve\"`: lift of the valve at which the duration is measured."},
        {"motion", "lash", number, length, not_negative, {}, "0", "Type `\"valve\"`: clearance, at the valve."},
        {"motion", "rocker_ratio", number, plain, positive, {}, "1",
         "Type `\"valve\"`: valve travel by follower travel."},
        {"motion", "valve_arm", number, length, positive, {}, "none",
         "Type `\"valve\"` with an oscillating (finger) follower: valve travel by radian of the follower.",
         {}, Availability::now, "rocker_ratio"},
        {"motion", "opening", number, cam_angle, within_turn, {}, "half the duration",
         "Type `\"valve\"`: the part of the duration before the nose."},
        {"motion", "centerline", number, cam_angle, any, {}, "none",
         "Type `\"valve\"`: of the nose after top dead centre, negative before it (exhaust); events alone use it."},
        {"motion", "engine_speed", number, speed, positive, {}, "none",
         "Type `\"valve\"`: twice the cam's speed.", {}, Availability::now, "speed"},
        {"motion", "opening_ramp", table, plain, any, {}, "needed by a valve",
         "Type `\"valve\"`: from the base circle smoothly to a constant velocity, and on to the opening flank."},
        {"motion", "closing_ramp", table, plain, any, {}, "as the opening ramp",
         "Type `\"valve\"`: from the closing flank to the base circle."},
        {"motion.segments", "kind", text, plain, any, {"dwell", "law", "spline"}, "required",
         "`\"dwell\"` keeps the displacement, `\"law\"` is a classical law, `\"spline\"` is optimised."},
        {"motion.segments", "angle", number_or_range, cam_angle, within_turn, {}, "required",
         "Cam angle of the segment; a range is searched, and the angles still add up to 360 deg (closed programs, "
         "two ranges or more)."},
        {"motion.segments", "law", text, plain, any, {}, "none",
         "A law of the catalogue; kind `\"law\"` only, and needed there."},
        {"motion.segments", "to", number, displacement, any, {}, "free",
         "Displacement at its end, in lifts or in a unit of the lift; not for dwells. Free: the optimizer "
         "chooses it, and the peaks are measured by what it finds; but the last one of a closed program is 0."},
        {"motion.segments", "end", table, plain, any, {}, "free",
         "State at the joint of two segments of kind `\"spline\"`: `{ velocity = 0 }` is a turning point without a "
         "dwell."},
        {"motion.segments", "via", tables, plain, any, {}, "none",
         "Set points and regions of a segment of kind `\"spline\"`, as `motion.via`, counted from its start."},
    };
}

/// Set points of the whole motion, or of a segment: `unit` is that of their locations.
Rows set_points(const char* table, const char* unit) {
    static const std::string in_rise = "Where, in units of the rise (DRD 0 to 1, RR 0 to 1 + return/rise) or as "
                                       "a cam angle.";
    static const std::string in_segment = "Where, in units of the segment (0 to 1) or as a cam angle from its "
                                          "start.";
    const bool whole = std::string_view(unit) == "rise";
    return {
        {table, "at", number, place, not_negative, {}, "needed by a point",
         whole ? in_rise : in_segment},
        {table, "from", number, place, not_negative, {}, "needed by a region",
         "Where a region begins, in the units of `at`. Its `velocity` holds exactly from here to its end, and "
         "both are breakpoints of the spline.", {}, Availability::now, "at"},
        {table, "to", number, place, not_negative, {}, "needed by a region",
         "Where the region ends.", {}, Availability::now, "at"},
        {table, "displacement", number, spellings::displacement, any, {}, "free",
         "There; of a region where it begins. In lifts (s/lift) or in a unit of the lift."},
        {table, "velocity", number, spellings::velocity, any, {}, "free",
         whole ? "There, or all along the region: dy/dx, by the cam angle, or in time (needs a speed)."
               : "There, or all along the region: lifts per segment, by the cam angle, or in time (needs a "
                 "speed)."},
        {table, "acceleration", number, spellings::acceleration, any, {}, "free",
         whole ? "There: d²y/dx², by the cam angle, or in time; not in a region, where it is 0."
               : "There: lifts per segment squared, by the cam angle, or in time; not in a region, where it is "
                 "0."},
    };
}

/// Velocity and acceleration at an end of the motion, or of a segment.
Rows end_state(const char* table) {
    const bool joint = std::string_view(table) == "motion.segments.end";
    const char* const otherwise = joint ? "free" : "0";
    return {
        {table, "velocity", number, spellings::velocity, any, {}, otherwise,
         joint ? "There: lifts per segment, by the cam angle, or in time (needs a speed)."
               : "There: dy/dx (programs: lifts per segment), by the cam angle, or in time (needs a speed)."},
        {table, "acceleration", number, spellings::acceleration, any, {}, otherwise, "There, likewise."},
    };
}

/// A ramp of a valve lobe.
Rows valve_ramp(const char* table) {
    const bool opening = std::string_view(table) == "motion.opening_ramp";
    return {
        {table, "height", number, lift, positive, {}, "required",
         "Of the follower above the base circle, where the ramp meets the flank."},
        {table, "velocity", number, ramp_velocity, positive, {}, "required",
         "Of the follower by the cam angle, constant over the last two thirds of the height."},
        {table, "end", number, cam_angle, positive, {}, "by half of a typical flank",
         opening ? "Where the ramp ends, before the opening checking point; only where that point, at the follower "
                   "displacement s, is above the ramp."
                 : "Where the ramp begins, after the closing checking point, likewise."},
    };
}

Rows corridor() {
    constexpr const char* table = "motion.corridor";
    return {
        {table, "from", number, angle, not_negative, {}, "0 deg",
         "Where it begins, counted from the start of the motion; it holds there too."},
        {table, "to", number, angle, positive, {}, "the end", "Where it ends; it holds there too."},
        {table, "displacement", bounds, spellings::displacement, any, {}, "none",
         "Bounds of the displacement, in lifts or in a unit of the lift."},
        {table, "velocity", bounds, spellings::velocity, any, {}, "none",
         "Bounds of the velocity: dy/dx (programs: x = 1 is the first spline segment), by the cam angle, or in "
         "time."},
        {table, "acceleration", bounds, spellings::acceleration, any, {}, "none",
         "Bounds of the acceleration, likewise."},
        {table, "jerk", bounds, spellings::jerk, any, {}, "none", "Bounds of the jerk, likewise."},
    };
}

Rows measured() {
    return {
        {"measured", "table", text, plain, any, {}, "none",
         "A CSV file in the scene's folder (or a path from there), also one that camopt wrote. Its first line names "
         "the columns, in any order: `theta_deg`, `theta_rad` or `crank_deg`, the angle, and `s_mm`, `s_in`, `s_m`, "
         "`s_deg` or `s_rad`, or of points of a disk cam `x_mm` and `y_mm`, or `r_mm` (`_in`, `_m`) and the angle; "
         "others are ignored."},
        {"measured", "columns", texts, plain, any, {}, "the file's first line",
         "Names of the columns, in the order of the file: of a file without such a line, or in place of it."},
        {"measured", "decimal", text, plain, any, {".", ","}, "\".\"",
         "Decimal point or comma of the file; with a comma, columns are separated by semicolons or tabs."},
        {"measured", "scale", numbers, plain, any, {}, "1",
         "A number for each column of the file: what one unit of a cell is in the unit that the column's name says."},
        {"measured", "offset", numbers, plain, any, {}, "0",
         "A number for each column, added after `scale`, in the unit that the column's name says."},
        {"measured", "skip_lines", integer, plain, Range::between(0, 10000), {}, "0",
         "Lines at the beginning of the file that are not read. Needed only where they hold numbers: text above the "
         "names, or with `columns` above the first row, is passed over."},
        {"measured", "theta", numbers, cam_angle, any, {}, "none",
         "The angles themselves, ascending or descending.", {}, Availability::now, "table"},
        {"measured", "s", numbers, lift, any, {}, "none", "The displacements at these angles.",
         {}, Availability::now, "table"},
        {"measured", "x", numbers, length, any, {}, "none",
         "With `y`: points of the surface of the disk cam of `[cam]`, which become the motion of its follower. In the "
         "cam's frame: at cam angle 0 a pushed follower rises along +y, the pivot of a swinging one lies on +x.",
         {}, Availability::needs_cam, "table"},
        {"measured", "y", numbers, length, any, {}, "none", "With `x`.", {}, Availability::needs_cam, "table"},
        {"measured", "r", numbers, length, positive, {}, "none",
         "Such points in polar coordinates, with `theta` from +x counterclockwise.", {}, Availability::needs_cam, "table"},
        {"measured", "probe_radius", number, length, not_negative, {}, "0",
         "Points are the centres of a ball of this radius that touches the cam.", {}, Availability::needs_cam},
        {"measured", "step", number, cam_angle, positive, {}, "none",
         "The angle from row to row, from 0 on, of displacements without angles.", {}, Availability::now, "theta"},
        {"measured", "zero", text_or_table, plain, any, {"start", "nose"}, "\"start\"",
         "What angle 0 of the table is: the start of the motion, its nose (the end of the rise; in a program the "
         "middle of its largest displacement), or the cam angle `{ deg = 30 }` of the motion. Rows of one revolution "
         "may begin anywhere."},
        {"measured", "angles", text, plain, any, {"cam", "crank"}, "\"cam\"",
         "`\"crank\"`: `theta` and `step` are crank angles, two for one of the cam."},
        {"measured.zero", "deg", number, degrees, any, {}, "required", "Cam angle from the start of the motion."},
        {"measured", "register", texts, plain, any, {"angle", "radius"}, "nothing",
         "What is not known of the table and searched: `\"angle\"`, the angle where the motion starts (instead of "
         "`zero`); `\"radius\"`, the displacement, or the base radius of points, where the motion has 0."},
        {"measured", "outliers", text, plain, any, {"keep", "exclude"}, "\"keep\"",
         "Rows far from their neighbours are named in reports. `\"exclude\"`: they are not used."},
        {"measured", "use", text, plain, any, {"compare", "start", "nearest"}, "\"compare\"",
         "`\"compare\"`: what the optimum gains over it. `\"start\"`: searches begin from it, too. `\"nearest\"`: the "
         "optimum is the motion nearest to its rows (objective.deviation, or deviation_rms by `norm`)."},
        {"measured", "norm", text, plain, any, {"peak", "rms"}, "\"peak\"",
         "Of `\"nearest\"`: the largest deviation, or the root mean square of all."},
        {"measured", "name", text, plain, any, {}, "the file's", "Its name in reports."},
    };
}
// clang-format on

}  // namespace

// clang-format off
Rows other_tables() {
    return {
        {"cam", "rotation", text, plain, any, {"counterclockwise", "clockwise"}, "\"counterclockwise\"",
         "The sense in which the cam turns."},
        {"", "forces", table, plain, any, {}, "no forces",
         "What the follower carries; needs a speed.", stored_in(&Scene::forces), Availability::needs_cam},
        {"", "measured", table, plain, any, {}, "none",
         "A motion that was measured: compared with the optimum, or where searches begin."},
        {"", "dynamics", table, plain, any, {}, "a rigid follower",
         "The elastic follower train between cam and output; needs a speed.", stored_in(&Scene::dynamics)},
        {"", "drive", table, plain, any, {}, "no motor",
         "A motor in place of a cam: a servo axis; needs a speed.", stored_in(&Scene::drive)},
        {"", "limits", table, plain, any, {}, "no limits", "What no curve may exceed."},
        {"", "solver", table, plain, any, {}, "its defaults", "How the optimum is found.", stored_in(&Scene::solver)},
    };
}
// clang-format on

Rows of_motion() {
    return joined({top_level(), motion(), set_points("motion.via", "rise"), end_state("motion.start"),
                   end_state("motion.end"), valve_ramp("motion.opening_ramp"),
                   valve_ramp("motion.closing_ramp"), corridor(),
                   set_points("motion.segments.via", "segment"), end_state("motion.segments.end"),
                   measured()});
}

}  // namespace camopt::key_rows

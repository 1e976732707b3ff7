// SPDX-License-Identifier: MIT
#include "input/keys/scene_keys.hpp"

#include "input/keys/key_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/key_place.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <deque>
#include <mutex>

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

const Range within_turn = Range::above_up_to(0.0, 360.0);
const Range within_phase{.low = -360.0, .high = 360.0, .low_included = false, .high_included = false};

using Rows = std::vector<KeyRow>;

/// From SI to the unit of the spelling: 90 deg, not 90.00000000000001.
Range range_in(Range range, const Spelling& spelling) {
    for (double* bound : {&range.low, &range.high})
        if (std::isfinite(*bound)) *bound = as_written(*bound / spelling.factor);
    return range;
}

// A row is read as a row.
// clang-format off
Rows top_level() {
    return {
        {"", "title", text, plain, any, {}, "empty", "What the scene is; repeated in every output.",
         stored_in(&Scene::title)},
        {"", "motion", table, plain, any, {}, "required", "What must move.",
         stored_in(&Scene::motion)},
        {"", "spline", table, plain, any, {}, "its defaults", "The family of curves that is searched.",
         stored_in(&Scene::spline)},
        {"", "objective", table, plain, any, {}, "needed by a spline",
         "What makes one curve better than another; a program of laws and dwells needs none.",
         stored_in(&Scene::objective)},
        {"", "cam", table, plain, any, {}, "no cam", "The cam and its follower."},
    };
}

Rows other_tables() {
    return {
        {"", "forces", table, plain, any, {}, "no forces",
         "What the follower carries; needs a speed.",
         stored_in(&Scene::forces), Availability::needs_cam},
        {"", "measured", table, plain, any, {}, "none",
         "A motion that was measured: compared with the optimum, or where searches begin."},
        {"", "dynamics", table, plain, any, {}, "a rigid follower",
         "The elastic follower train between cam and output; needs a speed.",
         stored_in(&Scene::dynamics)},
        {"", "drive", table, plain, any, {}, "no motor",
         "A motor in place of a cam: a servo axis; needs a speed.",
         stored_in(&Scene::drive)},
        {"", "limits", table, plain, any, {}, "no limits", "What no curve may exceed."},
        {"", "solver", table, plain, any, {}, "its defaults", "How the optimum is found.",
         stored_in(&Scene::solver)},
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
         "at the nose, needed."},
        {"motion", "rise", number, cam_angle, within_turn, {}, "180 deg", "Cam angle of the rise.",
         stored_in(&Scene::motion, &MotionSpec::rise)},
        {"motion", "return", number, cam_angle, within_turn, {}, "the rise",
         "Cam angle of the return, RR only; rise and return together at most 360 deg.",
         stored_in(&Scene::motion, &MotionSpec::return_angle)},
        {"motion", "speed", number, speed, positive, {}, "none",
         "Speed of the cam; only limits and outputs in time need it.",
         stored_in(&Scene::motion, &MotionSpec::speed)},
        {"motion", "symmetric", boolean, plain, any, {}, "false",
         "Force y(x) + y(1 - x) = 1 (DRD) or y(x) = y(2 - x) (RR with equal angles).",
         stored_in(&Scene::motion, &MotionSpec::symmetric)},
        {"motion", "within_lift", boolean, plain, any, {}, "true",
         "Each stroke stays between the displacements at its ends (set points outside widen the range); false: the "
         "motion may leave it.",
         stored_in(&Scene::motion, &MotionSpec::within_lift)},
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

Rows spline() {
    return {
        {"spline", "degree", integer, plain, any, {"3", "5"}, "3", "Degree of the spline.",
         stored_in(&Scene::spline, &SplineSpec::degree)},
        {"spline", "segments", integer, plain, Range::between(1, 65536), {}, "12",
         "Uniform segments over the rise (DRD), over rise and return (RR), or over each spline segment of a "
         "program. Without the key RR has six over the rise and six over the return.",
         stored_in(&Scene::spline, &SplineSpec::segments)},
        {"spline", "breakpoints", numbers, plain, not_negative, {}, "uniform",
         "The breakpoints themselves, ascending from 0 to the end of the motion, in units of the rise; in a "
         "program from 0 to 1, in units of each spline segment.",
         stored_in(&Scene::spline, &SplineSpec::breakpoints),
         Availability::now, "segments"},
        {"spline", "knots", text, plain, any, {"fixed", "free"}, "\"fixed\"",
         "`\"free\"` makes the interior breakpoints design variables: those of `segments` or `breakpoints` are "
         "where the search starts. DRD and RR, at most 256 segments.",
         KeyPlace{.assign = [](Scene& scene, const KeyValue& value, std::size_t) {
                      scene.spline.free_knots = value == KeyValue("free");
                  },
                  .value = [](const Scene& scene) -> std::optional<KeyValue> {
                      return scene.spline.free_knots ? "free" : "fixed";
                  }}},
        {"spline", "continuity", integer, plain, Range::between(2, 4), {}, "degree - 1",
         "Highest continuous derivative, from 2 to degree - 1.",
         stored_in(&Scene::spline, &SplineSpec::continuity)},
        {"spline", "end_jerk", text, plain, any, {"free", "zero"}, "\"free\"",
         "`\"zero\"`: y''' = 0 at both ends, so that the jerk does not jump at the dwells; degree 5 only.",
         stored_in(&Scene::spline, &SplineSpec::end_jerk)},
        {"spline", "design", text, plain, any, {"auto", "ordinates", "coefficients", "states"}, "\"auto\"",
         "The variables of the search: displacements at the breakpoints (full continuity only), B-spline "
         "coefficients, or displacement and derivatives at the breakpoints.",
         stored_in(&Scene::spline, &SplineSpec::design)},
    };
}

/// In the order of the manual: convex terms before others.
std::vector<const CostTerm*> listed_terms() {
    std::vector<const CostTerm*> terms;
    for (const CostTerm& term : cost_terms()) terms.push_back(&term);
    std::stable_partition(terms.begin(), terms.end(),
                          [](const CostTerm* term) { return term->kind != CostTerm::Kind::torque; });
    return terms;
}

Availability needs_of(const ResponseTerm& term) {
    return term.needs_dynamics() ? Availability::needs_dynamics
           : term.needs_drive()  ? Availability::needs_drive
                                 : Availability::now;
}

Rows objective() {
    Rows rows;
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective", term->name(), number, plain, not_negative, {}, "0", term->weight_meaning,
                        stored_in(&Scene::objective, term->weight)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective", term.name, number, plain, not_negative, {}, "0", term.weight_meaning,
                        stored_in(&Scene::objective, term.weight), needs_of(term)});
    return rows;
}

/// The first is the default.
std::vector<std::string_view> tie_break_words() {
    std::vector<std::string_view> words;
    words.reserve(std::size(tie_breaks));
    for (const TieBreak value : tie_breaks) words.emplace_back(name_of(value));
    return words;
}

/// The name of a law, or a table of numbers.
KeyPlace reference_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, std::size_t) {
                    Reference& reference = scene.objective.reference;
                    reference.numeric = !std::holds_alternative<std::string>(value);
                    if (!reference.numeric) reference.law = std::get<std::string>(value);
                },
            .value = [](const Scene& scene) -> std::optional<KeyValue> {
                const Reference& reference = scene.objective.reference;
                return reference.numeric ? KeyValue() : KeyValue(reference.law);
            }};
}

KeyPlace reference_number(std::optional<double> Reference::*number) {
    return stored_in(&Scene::objective, &ObjectiveSpec::reference, number);
}

Rows reference() {
    static const std::string first_tie_break = fmt::format("\"{}\"", name_of(tie_breaks.front()));
    Rows rows = {
        {"objective", "reference", text_or_table, plain, any, {}, "\"modified_sine\"",
         "What every term is divided by: the peaks of a law of the catalogue, or a table of numbers.",
         reference_place()},
        {"objective", "tie_break", text, plain, any, tie_break_words(), first_tie_break,
         "Among curves equally good within the tolerance take the one of least ∫ y'''²; `\"none\"` keeps "
         "the solver's point.",
         stored_in(&Scene::objective, &ObjectiveSpec::tie_break)},
    };
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective.reference", term->name(), number, plain, positive, {}, "none",
                        term->reference_meaning, reference_number(term->reference)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective.reference", term.name, number, plain, positive, {}, "none",
                        term.reference_meaning, reference_number(term.reference), needs_of(term)});
    return rows;
}

Rows limits() {
    Rows rows;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.side == 0)
            rows.push_back({"limits", row.name(), number_or_bounds, row.spellings, any, {}, "none", row.meaning});
    for (const LimitRow& row : limit_rows()) {
        if (row.side != nullptr) continue;
        const Availability needs = row.needs_dynamics ? Availability::needs_dynamics
                                   : row.needs_drive  ? Availability::needs_drive
                                   : row.needs_forces ? Availability::needs_forces
                                                      : Availability::needs_cam;
        const KeyType type = row.figure == LimitedFigure::motor_torque ? number_or_bounds : number;
        rows.push_back({"limits", row.name, type, row.spellings, type == number ? range_in(row.range, row.spellings.front()) : any,
                        {}, row.default_text, row.meaning, {}, needs});
        if (const LimitRow::Swinging& swinging = row.swinging; swinging.name != nullptr)
            rows.push_back({"limits", swinging.name, number, swinging.spellings,
                            range_in(row.range, swinging.spellings.front()), {}, row.default_text,
                            swinging.meaning, {}, needs, row.name});
    }
    rows.push_back({"limits", "motor_curve", points, plain, any, {}, "none",
                    "The torque-speed curve of the motor: pairs of a speed in rpm, from 0 on, and the largest "
                    "magnitude of the torque there in N m. Linear between them, concave and never rising; the last "
                    "speed is the largest.", {}, Availability::needs_drive});
    rows.push_back({"limits", "spring_harmonics", number_or_range, plain, Range::between(1, most_harmonic), {},
                    "the nearest 3", "The harmonics that `spring_harmonic` holds for: one, or a range `{ min, max }`. "
                    "Default: the nearest to `forces.spring_frequency`, and one to either side.",
                    {}, Availability::needs_forces});
    return rows;
}

Rows solver() {
    return {
        {"solver", "name", text, plain, any, {}, "\"auto\"",
         "`\"auto\"` or a solver of `camopt list solvers`.",
         stored_in(&Scene::solver, &SolverSpec::name)},
        {"solver", "tolerance", number, plain, Range::between(1e-12, 1e-2), {}, "1e-9",
         "Feasibility and optimality of the solve, relative.",
         stored_in(&Scene::solver, &SolverSpec::tolerance)},
        {"solver", "gap", number, plain, Range::between(1e-12, 1e-2), {}, "1e-7 where convex, 1e-4 otherwise",
         "Proved relative gap below which the verdict is optimal.",
         stored_in(&Scene::solver, &SolverSpec::gap)},
        {"solver", "max_seconds", number, plain, positive, {}, "60",
         "Wall time of search, proof, tie-break and explanation together; then the best motion so far is returned.",
         stored_in(&Scene::solver, &SolverSpec::max_seconds)},
        {"solver", "explain_seconds", number, plain, not_negative, {}, "5",
         "Part of this time: for the search for changes that make an infeasible scene feasible.",
         stored_in(&Scene::solver, &SolverSpec::explain_seconds)},
        {"solver", "explain_changes", integer, plain, Range::between(1, 1000), {}, "3",
         "That search ends as soon as it has found so many useful changes.",
         stored_in(&Scene::solver, &SolverSpec::explain_changes)},
        {"solver", "starts", integer, plain, Range::between(1, 100000), {}, "1 where convex, 8 otherwise",
         "Starting points; a convex scene needs one.",
         stored_in(&Scene::solver, &SolverSpec::starts)},
        {"solver", "seed", integer, plain, Range::between(0, 4294967295), {}, "0",
         "Seed of the random starting points.",
         stored_in(&Scene::solver, &SolverSpec::seed)},
        {"solver", "options", options, plain, any, {}, "none",
         "The solver's own options: any names, values are text, numbers, true or false."},
    };
}
// clang-format on

/// The rows, and the texts that were joined for them.
struct KeyTable {
    Rows rows;
    std::deque<std::string> texts;

    /// After the others of its table, so that a table is listed once.
    void add(const KeyRow& row) {
        const auto last = std::find_if(rows.rbegin(), rows.rend(),
                                       [&](const KeyRow& other) { return other.table == row.table; });
        rows.insert(last == rows.rend() ? rows.end() : last.base(), row);
    }
    void add(const Rows& all) {
        for (const KeyRow& row : all) add(row);
    }
    /// Joined with that of an earlier kind, where there is one.
    void add_of_kind(const KeyRow& row) {
        const auto same = std::ranges::find_if(
            rows, [&](const KeyRow& other) { return other.table == row.table && other.name == row.name; });
        if (same == rows.end()) return add(row);
        if (same->meaning != row.meaning)
            same->meaning = texts.emplace_back(fmt::format("{} {}", same->meaning, row.meaning));
        constexpr std::string_view needed = "required for ";
        if (same->default_text != row.default_text && same->default_text.starts_with(needed) &&
            row.default_text.starts_with(needed))
            same->default_text = texts.emplace_back(
                fmt::format("{}, {}", same->default_text, row.default_text.substr(needed.size())));
    }
};

/// What chooses a kind: in the order of the manual.
KeyRow type_row(KeyTable& table) {
    std::string spoken;
    for (const CamKind& kind : cam_kinds())
        spoken +=
            fmt::format("{}{}", spoken.empty() ? "" : ", ", kind.spoken.empty() ? kind.type : kind.spoken);
    return {"cam",      "type",
            text,       plain,
            any,        cam_types(),
            "required", table.texts.emplace_back(fmt::format("The kind of cam: {}.", spoken))};
}

/// What a key may say that chooses within a kind.
void add_words_of_variants(Rows& rows) {
    for (const CamKind& kind : cam_kinds())
        for (KeyRow& row : rows) {
            if (kind.choosing_key != row.name || kind.choosing_table != row.table) continue;
            for (const CamVariant& variant : kind.variants)
                if (std::ranges::find(row.choices, variant.word) == row.choices.end())
                    row.choices.emplace_back(variant.word);
        }
}

/// Empty if it belongs to no kind, or to all.
std::vector<std::string_view> kinds_that_know(const KeyRow& row) {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.knows(row.table, row.name)) types.emplace_back(kind.type);
    if (types.size() == cam_kinds().size()) types.clear();
    return types;
}

KeyTable all_rows() {
    KeyTable all;
    for (const Rows& part :
         {top_level(), motion(), set_points("motion.via", "rise"), end_state("motion.start"),
          end_state("motion.end"), valve_ramp("motion.opening_ramp"), valve_ramp("motion.closing_ramp"),
          corridor(), set_points("motion.segments.via", "segment"), end_state("motion.segments.end"),
          measured(), spline(), objective(), dimension_weight_rows(), reference()})
        all.add(part);
    all.add(type_row(all));
    for (const CamKind& kind : cam_kinds())
        for (const KeyRow& row : kind.rows) all.add_of_kind(row);
    for (const Rows& part :
         {rotation_rows(), other_tables(), force_rows(), dynamics_rows(), drive_rows(), limits(), solver()})
        all.add(part);
    add_words_of_variants(all.rows);
    for (KeyRow& row : all.rows) row.cam_types = kinds_that_know(row);
    return all;
}

}  // namespace

std::string_view motion_types_of(std::string_view key, std::string_view type) {
    constexpr std::string_view not_valve = "other types; a valve lobe is said by lift, duration and ramps";
    struct Only {
        std::vector<std::string_view> keys, types;
        std::string_view words;
    };
    static const std::vector<Only> table = {
        {{"rocker_ratio", "valve_arm", "lash", "checking_height", "duration", "opening", "centerline",
          "opening_ramp", "closing_ramp"},
         {"valve"},
         "type \"valve\""},
        {{"rise", "return", "segments", "closed", "repeat", "stops", "start", "end", "symmetric", "monotone",
          "within_lift", "via"},
         {"DRD", "RR", "program"},
         not_valve},
        {{"segments", "closed", "repeat"}, {"program"}, "type \"program\""},
        {{"phase"}, {"program", "valve"}, "type \"program\" or \"valve\""},
        {{"rise", "return"},
         {"DRD", "RR"},
         "type \"DRD\" or \"RR\"; a program says the angle of each of its segments"},
        {{"symmetric"}, {"DRD", "RR"}, "type \"DRD\" or \"RR\""},
        {{"via"},
         {"DRD", "RR"},
         "type \"DRD\" or \"RR\"; a program has set points in its segments, via in each"}};
    for (const auto& [keys, types, words] : table)
        if (std::ranges::find(keys, key) != keys.end() && std::ranges::find(types, type) == types.end())
            return words;
    return {};
}

const std::vector<KeyRow>& scene_keys() {
    // A program may add kinds: one table per number of kinds, so that returned rows remain valid.
    static std::mutex mutex;
    static std::map<std::size_t, KeyTable> tables;
    const std::lock_guard lock(mutex);
    const auto [table, fresh] = tables.try_emplace(cam_kinds().size());
    if (fresh) table->second = all_rows();
    return table->second.rows;
}

}  // namespace camopt::input

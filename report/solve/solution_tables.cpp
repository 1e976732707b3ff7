// SPDX-License-Identifier: MIT
#include "report/solve/solution_tables.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "report/view/peak_comparison.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr int peak_digits = 5;
constexpr double nothing = 1e-12;    // in lifts: what is left of a zero
constexpr int set_point_digits = 9;  // enough to see that it is met

Field angle_field(std::string key, std::string title = "at (deg)") {
    return {std::move(key), std::move(title), degrees_shown};
}

Cell angle_cell(const Solution& solution, double x) {
    return {solution.scene.motion.master_angle(x), angle_digits};
}

/// In the unit that it is written in.
Cell written_cell(double value, const std::string& unit, int digits = 6) {
    return {value, ShownUnit(unit), digits};
}

/// What "verified" says, and what is not.
std::string verification_words(const std::vector<ConstraintReport>& limits) {
    const auto verified = [](const ConstraintReport& row) { return row.verified; };
    std::string text;
    if (std::ranges::any_of(limits, verified))
        text +=
            "Verified: along all of the motion, enclosed by interval arithmetic where no exact formula "
            "gives the largest value; the limits hold between samples too.";
    if (!std::ranges::all_of(limits, verified))
        text += std::string(text.empty() ? "" : " ") +
                "Limits that are not verified were sampled at closely spaced angles.";
    return text;
}

constexpr const char* peak_note =
    "Peaks are exact, not sampled. Normalised: by lift and rise angle, of a program by angle and "
    "displacement "
    "of each stroke, its splines from rest to rest (by the lift where that is 0 or free); those of the whole "
    "motion include the law segments.";
constexpr const char* motion_peak_note =
    "Peaks are exact, not sampled. Normalised: by the lift and the angle of the first spline "
    "(objective.peaks = \"motion\").";
constexpr const char* prescribed_peak_note =
    "Peaks are exact, not sampled. Normalised: by each law's own angle and displacement.";

/// What stands in the column of the curve of least objective; empty where there is none.
std::string any_curve_note(const Solution& solution) {
    if (!solution.any_curve_limit || !solution.segments.empty()) return {};
    return fmt::format(
        " Curve of least objective: its peaks, spline or not{}. They are no bound of a single peak: another "
        "curve may have one of them smaller.",
        left_out_of_any_curve(solution.scene));
}

/// What is allowed: "30 deg".
std::string limit_text(const ConstraintReport& row) {
    return ShownUnit{row.unit}.text(row.limit);
}

/// "active", "not active", "violated".
const char* standing_words(const Solution& solution, const ConstraintReport& row) {
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    const bool violated = solution.certificate.verdict == Verdict::infeasible &&
                          !(limit_excess(row) <= active_limit * limit_scale(solution.scene, cam, row));
    return violated ? "violated" : row.active ? "active" : "not active";
}

/// "29.8 deg on the outer flank", "undercut, no contact", "nowhere concave".
std::string reached_text(const ConstraintReport& row) {
    if (row.no_contact) return no_contact_words;
    if (is_nowhere(row))
        return row.name == limit_row(LimitedFigure::concave_radius).name ? "nowhere concave"
                                                                         : "nowhere convex";
    return ShownUnit{row.unit}.text(row.worst) + (row.side.empty() ? "" : " on the " + row.side) +
           (row.speed.empty() ? "" : " " + row.speed);
}

/// Whether it is given, chosen or follows.
Table dimension_table(const Solution& solution) {
    const CamSpec& spec = solution.scene.cam.value();
    Table table{"dimensions",
                "Dimensions",
                {{.key = "dimension", .left = true}, {"value"}, {.key = "origin", .left = true}},
                {},
                cam_text(spec) + "."};
    for (const DimensionValue& dimension : cam_dimensions(solution)) {
        const auto found = std::ranges::find(spec.dimensions, dimension.name, &CamDimension::name);
        const bool of_spring = dimension.name == "preload" || dimension.name == "spring_rate";
        const bool own = found != spec.dimensions.end();
        const bool chosen = of_spring || (own && found->value.is_variable());
        table.rows.push_back({words_of(dimension.name), dimension.text,
                              chosen ? "chosen by the optimizer"
                              : own  ? "given"
                                     : "follows"});
    }
    return table;
}

}  // namespace

Table change_table(const Solution& solution) {
    Table table{
        "changes",
        "Suggested changes",
        {{"key", "limit or dimension", {}, true}, {"given"}, {"needed", "needed, if nothing else changes"}},
        {},
        "Each number is rounded to the feasible side and was tried in the scene: a solve found a "
        "motion with it. Where it says \"at most\" or \"at least\", a smaller change may suffice.",
        Where::reports};
    for (const Relaxation& row : solution.relaxation) {
        const char* const side = is_exact(solution, row)  ? ""
                                 : row.needed > row.given ? "at most "
                                                          : "at least ";
        table.rows.push_back({row.key, Cell(row.given),
                              row.needed      ? side + needed_number(row) + also_words(row)
                              : row.ruled_out ? "proved ineffective"
                                              : "tried without success"});
    }
    return table;
}

Table measured_table(const Solution& solution) {
    Table table{"measured", "Measured motion", {{"fit", "fit of the table", {}, true}, {"value"}}};
    table.where = Where::reports;
    if (!solution.measured) return table;
    const MeasuredReport& measured = *solution.measured;
    const MotionUnit unit = shown_units(solution.scene).motion[0].first;
    table.note = measured_sentence(solution) + ".";
    table.rows = {{"rows", Cell(measured.rows)},
                  {"free numbers", Cell(measured.freedom)},
                  {"largest error", motion_cell(unit, measured.largest_error, 3)},
                  {"at", Cell(solution.scene.motion.master_angle(measured.at), degrees_shown)},
                  {"rms error", motion_cell(unit, measured.rms_error, 3)}};
    if (measured.noise) table.rows.push_back({"noise of one row", motion_cell(unit, measured.noise->row, 3)});
    for (std::size_t order = 0; measured.noise && order < measured.noise->error.size(); ++order)
        table.rows.push_back(
            {fmt::format("standard error of the {}", derivative_names[order]),
             motion_cell(shown_units(solution.scene).motion[order].first, measured.noise->error[order], 2)});
    return table;
}

Table peak_table(const Solution& solution) {
    const ReferenceMotion reference = reference_motion(solution.scene);
    const bool program = !solution.segments.empty(), prescribed = solution.scene.motion.prescribed();
    const bool of_motion = program && solution.scene.objective.peaks == PeakScope::motion;
    Table table{"peaks",
                "Peaks",
                {{.key = "peak", .left = true},
                 {program ? "whole_motion" : "value"},
                 {"by_the_cam_angle"},
                 angle_field("whole_motion_at"),
                 {!program     ? "normalised"
                  : prescribed ? "laws"
                               : "spline_segments"},
                 angle_field("at"),
                 {"reference", reference_title(reference)},
                 {"change"},
                 {.key = "curve_of_least_objective", .where = Where::reports},
                 {.key = "peak_of_the_other_sign", .where = Where::reports}},
                {},
                of_motion    ? motion_peak_note
                : prescribed ? prescribed_peak_note
                             : peak_note + any_curve_note(solution)};
    table.note_where = Where::reports;
    for (const PeakRow& row : peak_comparison(solution, reference)) {
        std::vector<Cell>& cells = table.rows.emplace_back(table.columns.size());
        cells[0] = fmt::format("{} {}", row.name, row.symbol);
        if (row.shown) {
            cells[1] = motion_cell(row.shown->first, row.sides.largest.value);
            if (row.shown->beside) cells[2] = motion_cell(*row.shown->beside, row.sides.largest.value);
            if (program) cells[3] = angle_cell(solution, row.motion.at);
            if (const std::optional<Extremum>& opposite = row.sides.opposite)
                cells[9] = fmt::format("{} at {} deg", row.shown->first.normalised_text(opposite->value),
                                       degrees_at(solution, opposite->at));
        }
        cells[4] = Cell(row.optimum.value);
        cells[5] = angle_cell(solution, row.optimum.at);
        cells[6] = Cell(row.reference);
        if (row.reference) cells[7] = row.change();
        if (!program) cells[8] = Cell(row.any_curve);
    }
    return table;
}

Table segment_table(const Solution& solution) {
    const MotionUnit displacement = shown_units(solution.scene).motion[0].first;
    const ShownUnit& length = displacement;
    const MotionSpec& motion = solution.scene.motion;
    Table table{"segments",
                "Segments",
                {{.key = "segment", .left = true},
                 angle_field("start", "start deg"),
                 angle_field("end", "end deg"),
                 angle_field("angle", "angle deg"),
                 {"from", {}, length},
                 {"to", {}, length},
                 {"V"},
                 {"A"},
                 {"J"},
                 {"joint"}},
                {},
                fmt::format("V, A, J: {}. Joint: the highest derivative that is continuous where the segment "
                            "begins, 3 at most.",
                            solution.scene.objective.peaks == PeakScope::motion
                                ? "by the lift and the angle of the first spline"
                                : "by angle and displacement of the stroke, a free one by the lift")};
    const auto place = [&](double y) { return Cell(std::abs(y) < nothing ? 0.0 : displacement.si(y)); };
    for (const SegmentReport& segment : solution.segments) {
        std::vector<Cell>& row = table.rows.emplace_back();
        row = {fmt::format("{} {}", table.rows.size(), segment_title(segment)),
               Cell(motion.master_angle(segment.begin)),
               Cell(motion.master_angle(segment.end)),
               Cell((segment.end - segment.begin) * motion.unit_angle()),
               place(segment.from),
               place(segment.to)};
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
            row.push_back(segment.peaks ? Cell(((*segment.peaks).*peak).value, peak_digits) : Cell());
        row.emplace_back(segment.continuity < 0 ? "open" : fmt::format("C{}", segment.continuity));
    }
    return table;
}

Table limit_table(const Solution& solution) {
    Table table{"limits",
                "Limits",
                {{.key = "limit", .left = true},
                 {.key = "key", .left = true},
                 {"allowed"},
                 {"reached"},
                 angle_field("at"),
                 {.key = "state", .left = true}},
                {},
                verification_words(solution.constraints)};
    table.note_where = Where::reports;
    const bool made = solution.scene.tolerance.has_value();
    if (made) table.columns.insert(table.columns.begin() + 4, {.key = "made"});
    for (const ConstraintReport& row : solution.constraints) {
        table.rows.push_back(
            {key_words(row.key).words, row.key, written_cell(row.limit, row.unit),
             written_cell(row.worst, row.unit).in_words(reached_text(row)),
             is_nowhere(row) ? Cell() : angle_cell(solution, row.at),
             fmt::format("{}{}", standing_words(solution, row), row.verified ? "; verified" : "")});
        std::vector<Cell>& cells = table.rows.back();
        if (made) cells.insert(cells.begin() + 4, row.made ? written_cell(*row.made, row.unit) : Cell());
    }
    return table;
}

std::string active_sentence(const Solution& solution) {
    std::vector<std::string> active;
    for (const ConstraintReport& row : solution.constraints)
        if (row.active)
            active.push_back(fmt::format("{} ({} at {} deg)", key_words(row.key).words, limit_text(row),
                                         degrees_at(solution, row.at)));
    if (solution.constraints.empty()) return "The scene sets no limits.";
    if (active.empty()) return "Every limit is satisfied with a margin: none is active.";
    return fmt::format("Active: {}. Relaxing these limits would improve the motion.",
                       fmt::join(active, "; "));
}

Table set_point_table(const Solution& solution) {
    Table table{"set_points",
                "Set points",
                {{.key = "set_point", .left = true}, angle_field("at"), {"wanted"}, {"found"}}};
    const double unit_angle = solution.scene.motion.unit_angle();
    for (const SetPointReport& report :
         set_point_reports(solution.scene.motion, solution.scene.spline.degree, solution.output_motion())) {
        const bool along = report.point.is_region() && report.order > 0;
        Cell at(report.point.begin * unit_angle);
        if (along)
            at.words = fmt::format("{} to {}", short_text(degrees_shown.of(report.point.begin * unit_angle)),
                                   short_text(degrees_shown.of(report.point.end * unit_angle)));
        table.rows.push_back({key_words(report.key).words, std::move(at),
                              written_cell(report.wanted, report.unit),
                              written_cell(report.found, report.unit, set_point_digits)});
    }
    return table;
}

Table surge_table(const Solution& solution) {
    Table table{"surge",
                "Spring surge",
                {{"harmonic"},
                 {"amplitude", {}, shown_units(solution.scene).vibration},
                 {"speed", "meets the spring at rpm", rpm_shown},
                 {.key = "remark", .left = true}}};
    table.where = Where::reports;
    if (!solution.surge) return table;
    table.note =
        surge_sentence(solution) + ". Harmonic k excites the spring at k times the speed of the cam.";
    for (const SurgeReport::Harmonic& one : solution.surge->harmonics) {
        const bool none = one.amplitude < nothing * solution.scene.motion.lift;
        const std::string mark = one.limited ? (one.near ? ", limited" : "limited") : "";
        table.rows.push_back({Cell(one.order),
                              {none ? 0.0 : one.amplitude, 4},
                              Cell(one.resonant_speed),
                              (one.near ? "near the spring's frequency" : "") + mark});
    }
    return table;
}

std::vector<Table> cam_tables(const Solution& solution) {
    Table cam{"cam", "The cam", {{.key = "property", .left = true}, {"value"}, angle_field("at")}};
    for (const CamFigure& figure : cam_figures(solution))
        cam.rows.push_back({figure.name, figure.value, figure.degrees});
    Table title{"title_block", "Drawing", {{.key = "field", .left = true}, {"title_block", {}, {}, true}}};
    title.where = Where::reports;
    for (const auto& [label, words] : title_block_words(solution.scene)) title.rows.push_back({label, words});
    return {dimension_table(solution), std::move(cam), std::move(title)};
}

std::vector<std::pair<std::string, std::string>> title_block_words(const Scene& scene) {
    if (!scene.drawing) return {};
    const TitleBlock& block = scene.drawing->title_block;
    std::vector<std::pair<std::string, std::string>> given;
    for (const auto& [label, words] : std::initializer_list<std::pair<const char*, const std::string&>>{
             {"part", block.part},
             {"number", block.number},
             {"revision", block.revision},
             {"date", block.date},
             {"drawn by", block.drawn_by},
             {"organisation", block.organisation},
             {"material", block.material},
             {"tolerances", block.tolerance},
             {"profile tolerance", block.profile_tolerance},
             {"surface finish", block.surface_finish},
             {"bore fit", block.bore_fit},
             {"keyway tolerance", block.keyway_tolerance}})
        if (!words.empty()) given.emplace_back(label, printable(words));
    return given;
}

Table design_table(const DesignReport& design) {
    Table table{"design", {}, {{.key = "name", .left = true}, {"value"}}};
    table.where = Where::markdown;
    for (std::size_t i = 0; i < design.names.size(); ++i)
        table.rows.push_back({design.names[i], round_trip_text(design.values[static_cast<Eigen::Index>(i)])});
    return table;
}

std::string surge_sentence(const Solution& solution) {
    const Scene& scene = solution.scene;
    const ShownUnits shown = shown_units(scene);
    std::string amplitudes;
    for (const SurgeReport::Harmonic& one : solution.surge->harmonics)
        if (one.near)
            append_item(amplitudes,
                        fmt::format("{} ({})", shown.vibration.text(one.amplitude, 4), one.order));
    return fmt::format(
        "natural frequency of the spring {}, {} times the speed of the cam ({}); amplitudes of the harmonics "
        "of the lift near it: {}",
        hertz_shown.text(*scene.forces->spring_frequency), short_text(solution.surge->frequency_ratio, 4),
        rpm_shown.text(*scene.motion.speed), amplitudes);
}

namespace {

constexpr std::size_t most_named = 6;  // outliers; result.json has all

/// Of a table: rows far from their neighbours, points that are not used, and where it was placed.
std::string table_words(const Solution& solution) {
    const Scene& scene = solution.scene;
    const MeasuredMotion& table = *scene.measured;
    const MotionUnit unit = shown_units(scene).motion[0].first;
    const auto shown = [&](double displacement) {
        return unit.normalised_text(displacement / scene.motion.lift, 3);
    };
    std::string text, list;
    if (table.untouched > 0)
        text += fmt::format("; its follower does not touch {} of the points, which are left out",
                            table.untouched);
    for (std::size_t i = 0; i < std::min(table.outliers.size(), most_named); ++i) {
        const MeasuredOutlier& outlier = table.outliers[i];
        append_item(list, fmt::format("row {} at {} deg by {}", outlier.row,
                                      degrees_at(solution, outlier.angle / scene.motion.unit_angle()),
                                      shown(outlier.off)));
    }
    if (table.outliers.size() > most_named)
        list += fmt::format(" and {} more", table.outliers.size() - most_named);
    if (!list.empty())
        text +=
            fmt::format("; outliers ({}): {}",
                        table.excluded ? "excluded" : "kept; outliers = \"exclude\" leaves them out", list);
    if (!table.place) return text;
    const MeasuredPlace& place = *table.place;
    if (place.angle)
        text += fmt::format(
            "; the {} {}{} deg {} the table", place.points ? "cam is turned by" : "motion starts at",
            short_text(degrees_shown.of(place.angle->value)),
            std::isnan(place.angle->error) ? "" : " ± " + short_text(degrees_shown.of(place.angle->error), 2),
            place.points ? "counter-clockwise on" : "of");
    if (place.zero)
        text += fmt::format("; its displacement 0 is at {}{} of the table", shown(place.zero->value),
                            std::isnan(place.zero->error) ? "" : " ± " + shown(place.zero->error));
    if (place.contradicted())
        text += fmt::format(
            "; WARNING: the residuals, {} rms, are {} times the noise of the table: the model does not "
            "describe it, so no standard error is given",
            shown(place.residual), short_text(place.residual / place.noise, 3));
    if (place.base_radius)
        text += fmt::format(", a base radius of {}", shown_units(scene).length.text(*place.base_radius));
    return text + (place.law.empty() ? "" : fmt::format(" (placed by {})", words_of(place.law)));
}

/// Of a cam of lines and arcs: where its acceleration jumps.
std::string jump_words(const Solution& solution) {
    constexpr double rounding = 1e-6;  // of the largest acceleration
    const Motion& motion = *solution.measured->motion;
    const std::vector<double> places = motion.breakpoints();
    std::vector<double> found;
    double largest = 0.0, peak = 0.0;
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        const double before = motion.at(places[i], Side::left).derivative[2],
                     after = motion.at(places[i], Side::right).derivative[2];
        found.push_back(std::abs(before - after));
        largest = std::max(largest, found.back());
        peak = std::max({peak, std::abs(before), std::abs(after)});
    }
    const auto jumps = std::ranges::count_if(found, [&](double jump) { return jump > rounding * peak; });
    if (jumps == 0) return {};
    return fmt::format("; the acceleration jumps at {} joints, by {} at most: the jerk is infinite there",
                       jumps, shown_units(solution.scene).motion[2].first.normalised_text(largest, 4));
}

}  // namespace

std::string measured_sentence(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const MotionUnit unit = shown_units(solution.scene).motion[0].first;
    if (solution.scene.cam && !solution.scene.cam->pieces.empty())
        return fmt::format("{}: {} lines and arcs, followed by a spline to {}{}{}",
                           measured.name.empty() ? "given cam" : printable(measured.name),
                           solution.scene.cam->pieces.size(), unit.normalised_text(measured.largest_error, 3),
                           jump_words(solution), table_words(solution));
    std::string text =
        fmt::format("{}: {} rows as a spline{}, error at most {} (rms {})",
                    measured.name.empty() ? "measured motion" : printable(measured.name), measured.rows,
                    measured.noise ? "" : " of this space", unit.normalised_text(measured.largest_error, 3),
                    unit.normalised_text(measured.rms_error, 3));
    if (measured.noise) {
        const auto& units = shown_units(solution.scene).motion;
        text += fmt::format("; noise of one row {}; standard errors of the motion {}, {}, {}, {}",
                            unit.normalised_text(measured.noise->row, 3),
                            units[0].first.normalised_text(measured.noise->error[0], 2),
                            units[1].first.normalised_text(measured.noise->error[1], 2),
                            units[2].first.normalised_text(measured.noise->error[2], 2),
                            units[3].first.normalised_text(measured.noise->error[3], 2));
    }
    if (!measured.noise && follows_noise(measured))
        text += fmt::format(
            "; with {} free numbers, more than half as many as rows, the spline follows the noise of the "
            "table: fewer spline.segments smooth it",
            measured.freedom);
    if (const std::optional<double> gain = measured.noise ? std::nullopt : gain_percent(solution))
        text +=
            fmt::format("; the optimum's objective is {} % {} than its {}", short_text(std::abs(*gain), 3),
                        *gain < 0.0 ? "more" : "less", short_text(*measured.objective));
    for (const OwnTermReport& term : solution.own_terms) {
        if (!term.of_scene || !term.name.starts_with("deviation")) continue;
        const std::string what = term.name == "deviation" ? "largest deviation" : "rms deviation";
        text +=
            fmt::format("; the motion's {} from the table is {}", what, unit.normalised_text(term.value, 4));
        const Certificate& certificate = solution.certificate;
        const bool alone = certificate.lower_bound && solution.own_terms.size() == 1 &&
                           certificate.verdict == Verdict::optimal;
        if (alone && std::abs(term.weight * term.value / term.reference - certificate.objective) <=
                         1e-9 * certificate.objective)
            text +=
                fmt::format(", and no motion of this spline space within these limits has one below {}",
                            unit.normalised_text(*certificate.lower_bound * term.reference / term.weight, 4));
    }
    for (const LawMatch& match : measured.laws)
        text += fmt::format("; nearest law: {} {}, deviation at most {} (rms {})", match.law,
                            stretch_words(solution.scene.motion, match.begin, match.end),
                            unit.normalised_text(match.largest, 3), unit.normalised_text(match.rms, 3));
    if (measured.started) text += "; the search began from it, too";
    return text + table_words(solution);
}

}  // namespace camopt

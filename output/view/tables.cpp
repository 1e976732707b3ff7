// SPDX-License-Identifier: MIT
#include "output/view/tables.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "output/view/cam_words.hpp"
#include "output/view/key_words.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/view/valve_tables.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int peak_digits = 5;
constexpr double nothing = 1e-12;  // in lifts: what is left of a zero

std::string joint_text(const SegmentReport& segment) {
    return segment.continuity < 0 ? std::string("open") : fmt::format("C{}", segment.continuity);
}

std::string place_text(double displacement, double lift) {
    return short_text(std::abs(displacement) < nothing ? 0.0 : lift * displacement);
}

constexpr int set_point_digits = 9;  // enough to see that it is met

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

/// Whether it is given, chosen or follows.
TextTable dimension_table(const Solution& solution) {
    TextTable table;
    table.columns = {{"dimension", true}, {"value"}, {"", true}};
    const CamSpec& spec = solution.scene.cam.value();
    for (const DimensionValue& dimension : cam_dimensions(solution)) {
        const auto found = std::ranges::find(spec.dimensions, dimension.name, &CamDimension::name);
        const bool given = found != spec.dimensions.end();
        table.rows.push_back({words_of(dimension.name), dimension.text,
                              !given                       ? "follows"
                              : found->value.is_variable() ? "chosen by the optimizer"
                                                           : "given"});
    }
    return table;
}

constexpr const char* peak_note =
    "Peaks are exact, not sampled. Normalised: by lift and rise angle, of a program by each spline segment's "
    "own angle and displacement (the lift where that is free); those of the whole motion include the law "
    "segments.";

/// What stands in the column of the curve of least objective; empty where there is none.
std::string any_curve_note(const Solution& solution) {
    if (!solution.any_curve_limit || !solution.segments.empty()) return {};
    return fmt::format(
        " Curve of least objective: its peaks, spline or not{}. They are no bound of a single peak: another "
        "curve may have one of them smaller.",
        left_out_of_any_curve(solution.scene));
}

TextTable measured_table(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const ShownUnits units = shown_units(solution.scene);
    const MotionUnit& unit = units.motion[0].first;
    return {{{"fit of the table", true}, {"value"}},
            {{"rows", fmt::format("{}", measured.rows)},
             {"free numbers", fmt::format("{}", measured.freedom)},
             {"largest error", unit.normalised_text(measured.largest_error, 3)},
             {"at", units.angle.text(solution.scene.motion.master_angle(measured.at))},
             {"rms error", unit.normalised_text(measured.rms_error, 3)}}};
}

TextTable surge_table(const Solution& solution) {
    const ShownUnits shown = shown_units(solution.scene);
    TextTable table{{{"harmonic"},
                     {fmt::format("amplitude {}", shown.vibration.name)},
                     {"meets the spring at rpm"},
                     {"", true}},
                    {}};
    for (const SurgeReport::Harmonic& one : solution.surge->harmonics) {
        const bool none = one.amplitude < nothing * solution.scene.motion.lift;
        const std::string mark = one.limited ? (one.near ? ", limited" : "limited") : "";
        table.rows.push_back({fmt::format("{}", one.order),
                              short_text(none ? 0.0 : shown.vibration.of(one.amplitude), 4),
                              short_text(rpm_shown.of(one.resonant_speed)),
                              (one.near ? "near the spring's frequency" : "") + mark});
    }
    return table;
}

}  // namespace

std::string segment_title(const SegmentReport& segment) {
    return segment.kind == SegmentKind::law ? words_of(segment.law) : std::string(name_of(segment.kind));
}

TextTable segment_table(const Solution& solution) {
    const ShownUnits shown = shown_units(solution.scene);
    const MotionUnit& displacement = shown.motion[0].first;
    const double lift = displacement.per_normalised;
    TextTable table;
    table.columns = {{"segment", true},
                     {"start deg"},
                     {"end deg"},
                     {"angle deg"},
                     {fmt::format("from {}", displacement.name)},
                     {fmt::format("to {}", displacement.name)},
                     {"V"},
                     {"A"},
                     {"J"},
                     {"joint"}};
    for (std::size_t i = 0; i < solution.segments.size(); ++i) {
        const SegmentReport& segment = solution.segments[i];
        const MotionSpec& motion = solution.scene.motion;
        const double begin = degrees_shown.of(motion.master_angle(segment.begin)),
                     end = degrees_shown.of(motion.master_angle(segment.end));
        std::vector<std::string> row = {fmt::format("{} {}", i + 1, segment_title(segment)),
                                        short_text(begin),
                                        short_text(end),
                                        short_text(shown.degrees_per_x * (segment.end - segment.begin)),
                                        place_text(segment.from, lift),
                                        place_text(segment.to, lift)};
        const std::optional<Peaks>& peaks = segment.peaks;
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
            row.push_back(peaks ? short_text(((*peaks).*peak).value, peak_digits) : "–");
        row.push_back(joint_text(segment));
        table.rows.push_back(std::move(row));
    }
    return table;
}

const char* segment_table_note() {
    return "V, A, J: by the segment's own angle and displacement, a free one by the lift. Joint: the highest "
           "derivative that is continuous where the segment begins, 3 at most.";
}

TextTable set_point_table(const Solution& solution) {
    TextTable table;
    table.columns = {{"set point", true}, {"at (deg)"}, {"wanted"}, {"found"}};
    if (!solution.motion) return table;
    const double degrees_per_x = shown_units(solution.scene).degrees_per_x;
    for (const SetPointReport& report :
         set_point_reports(solution.scene.motion, solution.scene.spline.degree, *solution.motion)) {
        const bool along = report.point.is_region() && report.order > 0;
        const std::string begin = short_text(report.point.begin * degrees_per_x);
        table.rows.push_back(
            {key_words(report.key).words,
             along ? fmt::format("{} to {}", begin, short_text(report.point.end * degrees_per_x)) : begin,
             ShownUnit{report.unit}.text(report.wanted),
             ShownUnit{report.unit}.text(report.found, set_point_digits)});
    }
    return table;
}

bool follows_noise(const MeasuredReport& measured) {
    return measured.rows < 2 * measured.freedom;
}

std::optional<double> gain_percent(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const ObjectiveSpec& objective = solution.scene.objective;
    const bool sought = objective.deviation > 0.0 || objective.deviation_rms > 0.0;
    if (sought || follows_noise(measured) || !measured.objective || !solution.motion ||
        !(*measured.objective > 0.0))
        return {};
    return 100.0 * (1.0 - solution.certificate.objective / *measured.objective);
}

namespace {

constexpr std::size_t most_named = 6;  // outliers; result.json has all

/// Of a table: rows far from their neighbours, points that are not used, and where it was placed.
std::string table_words(const Solution& solution) {
    const Scene& scene = solution.scene;
    const MeasuredMotion& table = *scene.measured;
    const MotionUnit& unit = shown_units(scene).motion[0].first;
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

}  // namespace

std::string measured_sentence(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const MotionUnit& unit = shown_units(solution.scene).motion[0].first;
    std::string text = fmt::format("{}: {} rows as a spline of this space, error at most {} (rms {})",
                                   measured.name.empty() ? "measured motion" : printable(measured.name),
                                   measured.rows, unit.normalised_text(measured.largest_error, 3),
                                   unit.normalised_text(measured.rms_error, 3));
    if (follows_noise(measured))
        text += fmt::format(
            "; with {} free numbers, more than half as many as rows, the spline follows the noise of the "
            "table: fewer spline.segments smooth it",
            measured.freedom);
    if (const std::optional<double> gain = gain_percent(solution))
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

std::string limit_text(const ConstraintReport& row) {
    return ShownUnit{row.unit}.text(row.limit);
}

std::string reached_text(const ConstraintReport& row, int digits) {
    if (row.no_contact) return no_contact_words;
    if (is_nowhere(row))
        return row.name == limit_row(LimitedFigure::concave_radius).name ? "nowhere concave"
                                                                         : "nowhere convex";
    return ShownUnit{row.unit}.text(row.worst, digits) + (row.side.empty() ? "" : " on the " + row.side) +
           (row.speed.empty() ? "" : " " + row.speed);
}

std::string reached_degrees(const Solution& solution, const ConstraintReport& row) {
    return is_nowhere(row) ? "–" : degrees_at(solution, row.at);
}

TextTable peak_table(const Solution& solution) {
    const ReferenceMotion reference = reference_motion(solution.scene);
    const bool program = !solution.segments.empty(), in_time = shown_units(solution.scene).in_time;
    TextTable table{{{"", true}, {program ? "whole motion" : "peak"}}, {}};
    const auto column = [&](std::string title) { table.columns.push_back({std::move(title)}); };
    if (in_time) column("by the cam angle");
    if (program) column("at (deg)");
    column(!program ? "normalised" : solution.scene.motion.prescribed() ? "laws" : "spline segments");
    column("at (deg)");
    column(reference_title(reference));
    column("change");
    if (!program) column("curve of least objective");
    column("peak of the other sign");
    for (const PeakRow& row : peak_comparison(solution, reference)) {
        std::vector<std::string> cells = {fmt::format("{} {}", row.name, row.symbol), row.first_text()};
        if (in_time) cells.push_back(row.beside_text());
        if (program) cells.push_back(row.shown ? degrees_at(solution, row.motion.at) : std::string{});
        cells.push_back(short_text(row.optimum.value));
        cells.push_back(degrees_at(solution, row.optimum.at));
        cells.push_back(short_text(row.reference));
        cells.push_back(row.change());
        if (!program) cells.push_back(short_text(row.any_curve));
        const std::optional<Extremum>& opposite = row.sides.opposite;
        cells.push_back(
            opposite ? fmt::format("{} at {} deg", row.opposite_text(), degrees_at(solution, opposite->at))
                     : std::string{});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

const char* standing_words(const Solution& solution, const ConstraintReport& row) {
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    const bool violated = solution.certificate.verdict == Verdict::infeasible &&
                          !(limit_excess(row) <= active_limit * limit_scale(solution.scene, cam, row));
    return violated ? "violated" : row.active ? "active" : "not active";
}

TextTable limit_table(const Solution& solution) {
    TextTable table{{{"limit", true}, {"key", true}, {"allowed"}, {"reached"}, {"at (deg)"}, {"", true}}, {}};
    for (const ConstraintReport& row : solution.constraints)
        table.rows.push_back(
            {key_words(row.key).words, row.key, limit_text(row), reached_text(row, 6),
             reached_degrees(solution, row),
             std::string(standing_words(solution, row)) + (row.verified ? "; verified" : "")});
    return table;
}

TextTable relaxation_table(const Solution& solution) {
    TextTable table{{{"limit or dimension", true}, {"given"}, {"needed, if nothing else changes"}}, {}};
    for (const Relaxation& row : solution.relaxation) {
        const char* const side = is_exact(solution, row)  ? ""
                                 : row.needed > row.given ? "at most "
                                                          : "at least ";
        table.rows.push_back({row.key, short_text(row.given),
                              row.needed      ? side + needed_number(row) + also_words(row)
                              : row.ruled_out ? "proved ineffective"
                                              : "tried without success"});
    }
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

std::vector<ViewTable> result_tables(const Solution& solution) {
    std::vector<ViewTable> all;
    const auto add = [&](const char* key, const char* title, TextTable table, std::string note = {}) {
        if (!table.rows.empty()) all.push_back({key, title, std::move(table), std::move(note)});
    };
    add("changes", "Suggested changes", relaxation_table(solution),
        "Each number is rounded to the feasible side and was tried in the scene: a solve found a motion with "
        "it. Where it says \"at most\" or \"at least\", a smaller change may suffice.");
    if (solution.measured)
        add("measured", "Measured motion", measured_table(solution), measured_sentence(solution) + ".");
    if (!solution.motion) return all;
    add("peaks", "Peaks", peak_table(solution),
        solution.scene.motion.prescribed()
            ? "Peaks are exact, not sampled. Normalised: by each law's own angle and displacement."
            : peak_note + any_curve_note(solution));
    for (ViewTable& table : valve_tables(solution)) all.push_back(std::move(table));
    add("segments", "Segments", segment_table(solution), segment_table_note());
    add("limits", "Limits", limit_table(solution), verification_words(solution.constraints));
    add("set_points", "Set points", set_point_table(solution));
    if (solution.surge)
        add("surge", "Spring surge", surge_table(solution),
            surge_sentence(solution) + ". Harmonic k excites the spring at k times the speed of the cam.");
    if (!solution.cam) return all;
    add("dimensions", "Dimensions", dimension_table(solution), cam_text(solution.scene.cam.value()) + ".");
    add("cam", "The cam", cam_table(solution, {{"", true}, {"value"}, {"at (deg)"}}));
    TextTable title{{{"", true}, {"title block", true}}, {}};
    for (const auto& [label, words] : title_block_words(solution.scene)) title.rows.push_back({label, words});
    add("title_block", "Drawing", std::move(title));
    return all;
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

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/view/segment_table.hpp"

#include "core/text/printable.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/view/number_text.hpp"
#include "output/view/shown_units.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/format.h>

#include <cmath>

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

std::string with_unit(double value, const std::string& unit, int digits) {
    return short_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

std::optional<Peaks> segment_peaks(const SegmentReport& segment) {
    if (segment.kind != SegmentKind::law) return segment.peaks;
    Peaks peaks = make_law(segment.law)->peaks();
    for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque}) {
        Extremum& own = peaks.*peak;
        own.at = segment.begin + (segment.end - segment.begin) * own.at;
    }
    return peaks;
}

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
    for (const SegmentReport& segment : solution.segments) {
        const double begin = shown.degrees_per_x * segment.begin, end = shown.degrees_per_x * segment.end;
        std::vector<std::string> row = {segment_title(segment),
                                        short_text(begin),
                                        short_text(end),
                                        short_text(end - begin),
                                        place_text(segment.from, lift),
                                        place_text(segment.to, lift)};
        const std::optional<Peaks> peaks = segment_peaks(segment);
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
            row.push_back(peaks ? short_text(((*peaks).*peak).value, peak_digits) : "–");
        row.push_back(joint_text(segment));
        table.rows.push_back(std::move(row));
    }
    return table;
}

const char* segment_table_note() {
    return "V, A, J: by the segment's own angle and displacement. Joint: the highest derivative that is "
           "continuous where the segment begins, 3 at most.";
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
            {report.key,
             along ? fmt::format("{} to {}", begin, short_text(report.point.end * degrees_per_x)) : begin,
             with_unit(report.wanted, report.unit, 6),
             with_unit(report.found, report.unit, set_point_digits)});
    }
    return table;
}

std::string measured_sentence(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const MotionUnit& unit = shown_units(solution.scene).motion[0].first;
    std::string text = fmt::format("{}: {} rows as a spline of this space, error at most {} (rms {})",
                                   measured.name.empty() ? "measured motion" : printable(measured.name),
                                   measured.rows, unit.normalised_text(measured.largest_error, 3),
                                   unit.normalised_text(measured.rms_error, 3));
    if (measured.objective && solution.motion && *measured.objective > 0.0) {
        const double gain = 100.0 * (1.0 - solution.certificate.objective / *measured.objective);
        text += fmt::format("; the optimum's objective is {} % {} than its {}", short_text(std::abs(gain), 3),
                            gain < 0.0 ? "more" : "less", short_text(*measured.objective));
    }
    if (measured.started) text += "; the search began from it, too";
    return text;
}

}  // namespace camopt

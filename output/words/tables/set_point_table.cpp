// SPDX-License-Identifier: MIT
#include "output/words/tables/set_point_table.hpp"

#include "core/text/printable.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "studies/delivered/set_point_reports.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr int set_point_digits = 9;  // enough to see that it is met

std::string with_unit(double value, const std::string& unit, int digits) {
    return short_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

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

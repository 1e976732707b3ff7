// SPDX-License-Identifier: MIT
#include "output/chart/reference_table/reference_table_svg.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/reference_table/reference_table_panels.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/words/tables/reference_table_rows.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 1160, page_height = 1004;
constexpr PanelFrame convergence_place{84, 120, 480, 392}, acceleration_place{668, 120, 452, 170},
    jerk_place{668, 342, 452, 170}, law_place{40, 632, 1080, 330};

const SplineCurve* best_curve(const ReferenceTable& table) {
    for (const ConvergenceRow& row : table.convergence)
        if (row.segments == 12 && row.optimum.curve) return &*row.optimum.curve;
    return nullptr;
}

void draw_curves(SvgCanvas& canvas, const SplineCurve& best) {
    const auto law = make_law("modified_sine");
    const double left = acceleration_place.left, above = acceleration_place.top - 12;
    canvas.text(left, above, "Acceleration y″", "caption");
    canvas.text(left, jerk_place.top - 12, "Jerk y‴", "caption");
    canvas.line(left + 150, above - 4, left + 176, above - 4, "best-line");
    canvas.text(left + 182, above, "best cubic, 12 segments", "value");
    canvas.line(left + 350, above - 4, left + 376, above - 4, "law-line");
    canvas.text(left + 382, above, "mod. sine", "value");
    draw_curve_panel(canvas, acceleration_place, 2, {best, *law});
    draw_curve_panel(canvas, jerk_place, 3, {best, *law});
}

}  // namespace

std::string reference_table_svg(const ReferenceTable& table) {
    SvgCanvas canvas(page_width, page_height, reference_panel_style(),
                     "The best cubic spline beside the modified sine");
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(40, 42, "The best cubic spline beside the modified sine", "title");
    canvas.text(40, 66,
                "Rise between two dwells. Objective = 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69, with V, A, J = max "
                "|y′|, |y″|, |y‴|.",
                "subtitle");
    const std::string warning = unproved_warning(table);
    if (!warning.empty()) canvas.text(40, 88, warning, "unproved");
    canvas.text(convergence_place.left, convergence_place.top - 12,
                "Objective against the number of segments", "caption");
    draw_convergence_panel(canvas, convergence_place, table);
    if (const SplineCurve* best = best_curve(table)) draw_curves(canvas, *best);
    canvas.text(40, law_place.top - 36,
                "Peaks relative to the modified sine (1 = as large), sorted by the objective", "caption");
    draw_law_panel(canvas, law_place, table);
    return canvas.finish();
}

}  // namespace camopt

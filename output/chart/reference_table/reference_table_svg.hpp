// SPDX-License-Identifier: MIT
// The reference table as one picture: objective against the number of segments with the paper's figures and
// the limit of all curves; acceleration and jerk of the best 12 segments over the modified sine; peaks of the
// classical laws relative to the modified sine.
//
// Normalised quantities. Colours can be told apart by colour-blind readers; marks differ in shape as well.
// Rows that are not proved optimal are named in red. Nothing throws; a part without values is left out.
#pragma once

#include "core/motion.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/svg_canvas.hpp"
#include "studies/papers/reference_table.hpp"

#include <string>
#include <string_view>

namespace camopt {

[[nodiscard]] std::string reference_table_svg(const ReferenceTable& table);

// The parts of the reference table's picture (reference_table_svg.hpp). Private to output/.
[[nodiscard]] std::string_view reference_panel_style();

void draw_convergence_panel(SvgCanvas& canvas, const PanelFrame& place, const ReferenceTable& table);

/// The derivative of the best curve and of the modified sine, one over the other.
struct CurvePair {
    const Motion& optimum;
    const Motion& law;
};
void draw_curve_panel(SvgCanvas& canvas, const PanelFrame& place, int order, const CurvePair& pair);

/// One row a law, sorted by the objective; columns V, A, J relative to the modified sine.
void draw_law_panel(SvgCanvas& canvas, const PanelFrame& place, const ReferenceTable& table);

}  // namespace camopt

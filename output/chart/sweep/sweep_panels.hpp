// SPDX-License-Identifier: MIT
// The parts of a sweep's picture. Private to output/.
#pragma once

#include "output/chart/motion_panel.hpp"
#include "output/chart/sweep/sweep_quantities.hpp"
#include "output/chart/sweep/sweep_svg.hpp"

#include <string>

namespace camopt {

/// CSS rules of all parts.
[[nodiscard]] std::string sweep_panel_style();

/// "dot c7 r12": how a row is drawn that has this colour.
[[nodiscard]] std::string row_class(const char* kind, const std::string& colour, const SweepRow& row);

/// A quantity over the triangle of the weights of V (left), A (right) and J (top).
void draw_weight_triangle(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
                          const SweepQuantity& quantity);

/// Two peaks against one another, the third as colour; laws are numbered as in their table.
struct PlanePeaks {
    std::size_t across = 0, up = 1, colour = 2;  ///< V, A, J
};
void draw_plane(SvgCanvas& canvas, const PanelFrame& place, const SweepPicture& picture,
                const PlanePeaks& peaks);

/// One line a law; returns the height it took.
double draw_law_table(SvgCanvas& canvas, double left, double top, const LawLosses& losses);
[[nodiscard]] double law_table_height(const LawLosses& losses);

/// A quantity over one key (or over the row number where key < 0).
void draw_lines(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
                const SweepQuantity& quantity, int key);

/// A quantity over two keys that form a grid.
void draw_map(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
              const SweepQuantity& quantity);

/// The two keys of the plan take every pair of their values once.
[[nodiscard]] bool is_map(const SweepTable& table);

}  // namespace camopt

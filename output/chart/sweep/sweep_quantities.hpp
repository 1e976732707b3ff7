// SPDX-License-Identifier: MIT
// The figures of a sweep's rows that are drawn and tabulated. Private to output/.
#pragma once

#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/chart/sweep/sweep_svg.hpp"
#include "studies/sweep/sweep_row.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct SweepQuantity {
    std::string title;   ///< "velocity V", "base radius (mm)"
    std::string symbol;  ///< "V"
    std::function<std::optional<double>(const SweepRow&)> value;
};

[[nodiscard]] SweepQuantity objective_quantity();
/// V, A, J.
[[nodiscard]] std::array<SweepQuantity, 3> peak_quantities();
/// The objective, V, A, J, every other figure with a weight, and the variable dimensions.
[[nodiscard]] std::vector<SweepQuantity> drawn_quantities(const SweepTable& table);

/// Over the feasible rows.
[[nodiscard]] ValueRange range_of(std::span<const SweepRow> rows, const SweepQuantity& quantity);

/// An axis over a range with some room, logarithmic where the range spans a large factor: one extreme row
/// must not flatten the rest.
[[nodiscard]] PlotAxis axis_over(const ValueRange& range, double begin, double end);
[[nodiscard]] bool spans_factors(const ValueRange& range);

/// Axis ticks with their labels.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted);

// The parts of a sweep's picture. Private to output/.

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

// Colours for a third dimension: dark blue (low) over green to yellow (high), in steps that also differ in
// lightness, so that they survive a grey printer.
inline constexpr int colour_steps = 16;

/// CSS rules .c0 … .c15 (fill).
[[nodiscard]] std::string colour_scale_style();

struct ColourScale {
    double lower = 0.0, upper = 1.0;
    bool logarithmic = false;  ///< then lower > 0
    /// "c7"; values outside take the last colour.
    [[nodiscard]] std::string colour(double value) const;
};

/// A bar with its numbers at both ends and the title in the middle; (x, y): its upper left corner.
void draw_colour_bar(SvgCanvas& canvas, const ColourScale& scale, double x, double y, double width);

}  // namespace camopt

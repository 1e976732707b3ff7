// SPDX-License-Identifier: MIT
// One chart as a plain value, and the one renderer of all of them.
//
// A picture is a function that fills a Chart from its study, in the units of its axes; layout, axes, labels,
// legend and styles are the renderer's. Classes ("optimum", "row-dot off r7") choose the look from its style
// sheet and let pages and tests find an element. Sizes are px. What is not finite or lies outside of its axes
// is left out; nothing throws.
#pragma once

#include "report/chart/svg_canvas.hpp"

namespace camopt {

/// Marks reach `size` to each side. A cell does so in the units of the axes, a disc in those of the
/// horizontal axis. A tick stands on its point, 2 · size high; a rule is as high as the plot. A bar begins at
/// the left; one that is longer than the axis is cut. A band lies between its first and its last point. Bands
/// and cells of a class that begins with "failed" have a cross.
enum class Look { line, dot, disc, square, diamond, cell, tick, rule, bar, band, label };

/// A label stands beside its point where there is room, else further away; that of a line's first point
/// anywhere along it. Of lines in sequence with one label one has it. A line without a class shows only its
/// label.
struct ChartPoint {
    double x = 0.0, y = 0.0;
    std::string css = {};  ///< besides that of its series
    std::string label = {};
};

struct ChartSeries {
    Look look = Look::line;
    std::string css = {};
    std::vector<ChartPoint> points = {};  ///< a line is broken where one is left out
    double size = 4.0;
    std::string title = {};  ///< in the legend; empty: not there
    std::string label_css = {};
    LabelSide side = LabelSide::aside;
    double font = 12.0;     ///< of labels
    bool compared = false;  ///< it widens the axes by a half or a quarter of the others' ends at most
};

/// Dark blue (low) over green to yellow (high), in steps that also differ in lightness, so that they survive
/// a grey printer.
struct ColourScale {
    std::string title = {};
    ValueRange range = {};

    /// "c7".
    [[nodiscard]] std::string colour(double value) const;
};

struct ChartCell {
    std::string words, css = "value";
};

struct ChartColumn {
    std::string head = {};  ///< '\n' between two lines
    TextSide side = TextSide::end;
    std::vector<ChartCell> cells = {};
};

/// A plot, or a table where it has columns.
struct ChartPanel {
    enum class Place { new_row, right, below };  ///< of the panel before it

    Place place = Place::new_row;
    double width = 0.0, height = 0.0;  ///< of the frame
    std::string caption = {}, note = {};
    bool warning = false;        ///< the note is one
    PlotFrame frame = {};        ///< axes over the series and round ticks where it has none
    bool by_factors = false;     ///< such an axis is logarithmic where its values span a large factor
    bool drawn_axes = true;      ///< false: only what is drawn over them
    bool equal_scales = false;   ///< one unit is as long on both axes; the height is the largest
    double beside_factor = 0.0;  ///< an axis on the right: this many times the values; 0: none
    std::vector<ChartSeries> series = {};
    std::optional<ColourScale> colours = {};
    std::vector<ChartColumn> columns = {};
    int rows = 0;  ///< of a table beside it: the first is −1 … 0 of the vertical axis, which has no ticks
    double row_height = 21.0;
};

struct Chart {
    std::string title;
    std::vector<std::string> lines = {};  ///< below the title
    std::vector<ChartPanel> panels = {};
};

/// Axes that are not given go over the series. By chart_svg, or before it by a picture that needs to know
/// them.
void set_axes(ChartPanel& panel);

[[nodiscard]] std::string chart_svg(Chart chart);

/// Classes of curves and points in the colours of one palette safe for colour-blind readers, by turns.
[[nodiscard]] std::string palette_class(Look look, std::size_t index);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Axes of a plot: from numbers to px, linear or logarithmic, and the frame with its grid and labels.
//
// px lie as on the canvas, y downwards: a vertical axis begins at its bottom. Nothing throws; a logarithmic
// axis needs positive bounds.
#pragma once

#include "core/motion.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/svg_canvas.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// Where a plotting area lies on the canvas, px.
struct PanelFrame {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

struct PlotAxis {
    double lower = 0.0, upper = 1.0;
    double begin = 0.0, end = 1.0;  ///< px of lower and upper
    bool logarithmic = false;

    [[nodiscard]] double place(double value) const;
    [[nodiscard]] bool holds(double value) const { return value >= lower && value <= upper; }
};

struct PlotFrame {
    PlotAxis horizontal, vertical;
    std::vector<PlotTick> horizontal_ticks, vertical_ticks;
    std::string horizontal_title, vertical_title;  ///< empty: none
};

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame);

/// Powers of ten in [lower, upper], every `stride`-th with a label: "10⁻⁹".
[[nodiscard]] std::vector<PlotTick> decade_ticks(double lower, double upper, int stride);

// A derivative of a motion as SVG path data.
//
// Between breakpoints the value and its slope (the next derivative, exact) give cubic Bézier pieces: for a
// cubic spline they are the curve itself. The jerk is drawn through dense points, its steps as steps. Where a
// derivative is infinite the path is broken.

/// From (x, y⁽ʳ⁾) to px.
struct PlotMap {
    std::function<double(double x)> horizontal;
    std::function<double(double value)> vertical;
};

/// order: 0 … 3. Motions of very many pieces are thinned out to what a screen can show.
[[nodiscard]] std::string curve_path(const Motion& motion, int order, const PlotMap& map);

/// Of 0 and the finite values of the derivative on the points the path goes through.
[[nodiscard]] ValueRange value_range(const Motion& motion, int order);

}  // namespace camopt

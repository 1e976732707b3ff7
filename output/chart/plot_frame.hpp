// SPDX-License-Identifier: MIT
// Axes of a plot: round numbers for them, from numbers to px, linear or logarithmic, and the frame with its
// grid and labels.
//
// px lie as on the canvas, y downwards: a vertical axis begins at its bottom. Nothing throws; a logarithmic
// axis needs positive bounds.
#pragma once

#include "output/chart/svg_canvas.hpp"

#include <string>
#include <vector>

namespace camopt {

struct PlotTick {
    double value = 0.0;
    std::string words;  ///< empty: a line of the grid without a label
};

/// Multiples of a round step (1, 2 or 5 times a power of ten) in [lower, upper]: about `wanted` of them.
[[nodiscard]] std::vector<double> round_ticks(double lower, double upper, int wanted);

/// The same for an angle in degrees: steps a protractor knows (1, 2, 5, 10, 15, 30, 45, 60, 90 …).
[[nodiscard]] std::vector<double> degree_ticks(double lower, double upper, int wanted);

/// round_ticks with their texts: just the decimals that the step between them needs, however few they are.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(double lower, double upper, int wanted);

/// Powers of ten in [lower, upper], every `stride`-th with a label: "10⁻⁹".
[[nodiscard]] std::vector<PlotTick> decade_ticks(double lower, double upper, int stride);

/// The number with just the decimals that tell it from its neighbours.
[[nodiscard]] std::string tick_text(double value, double step);

/// The least and the largest of the finite numbers seen; [0, 0] before the first one.
struct ValueRange {
    double lower = 0.0, upper = 0.0;
    bool started = false;

    void add(double value);
    [[nodiscard]] bool empty() const { return !(upper >= lower) || !started; }
    /// A little wider, and never of no width.
    [[nodiscard]] ValueRange padded(double part) const;
    /// So large a factor that one extreme value would flatten the rest of a linear axis.
    [[nodiscard]] bool spans_factors() const;
};

struct PlotAxis {
    double lower = 0.0, upper = 0.0;
    double begin = 0.0, end = 1.0;  ///< px of lower and upper
    bool logarithmic = false;

    [[nodiscard]] double place(double value) const;
    [[nodiscard]] bool holds(double value) const { return value >= lower && value <= upper; }
};

/// Over a range with some room.
[[nodiscard]] PlotAxis axis_over(const ValueRange& range, bool logarithmic);

/// Of a linear axis round numbers; of a logarithmic one decades, or 1, 2, 5 of each where they are few.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted);

struct PlotFrame {
    PlotAxis horizontal, vertical;
    std::vector<PlotTick> horizontal_ticks, vertical_ticks;
    std::string horizontal_title, vertical_title;  ///< empty: none
};

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame);

/// px that labels and title of the vertical axis take left of the frame.
[[nodiscard]] double room_before(const PlotFrame& frame);

}  // namespace camopt

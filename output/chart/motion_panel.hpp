// SPDX-License-Identifier: MIT
// One panel of the motion picture: a derivative over the cam angle, with reference, limit and peak.
#pragma once

#include "core/motion.hpp"
#include "output/chart/limit_spans.hpp"
#include "output/chart/svg_canvas.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// Where the plotting area lies on the canvas, px.
struct PanelFrame {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

struct PanelLimit {
    double normalised = 0.0;       ///< drawn at ±normalised
    std::string words;             ///< "limit 1.8"
    std::vector<LimitSpan> spans;  ///< instead of one over the whole motion; `normalised` is the largest
};

/// A segment of a program: lines mark its ends, its title stands between them where there is room.
struct PanelSegment {
    double begin = 0.0, end = 0.0;  ///< x
    std::string title;              ///< empty: none in this panel
};

/// A value that the motion must have at x, or from x on to `end`.
struct PanelMark {
    double x = 0.0, end = 0.0, value = 0.0;
};

/// A value that is marked on the curve, signed.
struct PanelPeak {
    Extremum where;
    std::string words;
};

struct PanelContent {
    int order = 0;  ///< which derivative
    const Motion* optimum = nullptr;
    const Motion* reference = nullptr;   ///< none: not drawn
    const Motion* measured = nullptr;    ///< none: not drawn
    std::vector<PanelMark> marks;        ///< set points
    std::string caption, caption_right;  ///< above the area: what it is, and how it compares
    double factor = 1.0;                 ///< shown value = factor · normalised, for the left axis
    std::string unit;                    ///< of the left axis
    double degrees_per_x = 1.0;
    std::vector<PanelPeak> peaks;  ///< the largest magnitude first
    std::optional<PanelLimit> limit;
    std::vector<PanelSegment> segments;
    std::vector<double> angle_ticks;  ///< degrees
    bool angle_labels = false;        ///< the lowest panel carries the numbers
};

/// The CSS rules the panel's elements use.
[[nodiscard]] std::string_view panel_style();

void draw_panel(SvgCanvas& canvas, const PanelFrame& frame, const PanelContent& content);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Colours for a third dimension: dark blue (low) over green to yellow (high), in steps that also differ in
// lightness, so that they survive a grey printer.
#pragma once

#include "output/chart/svg_canvas.hpp"

#include <string>
#include <string_view>

namespace camopt {

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

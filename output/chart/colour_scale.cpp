// SPDX-License-Identifier: MIT
#include "output/chart/colour_scale.hpp"

#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

// Viridis (S. van der Walt, N. Smith, CC0) at sixteen even places.
constexpr std::array<const char*, colour_steps> colours = {
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725"};
constexpr double bar_height = 8;

}  // namespace

std::string colour_scale_style() {
    std::string style;
    for (int i = 0; i < colour_steps; ++i)
        style += fmt::format(".c{}{{fill:{}}}", i, colours[static_cast<std::size_t>(i)]);
    return style + ".bar-number{font-size:11px;fill:#444}.bar-number.right{text-anchor:end}";
}

std::string ColourScale::colour(double value) const {
    const double part = !(upper > lower) ? 0.5
                        : logarithmic    ? std::log(value / lower) / std::log(upper / lower)
                                         : (value - lower) / (upper - lower);
    return fmt::format("c{}", std::clamp(static_cast<int>(part * colour_steps), 0, colour_steps - 1));
}

void draw_colour_bar(SvgCanvas& canvas, const ColourScale& scale, double x, double y, double width) {
    const double step = width / colour_steps;
    for (int i = 0; i < colour_steps; ++i)
        canvas.rectangle(x + i * step, y, step + 0.3, bar_height, fmt::format("c{}", i));
    canvas.text(x, y + bar_height + 12, short_text(scale.lower, 4), "bar-number");
    canvas.text(x + width, y + bar_height + 12, short_text(scale.upper, 4), "bar-number right");
}

}  // namespace camopt

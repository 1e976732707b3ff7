// SPDX-License-Identifier: MIT
#include "output/chart/plot_frame.hpp"

#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr double decade_rounding = 1e-9;  // a power of ten on the end of the axis is inside

std::string raised(int exponent) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string power_words(int exponent) {
    if (exponent == 0) return "1";
    return "10" + (exponent == 1 ? std::string{} : raised(exponent));
}

}  // namespace

double PlotAxis::place(double value) const {
    const double part =
        logarithmic ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
    return begin + part * (end - begin);
}

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame) {
    const PlotAxis &across = frame.horizontal, &up = frame.vertical;
    for (const PlotTick& tick : frame.vertical_ticks) {
        const double y = up.place(tick.value);
        canvas.line(across.begin, y, across.end, y, "grid");
        if (!tick.words.empty()) canvas.text(across.begin - 7, y + 4, tick.words, "tick right");
    }
    for (const PlotTick& tick : frame.horizontal_ticks) {
        const double x = across.place(tick.value);
        canvas.line(x, up.begin, x, up.end, "grid");
        if (!tick.words.empty()) canvas.text(x, up.begin + 16, tick.words, "tick middle");
    }
    canvas.rectangle(across.begin, up.end, across.end - across.begin, up.begin - up.end, "frame");
    if (!frame.horizontal_title.empty())
        canvas.text(0.5 * (across.begin + across.end), up.begin + 36, frame.horizontal_title, "axis-title");
    if (!frame.vertical_title.empty())
        canvas.text(across.begin - 52, 0.5 * (up.begin + up.end), frame.vertical_title, "axis-title", 90.0);
}

std::vector<PlotTick> decade_ticks(double lower, double upper, int stride) {
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(lower) - decade_rounding));
    const int last = static_cast<int>(std::floor(std::log10(upper) + decade_rounding));
    for (int exponent = first; exponent <= last; ++exponent)
        ticks.push_back(
            {std::pow(10.0, exponent), exponent % stride == 0 ? power_words(exponent) : std::string{}});
    return ticks;
}

}  // namespace camopt

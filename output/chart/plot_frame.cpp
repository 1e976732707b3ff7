// SPDX-License-Identifier: MIT
#include "output/chart/plot_frame.hpp"

#include "output/view/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace camopt {

namespace {

constexpr double rounding = 1e-9;  // relative to the step: a tick on the end of the axis is inside

std::vector<double> multiples(double step, double lower, double upper) {
    std::vector<double> ticks;
    const long first = std::lround(std::ceil(lower / step - rounding));
    const long last = std::lround(std::floor(upper / step + rounding));
    for (long k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
    return ticks;
}

double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - rounding)) return factor * power;
    return 10.0 * power;
}

/// "10⁻⁹".
std::string power_words(int exponent) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (exponent == 0 || exponent == 1) return exponent == 0 ? "1" : "10";
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

constexpr double tick_font = 11, tick_gap = 7, title_ascent = 12;  // px

}  // namespace

std::vector<double> round_ticks(double lower, double upper, int wanted) {
    if (!(upper > lower) || !std::isfinite(upper - lower)) return {};
    return multiples(round_step((upper - lower) / wanted), lower, upper);
}

std::vector<PlotTick> labelled_ticks(double lower, double upper, int wanted) {
    std::vector<PlotTick> ticks;
    const double step = round_step((upper - lower) / wanted);
    for (const double value : round_ticks(lower, upper, wanted))
        ticks.push_back({value, tick_text(value, step)});
    return ticks;
}

std::vector<double> degree_ticks(double lower, double upper, int wanted) {
    if (!(upper > lower) || !std::isfinite(upper - lower)) return {};
    const double least = (upper - lower) / wanted;
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0})
        if (least > 0.5 && step >= least) return multiples(step, lower, upper);
    return multiples(round_step(least), lower, upper);
}

std::string tick_text(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + rounding)));
    const bool plain = decimals <= 4 && std::abs(value) < 1e6;
    // Neighbours differ in their last digit also where they are long: 1.60960, 1.60961.
    const double size = std::abs(value) < step ? step : std::abs(value);
    const int digits = std::max(
        3, 1 + static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(step) + rounding)));
    if (!plain) return power_text(value, digits);
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

void ValueRange::add(double value) {
    if (!std::isfinite(value)) return;
    lower = started ? std::min(lower, value) : value;
    upper = started ? std::max(upper, value) : value;
    started = true;
}

ValueRange ValueRange::padded(double part) const {
    constexpr double least_width =
        1e-3;  // of the values: what differs by less is level, not a curve of rounding
    const double size = std::max(std::abs(lower), std::abs(upper));
    const double width = std::max(upper - lower, least_width * (size > 0.0 ? size : 1.0));
    const double middle = 0.5 * (lower + upper);
    return {middle - (0.5 + part) * width, middle + (0.5 + part) * width, started};
}

bool ValueRange::spans_factors() const {
    constexpr double large_factor = 6.0;
    return !empty() && lower > 0.0 && upper > large_factor * lower;
}

PlotAxis axis_over(const ValueRange& range, bool logarithmic) {
    constexpr double room = 0.05;
    if (!logarithmic) {
        const ValueRange wide = range.padded(room);
        return {wide.lower, wide.upper};
    }
    const double factor = std::pow(range.upper / range.lower, room);
    return {range.lower / factor, range.upper * factor, 0.0, 1.0, true};
}

std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted) {
    if (!axis.logarithmic) return labelled_ticks(axis.lower, axis.upper, wanted);
    constexpr double few = 3.0, many = 8.0;
    const double decades = std::log10(axis.upper / axis.lower);
    if (decades > few) return decade_ticks(axis.lower, axis.upper, decades > many ? 2 : 1);
    std::vector<PlotTick> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(axis.lower))); power <= axis.upper;
         power *= 10.0)
        for (const double digit : {1.0, 2.0, 5.0})
            if (axis.holds(digit * power)) ticks.push_back({digit * power, short_text(digit * power, 5)});
    return ticks;
}

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
        canvas.text(across.begin - room_before(frame) + title_ascent, 0.5 * (up.begin + up.end),
                    frame.vertical_title, "axis-title", 90.0);
}

double room_before(const PlotFrame& frame) {
    constexpr double least = 64;  // so that panels above one another mostly begin at one place
    double widest = 0.0;
    for (const PlotTick& tick : frame.vertical_ticks)
        widest = std::max(widest, text_width(tick.words, tick_font));
    return std::max(least, widest + tick_gap + 6 + title_ascent);
}

std::vector<PlotTick> decade_ticks(double lower, double upper, int stride) {
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(lower) - rounding));
    const int last = static_cast<int>(std::floor(std::log10(upper) + rounding));
    for (int exponent = first; exponent <= last; ++exponent)
        ticks.push_back(
            {std::pow(10.0, exponent), exponent % stride == 0 ? power_words(exponent) : std::string{}});
    return ticks;
}

}  // namespace camopt

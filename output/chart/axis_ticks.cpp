// SPDX-License-Identifier: MIT
#include "output/chart/axis_ticks.hpp"

#include "output/view/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "apps/studio/slider_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt::apps {

namespace {

constexpr std::array round_figures = {1.0, 2.0, 5.0, 10.0};
constexpr double steps_of_slider = 200.0;

/// The power of ten at or below.
double decade_of(double value) {
    return std::pow(10.0, std::floor(std::log10(value) + 1e-12));
}

/// 1, 2 or 5 times a power of ten, at or above.
double round_up(double value) {
    const double decade = decade_of(value);
    for (const double figure : round_figures)
        if (figure * decade >= value * (1.0 - 1e-12)) return figure * decade;
    return 10.0 * decade;
}

/// At or below.
double round_down(double value) {
    const double decade = decade_of(value);
    const auto above = std::ranges::upper_bound(round_figures, value / decade * (1.0 + 1e-12));
    return *std::prev(above) * decade;
}

double far_end(double value) {
    return value == 0.0 ? 1.0 : round_up(2.0 * std::abs(value));
}

}  // namespace

SliderRange slider_range(const Range& allowed, double value, bool integer) {
    SliderRange slider;
    const bool both = std::isfinite(allowed.low) && std::isfinite(allowed.high);
    const double end = far_end(value);
    // A range of four decades has two ends too, but no slider to find a value with.
    const bool whole = both && allowed.high - allowed.low <= 100.0 * end;
    slider.from = std::isfinite(allowed.low) ? allowed.low : value < 0.0 ? -end : 0.0;
    slider.to = whole ? allowed.high : std::min(std::max(end, slider.from + end), allowed.high);
    slider.step = integer ? 1.0 : round_down((slider.to - slider.from) / steps_of_slider);
    if (!allowed.low_included && slider.from == allowed.low) slider.from += slider.step;
    if (!allowed.high_included && slider.to == allowed.high) slider.to -= slider.step;
    return slider;
}

}  // namespace camopt::apps

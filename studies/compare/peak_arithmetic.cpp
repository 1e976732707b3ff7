// SPDX-License-Identifier: MIT
#include "studies/compare/peak_arithmetic.hpp"

#include <cmath>

namespace camopt {

Peaks scaled_peaks(Peaks peaks, double size, double width) {
    for (const PeakFigure& figure : peak_figures) {
        const double sizes = figure.size_power == 2 ? size * size : size;
        figure.in(peaks) *= sizes / std::pow(width, figure.width_power);
    }
    return peaks;
}

Peaks normalised_peaks(const Peaks& peaks, const StretchScale& scale) {
    return scaled_peaks(peaks, 1.0 / scale.displacement, 1.0 / scale.angle);
}

void raise_peaks(Peaks& peaks, const Peaks& other) {
    for (const PeakFigure& figure : peak_figures)
        if (figure.extremum != nullptr && figure.of(other) > figure.of(peaks))
            peaks.*figure.extremum = other.*figure.extremum;
}

void JoinedMeans::add(const Peaks& part, double width) {
    for (int order = 1; order <= 3; ++order) {
        const double mean = derivative_mean(part, order);
        squares_[static_cast<std::size_t>(order) - 1] += width * mean * mean;
    }
    width_ += width;
}

void JoinedMeans::set(Peaks& whole) const {
    for (int order = 1; order <= 3; ++order)
        derivative_mean(whole, order) = std::sqrt(squares_[static_cast<std::size_t>(order) - 1] / width_);
}

}  // namespace camopt

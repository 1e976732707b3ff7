// SPDX-License-Identifier: MIT
#include "studies/compare/peak_arithmetic.hpp"

#include <cmath>

namespace camopt {

Peaks scaled_peaks(Peaks peaks, double size, double width) {
    peaks.velocity.value *= size / width;
    peaks.acceleration.value *= size / std::pow(width, 2);
    peaks.jerk.value *= size / std::pow(width, 3);
    peaks.torque.value *= size * size / std::pow(width, 3);
    peaks.rms_velocity *= size / width;
    peaks.rms_acceleration *= size / std::pow(width, 2);
    peaks.rms_jerk *= size / std::pow(width, 3);
    return peaks;
}

Peaks normalised_peaks(const Peaks& peaks, const StretchScale& scale) {
    return scaled_peaks(peaks, 1.0 / scale.displacement, 1.0 / scale.angle);
}

void raise_peaks(Peaks& peaks, const Peaks& other) {
    for (const auto peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque}) {
        if ((other.*peak).value > (peaks.*peak).value) peaks.*peak = other.*peak;
    }
}

void JoinedMeans::add(const Peaks& part, double width) {
    const std::array<double, 3> rms = {part.rms_velocity, part.rms_acceleration, part.rms_jerk};
    for (std::size_t k = 0; k < 3; ++k) squares_[k] += width * rms[k] * rms[k];
    width_ += width;
}

void JoinedMeans::set(Peaks& whole) const {
    whole.rms_velocity = std::sqrt(squares_[0] / width_);
    whole.rms_acceleration = std::sqrt(squares_[1] / width_);
    whole.rms_jerk = std::sqrt(squares_[2] / width_);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The peaks of a motion: the figures cams are chosen by.
#pragma once

#include "core/numbers/extremum.hpp"

#include <array>
#include <string_view>

namespace camopt {

/// V, A, J = max |y'|, |y''|, |y'''|; torque Q = max |y'·y''|. Each Extremum carries the magnitude (>= 0,
/// possibly infinite) and where it is reached. rms = square root of the mean square over the motion.
struct Peaks {
    Extremum velocity;
    Extremum acceleration;
    Extremum jerk;
    Extremum torque;
    double rms_velocity = 0.0;
    double rms_acceleration = 0.0;
    double rms_jerk = 0.0;
};

// The members of Peaks as a table, for code that lists them: files, tables, sums over parts of a motion.
//
// A curve on an interval `width` times as long and `size` times as high has size^size_power /
// width^width_power times the figure: |y^{(r)}| is size / width^r times as large, y'·y'' size² / width³
// times.

/// One member of Peaks: an extremum, or a root mean square.
struct PeakFigure {
    std::string_view name;                ///< the member's: "velocity"; null-terminated
    Extremum Peaks::*extremum = nullptr;  ///< null: a root mean square
    double Peaks::*mean = nullptr;        ///< null: an extremum
    int order = 1;                        ///< of the highest derivative in it
    int size_power = 1, width_power = 1;

    [[nodiscard]] constexpr double& in(Peaks& peaks) const {
        return extremum != nullptr ? (peaks.*extremum).value : peaks.*mean;
    }
    [[nodiscard]] constexpr double of(const Peaks& peaks) const {
        return extremum != nullptr ? (peaks.*extremum).value : peaks.*mean;
    }
};

/// In the order of the columns.
inline constexpr std::array<PeakFigure, 7> peak_figures = {{
    {"velocity", &Peaks::velocity, nullptr, 1, 1, 1},
    {"acceleration", &Peaks::acceleration, nullptr, 2, 1, 2},
    {"jerk", &Peaks::jerk, nullptr, 3, 1, 3},
    {"torque", &Peaks::torque, nullptr, 2, 2, 3},
    {"rms_velocity", nullptr, &Peaks::rms_velocity, 1, 1, 1},
    {"rms_acceleration", nullptr, &Peaks::rms_acceleration, 2, 1, 2},
    {"rms_jerk", nullptr, &Peaks::rms_jerk, 3, 1, 3},
}};

/// The row of this name; an unknown name does not compile in a constant expression.
[[nodiscard]] constexpr const PeakFigure& peak_figure(std::string_view name) {
    for (const PeakFigure& figure : peak_figures)
        if (figure.name == name) return figure;
    throw "no such figure";
}

inline constexpr std::array<Extremum Peaks::*, 3> derivative_peaks = {&Peaks::velocity, &Peaks::acceleration,
                                                                      &Peaks::jerk};
inline constexpr std::array<double Peaks::*, 3> derivative_means = {
    &Peaks::rms_velocity, &Peaks::rms_acceleration, &Peaks::rms_jerk};

/// The peak, and the root mean square, of y^{(order)}; order 1, 2 or 3.
[[nodiscard]] inline Extremum& derivative_peak(Peaks& peaks, int order) {
    return peaks.*derivative_peaks.at(static_cast<std::size_t>(order) - 1);
}
[[nodiscard]] inline const Extremum& derivative_peak(const Peaks& peaks, int order) {
    return peaks.*derivative_peaks.at(static_cast<std::size_t>(order) - 1);
}
[[nodiscard]] inline double& derivative_mean(Peaks& peaks, int order) {
    return peaks.*derivative_means.at(static_cast<std::size_t>(order) - 1);
}
[[nodiscard]] inline double derivative_mean(const Peaks& peaks, int order) {
    return peaks.*derivative_means.at(static_cast<std::size_t>(order) - 1);
}

}  // namespace camopt

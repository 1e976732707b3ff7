// SPDX-License-Identifier: MIT
// A motion: displacement and its first three derivatives by the cam angle.
//
// Normalised form: x = cam angle / rise angle, y = displacement / lift; ' is d/dx. A DRD motion lives on
// [0, 1], an RR motion on [0, 1 + return angle / rise angle]. No units; physical ones return in report/.
#pragma once

#include "core/numbers/extremum.hpp"
#include "core/numbers/interval.hpp"

namespace camopt {

/// (y, y', y'', y''') at x. Index r of `derivative` is the r-th derivative.
struct MotionPoint {
    double x = 0.0;
    std::array<double, 4> derivative{};
};

/// Of the derivatives 0 to 3: in keys, messages and reports.
inline constexpr std::array derivative_names = {"displacement", "velocity", "acceleration", "jerk"};

/// "peak velocity"
[[nodiscard]] inline std::string peak_words(std::size_t order) {
    return std::string("peak ") + derivative_names[order];
}

/// A curve y(x) with exact derivatives up to the third, never a numeric one.
class Motion {
 public:
    virtual ~Motion() = default;

    [[nodiscard]] virtual double begin() const = 0;
    [[nodiscard]] virtual double end() const = 0;

    /// The point at x in [begin, end]. Where a derivative jumps, its limit from `side`. Infinite where it is.
    [[nodiscard]] virtual MotionPoint at(double x, Side side = Side::right) const = 0;

    /// Enclosures of y to its fourth derivative over `x`, a stretch between two neighbouring breakpoints.
    /// Returns nullopt if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<std::array<Interval, 5>> ranges(const Interval& /*x*/) const {
        return {};
    }

    /// Ascending x where a derivative up to the third may jump or change its formula, begin and end included.
    [[nodiscard]] virtual std::vector<double> breakpoints() const = 0;

 protected:
    Motion() = default;
    Motion(const Motion&) = default;
    Motion& operator=(const Motion&) = default;
    Motion(Motion&&) = default;
    Motion& operator=(Motion&&) = default;
};

/// The state of a follower at one cam angle, the input of every cam generator: displacement and its
/// derivatives by the cam angle, SI: m, m/rad, m/rad² (rad, 1, 1/rad where it swings).
struct FollowerState {
    double s = 0.0, velocity = 0.0, acceleration = 0.0;  ///< s, s', s''
};

/// The shape of a rule g <= 0 over all motions whose displacements stay in a range, and all parameters in
/// their bounds.
enum class Curvature { linear, convex, general };

// The peaks of a motion: the figures cams are chosen by.

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

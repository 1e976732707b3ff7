// SPDX-License-Identifier: MIT
// The printed tables of T.-Y. Shon and M.-Y. Yang, "Synthesis of Optimum CAM Curve by Cubic Spline", 1994:
// DRD motion, C2 cubic on n uniform segments, objective 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69. Facts as printed,
// misprints included; reference_table.hpp says what is wrong with which.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace camopt::paper {

/// The modified sine's peaks as the paper rounds them.
inline constexpr double velocity_reference = 1.76, acceleration_reference = 5.53, jerk_reference = 69.0;
inline constexpr std::array<double, 3> weights = {0.4, 0.4, 0.2};

/// Table 1: y_0 … y_n.
struct OptimumPoints {
    int segments;
    std::vector<double> ordinates;
};
[[nodiscard]] std::span<const OptimumPoints> optimum_points();

/// Table 2.
struct Convergence {
    int segments;
    double velocity, acceleration, jerk, objective;
};
[[nodiscard]] std::span<const Convergence> convergence();

/// Table 3. jerk: none where the paper prints infinity; key: empty where the catalogue has no such law.
struct LawPeaks {
    std::string_view name, key;
    double velocity, acceleration;
    std::optional<double> jerk;
};
[[nodiscard]] std::span<const LawPeaks> law_peaks();

/// Table 4: the optimum's fourth ordinate for n = 10 under other weights.
struct WeightEffect {
    double velocity, acceleration, jerk, fourth_ordinate;
};
[[nodiscard]] std::span<const WeightEffect> weight_effects();

}  // namespace camopt::paper

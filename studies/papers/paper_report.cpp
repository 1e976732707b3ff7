// SPDX-License-Identifier: MIT
#include "studies/papers/paper_report.hpp"

namespace camopt {

PaperCell cell_of(const std::optional<double>& value) {
    if (!value) return {};
    return *value;
}

}  // namespace camopt

namespace camopt::paper {

std::span<const OptimumPoints> optimum_points() {
    static const std::vector<OptimumPoints> table = {
        {6, {0.0, 0.0278, 0.194533, 0.5, 0.805467, 0.9722, 1.0}},
        {8, {0.0, 0.0139, 0.0973, 0.264035, 0.5, 0.735965, 0.9027, 0.9861, 1.0}},
        {10, {0.0, 0.0092, 0.0644, 0.174, 0.331732, 0.5, 0.668268, 0.8260, 0.9356, 0.9908, 1.0}},
        {12,
         {0.0, 0.0059, 0.0414, 0.1128, 0.2201, 0.357035, 0.5, 0.642965, 0.7799, 0.8872, 0.9586, 0.9941, 1.0}},
    };
    return table;
}

std::span<const Convergence> convergence() {
    static constexpr std::array<Convergence, 5> table = {{
        {4, 2.00, 8.00, 32.0, 1.1260},
        {6, 2.00, 6.00, 36.03, 0.9931},
        {8, 1.998, 5.338, 42.7, 0.9640},
        {10, 1.688, 5.520, 55.2, 0.9429},
        {12, 1.716, 5.184, 61.17, 0.9423},
    }};
    return table;
}

std::span<const LawPeaks> law_peaks() {
    static constexpr std::array<LawPeaks, 8> table = {{
        {"Parabolic", "parabolic", 2.000, 4.000, {}},
        {"Simple harmonic", "simple_harmonic", 1.57, 4.93, {}},
        {"Cycloidal", "cycloidal", 2.00, 6.28, 40.0},
        {"Modified cycloidal", "scca", 1.76, 5.89, 67.0},
        {"Modified trapezoidal", "modified_trapezoid", 2.00, 4.89, 61.0},
        {"Modified sine", "modified_sine", 1.76, 5.53, 69.0},
        {"3-4-5 polynomial", "polynomial_345", 1.89, 5.77, 60.0},
        {"4-5-6-7 polynomial", "polynomial_4567", 2.19, 7.52, 52.0},
    }};
    return table;
}

std::span<const WeightEffect> weight_effects() {
    static constexpr std::array<WeightEffect, 5> table = {{
        {0.4, 0.4, 0.2, 0.331733},
        {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.331733},
        {0.35, 0.45, 0.2, 0.331733},
        {0.45, 0.35, 0.2, 0.333633},
        {0.45, 0.45, 0.1, 0.333633},
    }};
    return table;
}

}  // namespace camopt::paper

// SPDX-License-Identifier: MIT
#include "splines/extrema.hpp"

#include "core/peak_figures.hpp"
#include "splines/polynomial.hpp"

#include <cmath>

namespace camopt {

namespace {

// Two peaks closer than this, relative to the larger, are the same peak reached twice: the first is reported.
constexpr double same_peak = 1e-12;

double mean_square(const SplineCurve& curve, int order) {
    double integral = 0.0;
    for (int i = 0; i < curve.segments(); ++i) {
        const Eigen::VectorXd part = curve.derivative_polynomial(i, order);
        const Eigen::VectorXd square = product(part, part);
        double power = 1.0;
        for (Eigen::Index m = 0; m < square.size(); ++m) {
            power *= curve.space().width(i);
            integral += square[m] * power / static_cast<double>(m + 1);
        }
    }
    return integral / (curve.end() - curve.begin());
}

}  // namespace

std::vector<Extremum> candidates_on_segment(const SplineSpace& space, int segment,
                                            const Eigen::VectorXd& polynomial) {
    const double origin = space.breakpoints()[segment];
    const double width = space.width(segment);
    std::vector<Extremum> found{{polynomial[0], origin, Side::right}};
    for (const double t : sign_changes(differentiated(polynomial), 0.0, width)) {
        found.push_back({evaluate_polynomial(polynomial, t), origin + t, Side::right});
    }
    found.push_back({evaluate_polynomial(polynomial, width), space.breakpoints()[segment + 1], Side::left});
    return found;
}

std::vector<Extremum> local_maxima(const SplineSpace& space, const SegmentFunction& function) {
    std::vector<Extremum> candidates;
    for (int i = 0; i < space.segments(); ++i) {
        for (const Extremum& candidate : candidates_on_segment(space, i, function(i))) {
            // Where the function is continuous both sides of a breakpoint are one point: keep the larger.
            if (!candidates.empty() && candidates.back().at == candidate.at) {
                const double jump = std::abs(candidates.back().value - candidate.value);
                if (jump <= same_peak * std::max(1.0, std::abs(candidate.value))) continue;
            }
            candidates.push_back(candidate);
        }
    }
    std::vector<Extremum> maxima;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const bool above_left = k == 0 || candidates[k].value >= candidates[k - 1].value;
        const bool above_right = k + 1 == candidates.size() || candidates[k].value >= candidates[k + 1].value;
        if (above_left && above_right) maxima.push_back(candidates[k]);
    }
    return maxima;
}

Extremum largest_magnitude(const SplineSpace& space, const SegmentFunction& function) {
    Extremum largest{-1.0, space.begin(), Side::right};
    for (int i = 0; i < space.segments(); ++i) {
        for (const Extremum& candidate : candidates_on_segment(space, i, function(i))) {
            const double magnitude = std::abs(candidate.value);
            if (magnitude > largest.value + same_peak * std::max(1.0, magnitude) || largest.value < 0.0) {
                largest = {magnitude, candidate.at, candidate.side};
            } else if (magnitude > largest.value) {
                largest.value = magnitude;
            }
        }
    }
    return largest;
}

Peaks peaks_of(const SplineCurve& curve) {
    const auto derivative = [&](int order) {
        return [&curve, order](int segment) { return curve.derivative_polynomial(segment, order); };
    };
    Peaks peaks;
    for (int order = 1; order <= 3; ++order) {
        derivative_peak(peaks, order) = largest_magnitude(curve.space(), derivative(order));
        derivative_mean(peaks, order) = std::sqrt(mean_square(curve, order));
    }
    peaks.torque = largest_magnitude(curve.space(), [&](int segment) {
        return product(curve.derivative_polynomial(segment, 1), curve.derivative_polynomial(segment, 2));
    });
    return peaks;
}

}  // namespace camopt

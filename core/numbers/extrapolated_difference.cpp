// SPDX-License-Identifier: MIT
#include "core/numbers/extrapolated_difference.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace camopt {
namespace {

// A value is taken to be right to so many units in the last place of what it was summed from.
constexpr double value_error = 16.0 * std::numeric_limits<double>::epsilon();
// What Richardson's weights (16/45·…, 64/45) make of the rounding of three differences, at most.
constexpr double amplification = 2.0;

/// From D(h), D(h/2), D(h/4): the terms in h² and h⁴ cancel.
Eigen::VectorXd extrapolated(const Eigen::VectorXd& coarse, const Eigen::VectorXd& middle,
                             const Eigen::VectorXd& fine) {
    return (coarse - 20.0 * middle + 64.0 * fine) / 45.0;
}

}  // namespace

ExtrapolatedDifference extrapolated_difference(const DifferencedFunction& function, const Eigen::VectorXd& x,
                                               Eigen::Index variable, double step) {
    std::array<Eigen::VectorXd, 4> differences;
    Eigen::VectorXd size = function.sizes, at = x;
    double width = step;
    for (Eigen::VectorXd& difference : differences) {
        at[variable] = x[variable] + width;
        const double above = at[variable];
        const Eigen::VectorXd high = function.values(at);
        at[variable] = x[variable] - width;
        const double below = at[variable];
        const Eigen::VectorXd low = function.values(at);
        difference = (high - low) / (above - below);  // the steps that were taken, not those wished for
        size = size.cwiseMax(high.cwiseAbs()).cwiseMax(low.cwiseAbs());
        width *= 0.5;
    }
    const Eigen::VectorXd coarse = extrapolated(differences[0], differences[1], differences[2]);
    ExtrapolatedDifference result;
    result.derivative = extrapolated(differences[1], differences[2], differences[3]);
    const double finest = step / 8.0;
    result.error = (result.derivative - coarse).cwiseAbs() + size * (amplification * value_error / finest);
    for (Eigen::Index i = 0; i < result.error.size(); ++i)
        if (!std::isfinite(result.error[i])) result.error[i] = std::numeric_limits<double>::infinity();
    return result;
}

}  // namespace camopt

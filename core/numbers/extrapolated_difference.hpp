// SPDX-License-Identifier: MIT
// A derivative by central differences together with how far it can be trusted.
//
//     D(h) = (f(x + h e_j) − f(x − h e_j)) / 2h = f' + c₂h² + c₄h⁴ + …
// is taken at four steps h, h/2, h/4, h/8. Three of them at a time are extrapolated to h = 0 (Richardson,
// error of order h⁶). The two results differ by about the error of the coarser one; a value of f that is
// right to some units in its last place adds rounding, which grows as the step shrinks. Both together are
// the error that is stated: it follows from the step and the size of what is differenced, and needs no
// tolerance of its own.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace camopt {

struct ExtrapolatedDifference {
    Eigen::VectorXd derivative;
    Eigen::VectorXd error;  ///< estimated, >= 0; infinite where a value is not finite
};

struct DifferencedFunction {
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> values;  ///< the components of f at a point
    /// The sum of the magnitudes that each component is summed from near x: its rounding goes by that, and
    /// not by what is left of it.
    Eigen::VectorXd sizes;
};
/// `step`: h, > 0.
[[nodiscard]] ExtrapolatedDifference extrapolated_difference(const DifferencedFunction& function,
                                                             const Eigen::VectorXd& x, Eigen::Index variable,
                                                             double step);

}  // namespace camopt

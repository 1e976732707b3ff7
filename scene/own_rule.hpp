// SPDX-License-Identifier: MIT
//
// User-defined cost terms and limits of a program: figures of one point of the motion that camopt does not
// know. They are treated like the built-in ones in objective, limits, proof, relaxation and reports.
//
//   term:   f += weight · max(0, max_x g(x, y, y', y'', y''')) / reference
//   limit:  g(x, y, y', y'', y''') <= limit   at every cam angle
//
// x in units of the rise (of a program: of its first spline segment), y in lifts, ' is d/dx; g in a unit of
// the program. Not available in scene files.
#pragma once

#include "core/motion.hpp"
#include "core/partials.hpp"

namespace camopt {

/// A figure at one point of the motion, with its partials by (y, y', y'', y''').
struct FormulaValue {
    double value = 0.0;
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();  ///< symmetric
    double by_x = 0.0;                                  ///< partial by x alone
};

/// Twice continuously differentiable, deterministic, callable by several threads at once. Exceptions
/// propagate through solve().
using MotionFormula = std::function<FormulaValue(const MotionPoint& point)>;

/// From a function of (y, y', y'', y''') generic over the number type:
///     motion_formula([](const auto& y, const auto& v, const auto& a, const auto& j) { return v * a; })
/// with exact partials (forward automatic differentiation).
template <class Function>
[[nodiscard]] MotionFormula motion_formula(Function function) {
    return [function = std::move(function)](const MotionPoint& point) {
        using Number = SecondOrder<4>;
        const auto& at = point.derivative;
        const Number result = function(variable<4>(at[0], 0), variable<4>(at[1], 1), variable<4>(at[2], 2),
                                       variable<4>(at[3], 3));
        FormulaValue found;
        found.value = result.value;
        found.gradient = result.gradient();
        found.hessian = result.hessian();
        return found;
    };
}

/// `shape`: of g over all (y, y', y'', y''') at every x. `general` is always correct and needs a search
/// without a proof; with `linear` or `convex`, solve() proves the optimum, and throws ModelError at the first
/// point where the Hessian contradicts it. `highest_order`: of the derivatives in g; where that derivative of
/// the motion jumps, g may jump.
struct OwnTerm {
    std::string name;        ///< in reports: lower case words, "power_peak"
    double weight = 0.0;     ///< > 0
    double reference = 1.0;  ///< > 0: a value of this counts as 1
    MotionFormula formula;
    Curvature shape = Curvature::general;
    int highest_order = 3;
};

struct OwnLimit {
    std::string name;    ///< as OwnTerm::name; reports call the limit "own.NAME"
    double limit = 0.0;  ///< g may not pass it
    MotionFormula formula;
    Curvature shape = Curvature::general;
    int highest_order = 3;
    std::string unit;   ///< of g, for reports
    double size = 0.0;  ///< of g, > 0: the scale of a violation; 0: |limit|, or 1 if that is 0

    [[nodiscard]] std::string key() const { return "own." + name; }
    [[nodiscard]] double scale() const {
        const double own = limit < 0.0 ? -limit : limit;
        return size > 0.0 ? size : own > 0.0 ? own : 1.0;
    }
};

}  // namespace camopt

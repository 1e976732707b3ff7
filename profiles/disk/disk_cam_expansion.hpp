// SPDX-License-Identifier: MIT
//
// Private to profiles/: a formula of a disk cam with its partials.
//
// A formula has few variables: the position p and some of s', s'', the dimensions, perhaps mirrored. It is
// expanded to second order in them by automatic differentiation and transformed to the variables of a
// QuantityValue by the chain rule. All of them but p = start(dimensions) + s are global variables or their
// negatives, so with J the Jacobian of the local by the global variables and f the formula
//   gradient = Jᵀ ∇f,   hessian = Jᵀ ∇²f J + ∂f/∂p ∇²p.
#pragma once

#include "core/partials.hpp"
#include "profiles/disk/disk_cam_dimensions.hpp"
#include "profiles/disk/quantity_value.hpp"
#include "scene/cam_mechanism.hpp"

#include <tuple>

namespace camopt::expansion {

template <int n>
using Jacobian = Eigen::Matrix<double, n, quantity_variables>;

/// Value and partials in n local variables.
template <int n>
struct Expansion {
    double value = 0.0;
    Eigen::Matrix<double, n, 1> gradient;
    Eigen::Matrix<double, n, n> hessian;

    explicit Expansion(const SecondOrder<n>& result)
        : value(result.value), gradient(result.gradient()), hessian(result.hessian()) {}

    /// In the global variables, as if all local ones were linear in them.
    [[nodiscard]] QuantityValue substituted(const Jacobian<n>& jacobian) const {
        QuantityValue result;
        result.value = value;
        result.gradient.noalias() = jacobian.transpose() * gradient;
        // Eigen would call its kernels for large matrices for this size.
        const Jacobian<n> half = hessian.lazyProduct(jacobian);
        result.hessian = jacobian.transpose().lazyProduct(half);
        return result;
    }
};

/// Columns of the partials.
inline constexpr int velocity_column = 1, acceleration_column = 2;

/// A variable of a formula that is a global variable or its negative.
struct Local {
    int column = 0;
    double sign = 1.0;
};

/// One cam in one state, whose formulas are to be expanded.
class Expander {
 public:
    /// rest: the origin of s, with its partials.
    Expander(QuantityValue rest, const DiskCam& cam, const FollowerState& state)
        : position_(std::move(rest)) {
        values_ << state.s, state.velocity, state.acceleration,
            Eigen::Map<const Eigen::Matrix<double, dimension_count, 1>>(cam.dimensions.data());
        position_.value += state.s;
        position_.gradient(0) += 1.0;
    }

    [[nodiscard]] const QuantityValue& position() const { return position_; }

    /// `formula` of the position and `locals`.
    template <std::size_t count, class Formula>
    [[nodiscard]] QuantityValue expand(const std::array<Local, count>& locals, const Formula& formula) const {
        constexpr int n = static_cast<int>(count) + 1;
        std::array<SecondOrder<n>, count + 1> variables;
        Jacobian<n> jacobian = Jacobian<n>::Zero();
        variables[0] = variable<n>(position_.value, 0);
        jacobian.row(0) = position_.gradient.transpose();
        for (std::size_t i = 0; i < count; ++i) {
            const int row = static_cast<int>(i) + 1;
            variables[i + 1] = variable<n>(locals[i].sign * values_(locals[i].column), row);
            jacobian(row, locals[i].column) = locals[i].sign;
        }
        const Expansion<n> local(SecondOrder<n>(std::apply(formula, variables)));
        QuantityValue result = local.substituted(jacobian);
        result.hessian += local.gradient(0) * position_.hessian;
        return result;
    }

 private:
    QuantityValue position_;
    Eigen::Matrix<double, quantity_variables, 1> values_;
};

}  // namespace camopt::expansion

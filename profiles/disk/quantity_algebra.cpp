// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_algebra.hpp"

namespace camopt {

QuantityValue constant_quantity(double value) {
    QuantityValue result{value, {}, {}};
    result.gradient.setZero();
    result.hessian.setZero();
    return result;
}

QuantityValue variable_quantity(double value, int index) {
    QuantityValue result = constant_quantity(value);
    result.gradient[index] = 1.0;
    return result;
}

QuantityValue sum(double factor_a, const QuantityValue& a, double factor_b, const QuantityValue& b) {
    return {factor_a * a.value + factor_b * b.value, factor_a * a.gradient + factor_b * b.gradient,
            factor_a * a.hessian + factor_b * b.hessian};
}

QuantityValue product(const QuantityValue& a, const QuantityValue& b) {
    QuantityValue result{a.value * b.value, a.value * b.gradient + b.value * a.gradient,
                         a.value * b.hessian + b.value * a.hessian};
    const auto cross = (a.gradient * b.gradient.transpose()).eval();
    result.hessian += cross + cross.transpose();
    return result;
}

QuantityValue quotient(const QuantityValue& a, const QuantityValue& b) {
    // 1/b has the partials −b_i/b² and 2 b_i b_j/b³ − b_ij/b².
    const double inverse = 1.0 / b.value;
    const QuantityValue reciprocal{inverse, -inverse * inverse * b.gradient,
                                   2.0 * inverse * inverse * inverse * b.gradient * b.gradient.transpose() -
                                       inverse * inverse * b.hessian};
    return product(a, reciprocal);
}

}  // namespace camopt

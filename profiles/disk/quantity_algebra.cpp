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

QuantityValue operator+(QuantityValue a, const QuantityValue& b) {
    a.value += b.value;
    a.gradient += b.gradient;
    a.hessian += b.hessian;
    return a;
}

QuantityValue operator+(QuantityValue a, double by) {
    a.value += by;
    return a;
}

QuantityValue operator*(double factor, QuantityValue a) {
    a.value *= factor;
    a.gradient *= factor;
    a.hessian *= factor;
    return a;
}

QuantityValue operator*(const QuantityValue& a, const QuantityValue& b) {
    QuantityValue result{a.value * b.value, a.value * b.gradient + b.value * a.gradient,
                         a.value * b.hessian + b.value * a.hessian};
    const auto cross = (a.gradient * b.gradient.transpose()).eval();
    result.hessian += cross + cross.transpose();
    return result;
}

}  // namespace camopt

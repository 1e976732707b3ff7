// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_value.hpp"

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

}  // namespace camopt

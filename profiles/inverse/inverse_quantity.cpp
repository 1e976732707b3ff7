// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_quantity.hpp"

#include "core/partials.hpp"
#include "profiles/inverse/inverse_formulas.hpp"

namespace camopt {

namespace {

using Value = SecondOrder<3>;

}  // namespace

InverseQuantityValue inverse_quantity(const FeederLinkage& linkage, const RollerState& roller,
                                      const FollowerState& feeder, InverseQuantity which) {
    InverseQuantityValue result;
    result.fault = wanted_guide(linkage, roller, feeder).fault;
    if (result.fault != InverseFault::none) return result;
    if (which == InverseQuantity::pressure_denominator) {
        result.value = roller.velocity;
        return result;
    }
    const auto back = inverse::backwards<Value>(
        inverse::numbers_of<Value>(linkage), inverse::branch_of(linkage),
        {variable<3>(feeder.s, 0), variable<3>(feeder.velocity, 1), variable<3>(feeder.acceleration, 2)});
    const Value value =
        which == InverseQuantity::pressure_numerator
            ? Value(-roller.distance * back.velocity)
            : inverse::guide_curvature<Value>(
                  {Value(roller.distance), Value(roller.velocity), Value(roller.acceleration)}, back);
    result.value = value.value().value();
    result.gradient = value.value().derivatives();
    result.hessian = second_partials<3>(value);
    return result;
}

}  // namespace camopt

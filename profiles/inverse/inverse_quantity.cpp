// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_quantity.hpp"

#include "profiles/inverse/inverse_formulas.hpp"

#include <unsupported/Eigen/AutoDiff>

namespace camopt {

namespace {

using First = Eigen::AutoDiffScalar<Eigen::Vector3d>;
using Second = Eigen::AutoDiffScalar<Eigen::Matrix<First, 3, 1>>;

Second variable(double value, int index) {
    Second result;
    result.value() = First(value, 3, index);
    for (int i = 0; i < 3; ++i) result.derivatives()(i) = First(i == index ? 1.0 : 0.0);
    return result;
}

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
    const auto back = inverse::backwards<Second>(
        inverse::numbers_of<Second>(linkage), inverse::branch_of(linkage),
        {variable(feeder.s, 0), variable(feeder.velocity, 1), variable(feeder.acceleration, 2)});
    const Second value =
        which == InverseQuantity::pressure_numerator
            ? Second(-roller.distance * back.velocity)
            : inverse::guide_curvature<Second>(
                  {Second(roller.distance), Second(roller.velocity), Second(roller.acceleration)}, back);
    result.value = value.value().value();
    result.gradient = value.value().derivatives();
    for (int i = 0; i < 3; ++i) result.hessian.col(i) = value.derivatives()(i).derivatives();
    return result;
}

}  // namespace camopt

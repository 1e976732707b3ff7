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

Second curvature_of(const RollerState& roller, const Second& velocity, const Second& acceleration) {
    using std::sqrt;
    const double speed = roller.velocity;
    const Second slope = Second(-velocity) / speed;
    const Second bend = -Second(acceleration + slope * roller.acceleration) / (speed * speed);
    const Second tangent = roller.distance * slope;
    const Second squared = Second(tangent * tangent);
    const Second secant = Second(squared + 1.0);
    return Second(Second(roller.distance * bend) + Second(slope * Second(squared + 2.0))) /
           Second(secant * Second(sqrt(secant)));
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
    const auto back =
        inverse::backwards<Second>(linkage, inverse::branch_of(linkage), variable(feeder.s, 0),
                                   variable(feeder.velocity, 1), variable(feeder.acceleration, 2));
    const Second value = which == InverseQuantity::pressure_numerator
                             ? Second(-roller.distance * back.velocity)
                             : curvature_of(roller, back.velocity, back.acceleration);
    result.value = value.value().value();
    result.gradient = value.value().derivatives();
    for (int i = 0; i < 3; ++i) result.hessian.col(i) = value.derivatives()(i).derivatives();
    return result;
}

}  // namespace camopt

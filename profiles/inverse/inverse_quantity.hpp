// SPDX-License-Identifier: MIT
//
// Quantities in limits of an inverse cam, from the feeder's motion, with exact first and second partials.
//
//   pressure_numerator   -L theta'     tan mu = numerator / denominator; m/s
//   pressure_denominator L'            m/s; does not depend on the feeder
//   guide_curvature      (L psi'' + psi' (2 + L² psi'²)) / (1 + L² psi'²)^(3/2), 1/m
// Partials by (Y, Y', Y''), the feeder's motion by time; the roller's motion and the linkage are given. Each
// is smooth wherever wanted_guide (inverse_feeder.hpp) has no fault. Lengths m, time s.
#pragma once

#include "profiles/inverse/inverse_feeder.hpp"

#include <Eigen/Core>

namespace camopt {

enum class InverseQuantity { pressure_numerator, pressure_denominator, guide_curvature };

struct InverseQuantityValue {
    InverseFault fault = InverseFault::none;  ///< otherwise the numbers are 0
    double value = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

[[nodiscard]] InverseQuantityValue inverse_quantity(const FeederLinkage& linkage, const RollerState& roller,
                                                    const FollowerState& feeder, InverseQuantity which);

}  // namespace camopt

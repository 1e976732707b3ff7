// SPDX-License-Identifier: MIT
// The quantities of limits, expanded to second order by automatic differentiation. All seven variables of a
// formula are those of the partials (q differs from s by a constant), so no chain rule is left to do.
#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

#include <unsupported/Eigen/AutoDiff>

namespace camopt {
namespace {

using enum SpatialDimension;

constexpr int n = spatial_variables;
using FirstOrder = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
using SecondOrder = Eigen::AutoDiffScalar<Eigen::Matrix<FirstOrder, n, 1>>;

SecondOrder variable(double value, int index) {
    SecondOrder result;
    result.value() = FirstOrder(value, n, index);
    for (int i = 0; i < n; ++i) result.derivatives()(i) = FirstOrder(i == index ? 1.0 : 0.0);
    return result;
}

SpatialValue expanded(const SecondOrder& result) {
    SpatialValue value;
    value.value = result.value().value();
    value.gradient = result.value().derivatives();
    for (int i = 0; i < n; ++i) value.hessian.col(i) = result.derivatives()(i).derivatives();
    // Mixed partials differ by rounding in the order they are taken.
    value.hessian = (0.5 * (value.hessian + value.hessian.transpose())).eval();
    return value;
}

}  // namespace

SpatialValue spatial_quantity(const SpatialCam& cam, const FollowerState& state, const RollerStation& station,
                              SpatialQuantity which) {
    const spatial_formulas::Variables<SecondOrder> variables{
        variable(cam.start + state.s, 0),
        variable(state.velocity, 1),
        variable(state.acceleration, 2),
        variable(cam[roller_radius], column_of(roller_radius)),
        variable(cam[arm_length], column_of(arm_length)),
        variable(cam[center_distance], column_of(center_distance)),
        variable(cam[lateral_offset], column_of(lateral_offset))};
    const auto motion = spatial_formulas::axis_motion(cam, variables, station.height);
    switch (which) {
        case SpatialQuantity::pressure_numerator:
            return expanded(motion.across_travel);
        case SpatialQuantity::pressure_denominator:
            return expanded(spatial_formulas::sign_of_b(cam) * motion.along_b);
        case SpatialQuantity::undercut:
            break;
    }
    return expanded(spatial_formulas::undercut(motion, variables.roller_radius, station.flank));
}

}  // namespace camopt

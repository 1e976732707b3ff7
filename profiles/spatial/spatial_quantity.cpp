// SPDX-License-Identifier: MIT
// The quantities of limits, expanded to second order by automatic differentiation. All seven variables of a
// formula are those of the partials (q differs from s by a constant), so no chain rule is needed.
#include "core/errors.hpp"
#include "core/partials.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

namespace camopt {
namespace {

using enum SpatialDimension;

using Value = SecondOrder<spatial_variables>;

Value variable(double value, int column) {
    return camopt::variable<spatial_variables>(value, column);
}

SpatialValue expanded(const Value& result) {
    SpatialValue value;
    value.value = result.value().value();
    value.gradient = result.value().derivatives();
    value.hessian = second_partials<spatial_variables>(result);
    // Mixed partials differ by rounding in the order they are taken.
    value.hessian = (0.5 * (value.hessian + value.hessian.transpose())).eval();
    return value;
}

}  // namespace

SpatialValue spatial_quantity(const SpatialCam& cam, const FollowerState& state, const RollerStation& station,
                              SpatialQuantity which) {
    const spatial_formulas::Variables<Value> variables{
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
            return expanded(spatial_formulas::undercut(motion, variables.roller_radius, station.flank));
    }
    throw ModelError("spatial cam: no known quantity");
}

}  // namespace camopt

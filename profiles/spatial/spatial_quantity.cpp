// SPDX-License-Identifier: MIT
// The quantities of limits, expanded to second order by automatic differentiation. All seven variables of a
// formula are those of the partials (q differs from s by a constant), so no chain rule is needed.
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
    value.value = result.value;
    value.gradient = result.gradient();
    value.hessian = result.hessian();
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
    return expanded(spatial_formulas::quantity_of(cam, variables, station.height, station.flank, which));
}

}  // namespace camopt

namespace camopt::spatial_formulas {
namespace {

constexpr double pi = std::numbers::pi;

const RangeOver& number(const MechanismStateOver& state, SpatialNumber which) {
    return state.dimensions[static_cast<std::size_t>(which)];
}

Variables<RangeOver> variables_over(const MechanismStateOver& state) {
    return {number(state, SpatialNumber::start) + state.s,
            state.velocity,
            state.acceleration,
            number(state, SpatialNumber::roller_radius),
            number(state, SpatialNumber::arm_length),
            number(state, SpatialNumber::center_distance),
            number(state, SpatialNumber::lateral_offset)};
}

RangeOver height_over(const MechanismStateOver& state, const PlaceOnRoller& place) {
    return place.share * number(state, SpatialNumber::roller_length);
}

/// sin u in [0, π], its tangents beyond: concave.
RangeOver continued_sine(const RangeOver& u) {
    const auto inside = [](double angle) { return std::clamp(angle, 0.0, pi); };
    const Interval part(inside(u.value.lower), inside(u.value.upper));
    const Interval below(std::min(u.value.lower, 0.0), std::min(u.value.upper, 0.0));
    const Interval above(std::max(u.value.lower, pi), std::max(u.value.upper, pi));
    const Interval bend = -sin(part);
    const bool leaves = u.value.lower < 0.0 || u.value.upper > pi;
    const Interval value = leaves ? sin(part) + below + (Interval(pi) - above) : sin(part);
    return composed(value, cos(part),
                    leaves ? Interval(std::min(bend.lower, 0.0), std::max(bend.upper, 0.0)) : bend, u);
}

RangeOver barrel_pressure(const SpatialDimensions& cam, const Variables<RangeOver>& v,
                          const RangeOver& height, const PressureLimit& limit) {
    const double side = cam.rotation == Rotation::clockwise ? -limit.sign : limit.sign;
    const RangeOver u = RangeOver(limit.angle) + side * v.position;
    const RangeOver rho = v.center_distance - height, cosine = cos(Interval(limit.angle));
    const RangeOver sine = limit.continued ? continued_sine(u) : sin(u);
    return limit.sign * (cosine * (v.arm_length * v.velocity)) - rho * sine;
}

}  // namespace

RangeOver pressure_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                        const PlaceOnRoller& place, const PressureLimit& limit) {
    const Variables<RangeOver> variables = variables_over(state);
    const RangeOver height = height_over(state, place);
    if (cam.follower == SpatialFollower::barrel) return barrel_pressure(cam, variables, height, limit);
    const AxisMotion<RangeOver> motion = axis_motion(cam, variables, height);
    const RangeOver cosine = cos(Interval(limit.angle)), sine = sin(Interval(limit.angle));
    return limit.sign * (cosine * motion.across_travel) - sign_of_b(cam) * (sine * motion.along_b);
}

RangeOver undercut_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                        const PlaceOnRoller& place, double margin) {
    Variables<RangeOver> variables = variables_over(state);
    variables.acceleration = 0.0;
    const AxisMotion<RangeOver> still = axis_motion(cam, variables, height_over(state, place));
    const RangeOver speed_squared = squared(still.across_travel) + squared(still.along_b);
    const RangeOver turn = still.turn_b * still.across_travel - still.turn_u * still.along_b;
    const RangeOver tilt = still.tilt_b * still.across_travel - still.tilt_u * still.along_b;
    const RangeOver radius = variables.roller_radius + RangeOver(0.5 * cam.form.groove_clearance);
    const double side = place.flank > 0 ? 1.0 : -1.0;
    const RangeOver room = (margin - 1.0) * (cube_of_root(speed_squared) / radius) +
                           side * (turn - 2.0 * (still.along_axis * tilt)) +
                           radius * (squared(tilt) / sqrt(speed_squared));
    const RangeOver sign = sign_of(still.along_b), size = sign * still.along_b;
    return room / (still.lever * size) - side * (sign * state.acceleration);
}

RangeOver quantity_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                        const PlaceOnRoller& place, SpatialQuantity which) {
    return quantity_of(cam, variables_over(state), height_over(state, place), place.flank, which);
}

RangeAlong quantity_along(const SpatialDimensions& cam, const MechanismStateAlong& state,
                          const RollerStation& station, SpatialQuantity which) {
    using enum SpatialDimension;
    const Variables<RangeAlong> variables{cam.start + state.s, state.velocity,  state.acceleration,
                                          cam[roller_radius],  cam[arm_length], cam[center_distance],
                                          cam[lateral_offset]};
    return quantity_of(cam, variables, station.height, station.flank, which);
}

}  // namespace camopt::spatial_formulas

// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"

namespace camopt {
namespace {

using enum DimensionIndex;

double second_roller(const DiskCam& cam) {
    return cam.form.second_roller_radius.value_or(cam[roller_radius]);
}

bool is_outer_flank(const DiskCam& cam, int side) {
    return side == 1 && cam.form.is_grooved();
}

Eigen::Vector2d mirrored_point(const Eigen::Vector2d& point) {
    return {point.x(), -point.y()};
}

// f(q) of a quantity, with f' and f'' of one variable.
QuantityValue function_of(const QuantityValue& q, double value, double first, double second) {
    return {value, first * q.gradient,
            first * q.hessian + second * (q.gradient * q.gradient.transpose()).eval()};
}

QuantityValue square_root(const QuantityValue& q) {
    const double root = std::sqrt(q.value);
    return function_of(q, root, 0.5 / root, -0.25 / (root * q.value));
}

QuantityValue given_or_first(const std::optional<double>& given, const DiskCam& cam, DimensionIndex which) {
    return given ? constant_quantity(*given) : variable_quantity(cam[which], column_of(which));
}

/// The dimensions of the second disk by those of the cam.
using SecondDimensions = std::array<QuantityValue, dimension_count>;

SecondDimensions second_dimensions(const DiskCam& cam) {
    SecondDimensions own;
    own.fill(constant_quantity(0.0));
    const auto at = [&own](DimensionIndex which) -> QuantityValue& {
        return own[static_cast<std::size_t>(which)];
    };
    at(roller_radius) = given_or_first(cam.form.second_roller_radius, cam, roller_radius);
    const QuantityValue start = rest_quantity(cam);
    QuantityValue squared;
    if (is_oscillating(cam.follower)) {
        at(center_distance) = variable_quantity(cam[center_distance], column_of(center_distance));
        at(arm_length) = given_or_first(cam.form.second_arm_length, cam, arm_length);
        const QuantityValue &a = at(center_distance), &l = at(arm_length);
        const double angle = cam.form.arm_angle - start.value, c = std::cos(angle), s = std::sin(angle);
        const QuantityValue cosine = function_of(start, c, s, -c);  // of γ − ψ0, by ψ0
        squared = a * a + l * l + -2.0 * (a * l * cosine);
    } else {
        at(offset) = given_or_first(cam.form.second_offset, cam, offset);
        const QuantityValue rest = -1.0 * start + cam.form.roller_distance;
        squared = rest * rest + at(offset) * at(offset);
    }
    at(base_radius) = square_root(squared) + -1.0 * at(roller_radius);
    return own;
}

/// A quantity of the second disk by the variables of the whole cam: (s, s', s'') change their signs, its
/// dimensions are functions of the cam's.
QuantityValue carried_over(const QuantityValue& own, const SecondDimensions& dimensions) {
    Eigen::Matrix<double, quantity_variables, quantity_variables> jacobian;
    jacobian.setZero();
    for (int k = 0; k < 3; ++k) jacobian(k, k) = -1.0;
    for (int k = 0; k < dimension_count; ++k) jacobian.row(3 + k) = dimensions[k].gradient.transpose();
    QuantityValue result;
    result.value = own.value;
    result.gradient = jacobian.transpose() * own.gradient;
    result.hessian = jacobian.transpose() * own.hessian * jacobian;
    for (int k = 0; k < dimension_count; ++k) result.hessian += own.gradient(3 + k) * dimensions[k].hessian;
    return result;
}

void set_outer_flank(const DiskCam& cam, ProfilePoint& point) {
    const double radius = surface_offset(cam, 1);
    point.normal = -point.normal;
    point.contact = point.pitch - radius * point.normal;
    point.pitch_curvature = -point.pitch_curvature;
    point.cam_radius = 1.0 / point.pitch_curvature - radius;
    point.regularity = 1.0 - radius * point.pitch_curvature;
}

ProfilePoint second_point(const DiskCam& cam, double theta, const FollowerState& state) {
    ProfilePoint point = profile_point(second_disk(cam), theta, second_state(state));
    for (Eigen::Vector2d* const vector : {&point.center, &point.pitch, &point.contact, &point.normal})
        *vector = mirrored_point(*vector);
    return point;
}

StateAlong second_along(const StateAlong& state) {
    return {-1.0 * state.s, -1.0 * state.velocity, -1.0 * state.acceleration};
}

}  // namespace

int side_count(const FormSpec& form) {
    return form.drives_both_ways() ? 2 : 1;
}

int side_count(const DiskCam& cam) {
    return side_count(cam.form);
}

std::string side_name(const FormSpec& form, int side) {
    if (form.is_grooved()) return side == 0 ? "inner flank" : "outer flank";
    if (form.is_conjugate()) return side == 0 ? "first disk" : "second disk";
    return {};
}

double roller_radius_of(const DiskCam& cam, int side) {
    if (!has_roller(cam.follower)) return 0.0;
    return side == 1 && cam.form.is_conjugate() ? second_roller(cam) : cam[roller_radius];
}

double surface_offset(const DiskCam& cam, int side) {
    const double clearance = cam.form.is_grooved() ? cam.form.groove_clearance : 0.0;
    return roller_radius_of(cam, side) + 0.5 * clearance;
}

FollowerState second_state(const FollowerState& state) {
    return {-state.s, -state.velocity, -state.acceleration};
}

double second_rest_position(const DiskCam& cam) {
    const double whole = is_oscillating(cam.follower) ? cam.form.arm_angle : cam.form.roller_distance;
    return whole - rest_position(cam);
}

DiskCam second_disk(const DiskCam& cam) {
    DiskCam second{cam.follower,
                   cam.rotation == Rotation::clockwise ? Rotation::counterclockwise : Rotation::clockwise,
                   {},
                   {}};
    const auto at = [&second](DimensionIndex which) -> double& {
        return second.dimensions[static_cast<std::size_t>(which)];
    };
    const double rest = second_rest_position(cam);
    at(roller_radius) = second_roller(cam);
    double prime = 0.0;
    if (is_oscillating(cam.follower)) {
        const double a = cam[center_distance], l = cam.form.second_arm_length.value_or(cam[arm_length]);
        at(center_distance) = a;
        at(arm_length) = l;
        prime = std::sqrt(a * a + l * l - 2.0 * a * l * std::cos(rest));
    } else {
        at(offset) = cam.form.second_offset.value_or(cam[offset]);
        prime = std::hypot(rest, second[offset]);
    }
    at(base_radius) = prime - second[roller_radius];
    return second;
}

ProfilePoint profile_point(const DiskCam& cam, double theta, const FollowerState& state, int side) {
    if (side == 1 && cam.form.is_conjugate()) return second_point(cam, theta, state);
    ProfilePoint point = profile_point(cam, theta, state);
    if (is_outer_flank(cam, side)) set_outer_flank(cam, point);
    return point;
}

QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which, int side) {
    const auto first = [&](MechanismQuantity of) { return quantity(cam, state, of); };
    if (is_outer_flank(cam, side)) {
        const double radius = surface_offset(cam, 0);
        return formulas::quantity_of_outer_flank(variable_quantity(radius, column_of(roller_radius)), first,
                                                 which);
    }
    if (side == 0 || !cam.form.is_conjugate()) return first(which);
    return carried_over(quantity(second_disk(cam), second_state(state), which), second_dimensions(cam));
}

RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which, int side) {
    const auto first = [&](MechanismQuantity of) { return quantity(cam, state, of); };
    if (is_outer_flank(cam, side))
        return formulas::quantity_of_outer_flank(RangeAlong(surface_offset(cam, 0)), first, which);
    if (side == 0 || !cam.form.is_conjugate()) return first(which);
    return quantity(second_disk(cam), second_along(state), which);
}

}  // namespace camopt

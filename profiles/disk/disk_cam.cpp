// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"

#include "core/text/quantity_text.hpp"
#include "profiles/disk/disk_cam_expansion.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using Eigen::Vector2d;
using enum DimensionIndex;

/// The vector in the frame of a cam rotated by `angle`.
Vector2d turned_back(const Vector2d& fixed, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * fixed.x() + s * fixed.y(), c * fixed.y() - s * fixed.x()};
}

template <class Roller>
void set_roller_values(const Roller& roller, double radius, ProfilePoint& point) {
    point.pitch_curvature = roller.pitch().curvature();
    point.cam_radius = 1.0 / point.pitch_curvature - radius;
    point.regularity = 1.0 - radius * point.pitch_curvature;
    point.pressure_angle = std::atan2(roller.pressure_numerator(), roller.pressure_denominator());
}

/// `turning`: rotation of the face relative to the cam, in units of the cam's.
void set_flat_values(const DiskCam& cam, double turned_radius, double turning, ProfilePoint& point) {
    point.cam_radius = turned_radius / turning;
    point.pitch_curvature = turning / turned_radius;
    point.regularity = turned_radius / cam[base_radius];
}

void set_translating_roller(const DiskCam& cam, const FollowerState& state, ProfilePoint& point) {
    const double sense = sense_of(cam.rotation);
    const double radius = has_roller(cam.follower) ? cam[roller_radius] : 0.0;
    const double start = formulas::translating_roller_start(cam[base_radius] + radius, cam[offset]);
    const formulas::TranslatingRoller<double> roller{start + state.s, state.velocity, state.acceleration,
                                                     sense * cam[offset]};
    const auto pitch = roller.pitch();
    point.center = {cam[offset], roller.position};
    point.normal = Vector2d(-sense * pitch.across, pitch.along) / pitch.speed();
    set_roller_values(roller, surface_offset(cam, 0), point);
}

void set_translating_flat(const DiskCam& cam, const FollowerState& state, ProfilePoint& point) {
    const double height = cam[base_radius] + state.s;
    point.contact_offset = sense_of(cam.rotation) * state.velocity;
    point.center = {point.contact_offset, height};
    point.normal = Vector2d::UnitY();
    set_flat_values(cam, height + state.acceleration, 1.0, point);
}

void set_oscillating_roller(const DiskCam& cam, const FollowerState& state, ProfilePoint& point) {
    const double start = formulas::oscillating_roller_start(cam[base_radius] + cam[roller_radius],
                                                            cam[center_distance], cam[arm_length]);
    const formulas::OscillatingRoller<double> roller{start + state.s, sense_of(cam.rotation) * state.velocity,
                                                     state.acceleration, cam[center_distance],
                                                     cam[arm_length]};
    const auto pitch = roller.pitch();
    const double c = std::cos(roller.position), s = std::sin(roller.position);
    const Vector2d arm(-c, s), swing(s, c);
    point.center = Vector2d(cam[center_distance], 0.0) + cam[arm_length] * arm;
    point.normal = (pitch.across * arm + pitch.along * swing) / pitch.speed();
    set_roller_values(roller, surface_offset(cam, 0), point);
}

void set_oscillating_flat(const DiskCam& cam, const FollowerState& state, ProfilePoint& point) {
    const double start =
        formulas::oscillating_flat_start(cam[base_radius], cam[center_distance], cam[face_offset]);
    const formulas::OscillatingFlat<double> flat{start + state.s, sense_of(cam.rotation) * state.velocity,
                                                 state.acceleration, cam[center_distance], cam[face_offset]};
    const double c = std::cos(flat.position), s = std::sin(flat.position);
    const Vector2d arm(-c, s), swing(s, c);
    point.contact_offset = flat.contact_offset();
    point.center =
        Vector2d(cam[center_distance], 0.0) - cam[face_offset] * swing + point.contact_offset * arm;
    point.normal = swing;
    point.pressure_angle = std::atan2(flat.pressure_numerator(), flat.pressure_denominator());
    set_flat_values(cam, flat.turned_radius(), flat.turning(), point);
}

void set_in_fixed_frame(const DiskCam& cam, const FollowerState& state, ProfilePoint& point) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return set_translating_roller(cam, state, point);
        case FollowerType::translating_flat:
            return set_translating_flat(cam, state, point);
        case FollowerType::oscillating_roller:
            return set_oscillating_roller(cam, state, point);
        case FollowerType::oscillating_flat:
            return set_oscillating_flat(cam, state, point);
    }
}

// Whether one cam can be built: at rest, and over the whole range of its motion. Every distance below grows
// with s as long as the conditions before it hold, so the two extremes of s decide.

std::string dimension_fault(const DiskCam& cam) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (!has_dimension(cam.follower, index)) continue;
        const bool has_sign = index == offset || index == face_offset;
        if (std::string fault = length_fault(name_of(index), cam[index], has_sign); !fault.empty())
            return fault;
    }
    return {};
}

/// The roller's circle (the knife's edge) must not contain the cam's centre.
std::string center_fault(double distance, double radius) {
    if (distance > radius) return {};
    return fmt::format("at its lowest the follower's centre is {} from the cam centre and its radius is {}",
                       length_text(distance), length_text(radius));
}

std::string translating_roller_fault(const DiskCam& cam, double least) {
    const double radius = has_roller(cam.follower) ? cam[roller_radius] : 0.0;
    const double prime = cam[base_radius] + radius;
    if (!(std::abs(cam[offset]) < prime))
        return fmt::format("the offset of {} is not below the prime radius of {}", length_text(cam[offset]),
                           length_text(prime));
    const double height = formulas::translating_roller_start(prime, cam[offset]) + least;
    if (!(height > 0.0))
        return fmt::format("at its lowest the follower is {} above the cam centre", length_text(height));
    return center_fault(std::hypot(height, cam[offset]), radius);
}

std::string translating_flat_fault(const DiskCam& cam, double least) {
    const double height = cam[base_radius] + least;
    if (height > 0.0) return {};
    return fmt::format("at its lowest the face is {} above the cam centre", length_text(height));
}

std::string oscillating_roller_fault(const DiskCam& cam, double least, double most) {
    const double a = cam[center_distance], l = cam[arm_length], radius = cam[roller_radius];
    const double prime = cam[base_radius] + radius;
    if (!(std::abs(a - l) < prime && prime < a + l))
        return fmt::format("a prime radius of {} does not lie between {} and {}, the reach of the arm",
                           length_text(prime), length_text(std::abs(a - l)), length_text(a + l));
    const double start = formulas::oscillating_roller_start(prime, a, l);
    if (!(start + least > 0.0 && start + most < std::numbers::pi))
        return fmt::format("the arm swings from {} to {} and passes the line of centres",
                           angle_text(start + least), angle_text(start + most));
    return center_fault(std::sqrt(a * a + l * l - 2.0 * a * l * std::cos(start + least)), radius);
}

std::string oscillating_flat_fault(const DiskCam& cam, double least, double most) {
    const double a = cam[center_distance], f = cam[face_offset];
    if (!(std::abs(cam[base_radius] + f) < a))
        return fmt::format(
            "base radius and face offset together, {}, are not below the center distance of {}",
            length_text(cam[base_radius] + f), length_text(a));
    const double start = formulas::oscillating_flat_start(cam[base_radius], a, f);
    const double right_angle = 0.5 * std::numbers::pi;
    if (!(start + least > -right_angle && start + most < right_angle))
        return fmt::format("the face swings from {} to {}, beyond a right angle to the line of centres",
                           angle_text(start + least), angle_text(start + most));
    const double height = a * std::sin(start + least) - f;
    if (height > 0.0) return {};
    return fmt::format("at its lowest the face is {} above the cam centre", length_text(height));
}

std::string one_disk_fault(const DiskCam& cam, double least, double most) {
    if (std::string fault = dimension_fault(cam); !fault.empty()) return fault;
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return translating_roller_fault(cam, least);
        case FollowerType::translating_flat:
            return translating_flat_fault(cam, least);
        case FollowerType::oscillating_roller:
            return oscillating_roller_fault(cam, least, most);
        case FollowerType::oscillating_flat:
            return oscillating_flat_fault(cam, least, most);
    }
    throw ModelError("a follower of no known type");
}

/// Inside the groove, and on the cam's other side.
std::string form_fault(const DiskCam& cam, double least, double most) {
    if (cam.form.is_grooved()) {
        const double inner = cam[base_radius] - 0.5 * cam.form.groove_clearance;
        if (inner > 0.0) return {};
        return fmt::format("the groove's clearance leaves the inner flank a base circle of {}",
                           length_text(inner));
    }
    if (!cam.form.is_conjugate()) return {};
    const double rest = second_rest_position(cam);
    const bool swings = is_oscillating(cam.follower);
    if (!(rest - most > 0.0) || (swings && !(rest - least < std::numbers::pi)))
        return fmt::format("the second roller would pass the {}: {} is left at the largest displacement",
                           swings ? "line of centres" : "cam centre",
                           swings ? angle_text(rest - most) : length_text(rest - most));
    const std::string fault = one_disk_fault(second_disk(cam), -most, -least);
    return fault.empty() ? fault : "second disk: " + fault;
}

}  // namespace

ProfilePoint profile_point(const DiskCam& cam, double theta, const FollowerState& state) {
    ProfilePoint point;
    point.theta = theta;
    set_in_fixed_frame(cam, state, point);
    const double turn = sense_of(cam.rotation) * theta;
    point.pitch = turned_back(point.center, turn);
    point.normal = turned_back(point.normal, turn);
    point.contact = point.pitch;
    if (has_roller(cam.follower)) point.contact -= surface_offset(cam, 0) * point.normal;
    return point;
}

double rest_position(const DiskCam& cam) {
    using enum DimensionIndex;
    switch (cam.follower) {
        case FollowerType::translating_flat:
            return cam[base_radius];
        case FollowerType::oscillating_roller:
            return formulas::oscillating_roller_start(cam[base_radius] + cam[roller_radius],
                                                      cam[center_distance], cam[arm_length]);
        case FollowerType::oscillating_flat:
            return formulas::oscillating_flat_start(cam[base_radius], cam[center_distance], cam[face_offset]);
        case FollowerType::translating_roller:
            return formulas::translating_roller_start(cam[base_radius] + cam[roller_radius], cam[offset]);
        case FollowerType::translating_knife:
            return formulas::translating_roller_start(cam[base_radius], cam[offset]);
    }
    throw ModelError("a follower of no known type");
}

std::string geometry_fault(const DiskCam& cam, double least, double most) {
    std::string fault = one_disk_fault(cam, least, most);
    return fault.empty() ? form_fault(cam, least, most) : fault;
}

namespace {

// Position of the follower on the base circle, by the dimensions.

/// The start as a function of the prime radius (base radius without a roller) and further dimensions.
template <int count>
QuantityValue by_dimensions(const DiskCam& cam, const SecondOrder<count + 1>& start,
                            const std::array<DimensionIndex, static_cast<std::size_t>(count)>& further) {
    expansion::Jacobian<count + 1> jacobian = expansion::Jacobian<count + 1>::Zero();
    jacobian(0, column_of(base_radius)) = 1.0;
    if (has_roller(cam.follower)) jacobian(0, column_of(roller_radius)) = 1.0;
    int row = 0;
    for (const DimensionIndex dimension : further) jacobian(++row, column_of(dimension)) = 1.0;
    return expansion::Expansion<count + 1>(start).substituted(jacobian);
}

QuantityValue translating_roller_start(const DiskCam& cam, double prime_radius) {
    const auto prime = variable<2>(prime_radius, 0), offset_variable = variable<2>(cam[offset], 1);
    return by_dimensions<1>(cam, formulas::translating_roller_start(prime, offset_variable), {offset});
}

QuantityValue oscillating_roller_start(const DiskCam& cam, double prime_radius) {
    const auto prime = variable<3>(prime_radius, 0), distance = variable<3>(cam[center_distance], 1),
               arm = variable<3>(cam[arm_length], 2);
    return by_dimensions<2>(cam, formulas::oscillating_roller_start(prime, distance, arm),
                            {center_distance, arm_length});
}

QuantityValue oscillating_flat_start(const DiskCam& cam) {
    const auto base = variable<3>(cam[base_radius], 0), distance = variable<3>(cam[center_distance], 1),
               face = variable<3>(cam[face_offset], 2);
    return by_dimensions<2>(cam, formulas::oscillating_flat_start(base, distance, face),
                            {center_distance, face_offset});
}

}  // namespace

QuantityValue rest_quantity(const DiskCam& cam) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
            return translating_roller_start(cam, cam[base_radius] + cam[roller_radius]);
        case FollowerType::translating_knife:
            return translating_roller_start(cam, cam[base_radius]);
        case FollowerType::translating_flat:
            return variable_quantity(cam[base_radius], column_of(base_radius));
        case FollowerType::oscillating_roller:
            return oscillating_roller_start(cam, cam[base_radius] + cam[roller_radius]);
        case FollowerType::oscillating_flat:
            return oscillating_flat_start(cam);
    }
    throw ModelError("quantity: a follower of no known type");
}

namespace {

// The quantities of limits, with first and second partials.

using expansion::acceleration_column, expansion::velocity_column;
using expansion::Expander, expansion::Local;

/// Slope of a linear quantity by the variable of that column.
struct Term {
    int column = 0;
    double slope = 0.0;
};

template <std::size_t count>
QuantityValue linear(double value, const std::array<Term, count>& terms) {
    QuantityValue result = constant_quantity(value);
    for (const Term& term : terms) result.gradient(term.column) = term.slope;
    return result;
}

/// Of the arm: σψ', ψ'', and two of its dimensions.
std::array<Local, 4> arm_locals(const DiskCam& cam, DimensionIndex first, DimensionIndex second) {
    return {{{velocity_column, sense_of(cam.rotation)},
             {acceleration_column},
             {column_of(first)},
             {column_of(second)}}};
}

/// `locals` and the position determine the roller. The regularity follows from the curvature: expanding it in
/// the roller's radius too would cost half as much again.
template <template <class> class Roller, std::size_t count>
QuantityValue roller_quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which,
                              const std::array<Local, count>& locals) {
    const bool regular = which == MechanismQuantity::regularity && has_roller(cam.follower);
    const MechanismQuantity expanded = regular ? MechanismQuantity::pitch_curvature : which;
    QuantityValue found = Expander(rest_quantity(cam), cam, state)
                              .expand(locals, [&]<class T>(const T& position, const auto&... rest) {
                                  return formulas::quantity_of_roller<T>(
                                      cam.follower, Roller<T>{position, rest...}, T(0.0), expanded);
                              });
    if (!regular) return found;
    return formulas::regularity_of(variable_quantity(surface_offset(cam, 0), column_of(roller_radius)),
                                   found);
}

QuantityValue translating_roller_quantity(const DiskCam& cam, const FollowerState& state,
                                          MechanismQuantity which) {
    const double sense = sense_of(cam.rotation);
    // Linear in the motion: exact, and cheaper than the expansion.
    if (which == MechanismQuantity::pressure_numerator)
        return linear(state.velocity - sense * cam[offset],
                      std::array<Term, 2>{{{velocity_column, 1.0}, {column_of(offset), -sense}}});
    if (which == MechanismQuantity::pressure_denominator)
        return Expander(rest_quantity(cam), cam, state).position();
    const std::array<Local, 3> locals = {
        {{velocity_column}, {acceleration_column}, {column_of(offset), sense}}};
    return roller_quantity<formulas::TranslatingRoller>(cam, state, which, locals);
}

QuantityValue translating_flat_quantity(const DiskCam& cam, const FollowerState& state,
                                        MechanismQuantity which) {
    const std::array<Local, 3> locals = {
        {{velocity_column, sense_of(cam.rotation)}, {acceleration_column}, {column_of(base_radius)}}};
    return Expander(rest_quantity(cam), cam, state)
        .expand(locals,
                [&]<class T>(const T& height, const T& velocity, const T& acceleration, const T& base) {
                    return formulas::quantity_of_face<T>(base, height, velocity, acceleration, which);
                });
}

QuantityValue oscillating_flat_quantity(const DiskCam& cam, const FollowerState& state,
                                        MechanismQuantity which) {
    const Expander expander(rest_quantity(cam), cam, state);
    const auto locals = arm_locals(cam, center_distance, face_offset);
    if (which != MechanismQuantity::regularity)
        return expander.expand(locals, [&]<class T>(const T& position, const auto&... rest) {
            return formulas::quantity_of_face_arm<T>(T(1.0), {position, rest...}, which);
        });
    std::array<Local, 5> all;
    all[0] = {column_of(base_radius)};
    std::ranges::copy(locals, all.begin() + 1);
    return expander.expand(all, [&]<class T>(const T& position, const T& base, const auto&... rest) {
        return formulas::quantity_of_face_arm<T>(base, {position, rest...}, which);
    });
}

}  // namespace

QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return translating_roller_quantity(cam, state, which);
        case FollowerType::translating_flat:
            return translating_flat_quantity(cam, state, which);
        case FollowerType::oscillating_roller:
            return roller_quantity<formulas::OscillatingRoller>(cam, state, which,
                                                                arm_locals(cam, center_distance, arm_length));
        case FollowerType::oscillating_flat:
            return oscillating_flat_quantity(cam, state, which);
    }
    throw ModelError("quantity: a follower of no known type");
}

}  // namespace camopt

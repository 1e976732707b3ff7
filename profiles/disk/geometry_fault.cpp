// SPDX-License-Identifier: MIT
// Whether one cam can be built: at rest, and over the whole range of its motion. Every distance below grows
// with s as long as the conditions before it hold, so the two extremes of s decide.
#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/disk_sides.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace {

using enum DimensionIndex;

std::string length_text(double value) {
    return fmt::format("{:.6g} mm", value / 1e-3);
}
std::string angle_text(double value) {
    return fmt::format("{:.6g} deg", value * 180.0 / std::numbers::pi);
}

std::string dimension_fault(const DiskCam& cam) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (!has_dimension(cam.follower, index)) continue;
        if (!std::isfinite(cam[index])) return fmt::format("the {} is not a number", name_of(index));
        const bool has_sign = index == offset || index == face_offset;
        if (!has_sign && !(cam[index] > 0.0))
            return fmt::format("the {} of {} is not positive", name_of(index), length_text(cam[index]));
    }
    return {};
}

/// The roller's circle (the knife's edge) leaves room for the cam's centre.
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
        return fmt::format("a prime radius of {} does not lie between {} and {}, what the arm reaches",
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

}  // namespace

namespace {

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
        return fmt::format(
            "the second roller would pass the {}: {} is left where the follower stands highest",
            swings ? "line of centres" : "cam centre",
            swings ? angle_text(rest - most) : length_text(rest - most));
    const std::string fault = one_disk_fault(second_disk(cam), -most, -least);
    return fault.empty() ? fault : "second disk: " + fault;
}

}  // namespace

std::string geometry_fault(const DiskCam& cam, double least, double most) {
    std::string fault = one_disk_fault(cam, least, most);
    return fault.empty() ? form_fault(cam, least, most) : fault;
}

}  // namespace camopt

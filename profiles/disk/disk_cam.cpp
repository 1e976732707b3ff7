// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"

#include "core/errors.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/disk_sides.hpp"

#include <cmath>

namespace camopt {
namespace {

using Eigen::Vector2d;
using enum DimensionIndex;

/// The vector seen from the cam that has turned by `angle`.
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

/// `turning` of the face against the cam, in units of the cam's own.
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

}  // namespace

DiskCam middle_cam(const DiskSpec& spec) {
    DiskCam cam{spec.follower, spec.rotation, {}, spec.form};
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i) cam.dimensions[i] = spec.dimensions[i].middle();
    return cam;
}

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

}  // namespace camopt

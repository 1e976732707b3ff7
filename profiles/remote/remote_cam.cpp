// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_cam.hpp"

#include "core/errors.hpp"
#include "profiles/remote/remote_numbers.hpp"

#include <fmt/format.h>

#include <array>

namespace camopt {
namespace {

double sign_of_branch(const CamSpec& spec, const char* name) {
    return chosen(spec, name, std::array{RemoteBranch::left, RemoteBranch::right}) == RemoteBranch::left
               ? 1.0
               : -1.0;
}

Eigen::Vector3d in_cam_frame(const remote::Vector<double>& fixed, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * fixed.x + s * fixed.y, c * fixed.y - s * fixed.x, 0.0};
}

}  // namespace

RemoteCam::RemoteCam(const CamSpec& spec)
    : linkage_(chosen(
          spec, "linkage",
          std::array{RemoteLinkage::lever, RemoteLinkage::lever_coupler_slider,
                     RemoteLinkage::lever_coupler_lever, RemoteLinkage::lever_coupler_lever_coupler_slider})),
      rotation_(spec.rotation),
      pressure_point_(chosen(spec, "pressure_angle_at",
                             std::array{PressurePoint::roller_center, PressurePoint::contact_point})),
      lever_branch_(sign_of_branch(spec, "lever_branch")),
      rocker_branch_(sign_of_branch(spec, "rocker_branch")) {
    if (spec.dimensions.size() != remote_dimension_count)
        throw InputError(fmt::format("a cam of type \"remote\": found {} dimensions; allowed: {}",
                                     spec.dimensions.size(), remote_dimension_count));
    const auto roller = remote::evaluation(*this, spec.middle()).roller({0.0, 0.0, 0.0});
    if (roller.across < 0.0) side_ = -1.0;
}

std::shared_ptr<const CamMechanism> remote_mechanism(const CamSpec& spec) {
    return std::make_shared<RemoteCam>(spec);
}

CamSpec remote_spec(RemoteLinkage linkage) {
    CamSpec spec = blank_remote_spec(linkage);
    spec.make = remote_mechanism;
    return spec;
}

RemoteCam RemoteCam::measured_at(PressurePoint where) const {
    RemoteCam other = *this;
    other.pressure_point_ = where;
    return other;
}

double RemoteCam::length(std::span<const double> dimensions) const {
    const auto at = [&](RemoteDimension which) { return dimensions[static_cast<std::size_t>(which)]; };
    return std::hypot(at(RemoteDimension::lever_pivot_x) - at(RemoteDimension::center_x),
                      at(RemoteDimension::lever_pivot_y) - at(RemoteDimension::center_y));
}

RemoteCam::LeverState RemoteCam::lever(const MechanismState& state) const {
    const auto own = remote::evaluation(*this, state.dimensions);
    const remote::Turning<double> arm = own.linkage.roller_arm(state.output.s);
    const remote::RollerState<double> roller = own.roller(remote::numbers(state.output));
    return {std::atan2(arm.direction.y, arm.direction.x), roller.velocity, roller.acceleration};
}

MechanismPoint RemoteCam::point(double theta, const MechanismState& state, int) const {
    const auto own = remote::evaluation(*this, state.dimensions);
    const remote::RollerState<double> roller = own.roller(remote::numbers(state.output));
    const remote::Vector<double> arm = own.linkage.roller_arm(state.output.s).direction;
    const remote::Vector<double> swing = remote::across(arm);
    const double radius = own.linkage[RemoteDimension::roller_radius], speed = roller.speed();
    const auto fixed = [&](double along, double across) {
        return remote::sum(remote::scaled(along, arm), remote::scaled(across, swing));
    };
    const double turn = own.sense * theta;
    MechanismPoint point;
    point.theta = theta;
    point.pitch = in_cam_frame(fixed(roller.along, roller.across), turn);
    point.normal = in_cam_frame(fixed(roller.normal_along() / speed, roller.normal_across() / speed), turn);
    point.contact = point.pitch - radius * point.normal;
    point.pressure_angle = std::atan2(own.numerator(roller), own.denominator(roller));
    point.pitch_curvature = roller.curvature();
    point.cam_radius = 1.0 / point.pitch_curvature - radius;
    point.regularity = own.regularity(roller);
    return point;
}

}  // namespace camopt

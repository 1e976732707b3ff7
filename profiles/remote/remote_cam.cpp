// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_cam.hpp"

#include "core/errors.hpp"
#include "core/text/quantity_text.hpp"
#include "profiles/remote/remote_formulas.hpp"

#include <fmt/format.h>

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

// Whether a linkage reaches over its whole motion, and which dyad does not and by how much. Sampled so
// densely that what happens between samples is below manufacturing accuracy.

constexpr int places = 256;

std::string output_text(RemoteLinkage linkage, double s) {
    return output_swings(linkage) ? angle_text(s) : length_text(s);
}

struct DyadNames {
    const char* arm;
    const char* coupler;
};

std::string dyad_fault(const remote::Dyad<double>& dyad, const remote::Vector<double>& far,
                       const DyadNames& names) {
    const remote::Vector<double> v = remote::difference(far, dyad.pivot);
    const double distance = std::hypot(v.x, v.y);
    const double least = std::abs(dyad.arm - dyad.coupler), most = dyad.arm + dyad.coupler;
    if (distance > least && distance < most) return {};
    const bool short_of = distance >= most;
    return fmt::format("the {} of {} and the {} of {} {} by {}: their far ends are {} apart", names.arm,
                       length_text(dyad.arm), names.coupler, length_text(dyad.coupler),
                       short_of ? "are too short" : "cannot fold so far",
                       length_text(short_of ? distance - most : least - distance), length_text(distance));
}

std::string reach_fault(const remote::Linkage<double>& linkage, double s) {
    if (linkage.type == RemoteLinkage::lever) return {};
    if (linkage.type == RemoteLinkage::lever_coupler_lever_coupler_slider) {
        std::string fault =
            dyad_fault(linkage.rocker_dyad(), linkage.slider(s).at, {"rocker_output_arm", "second_coupler"});
        if (!fault.empty()) return fault;
    }
    return dyad_fault(linkage.lever_dyad(), linkage.far_joint(s).at, {"lever_arm", "coupler"});
}

std::string roller_fault(const RemoteEvaluation<double>& own, double s) {
    const remote::RollerState<double> roller = own.roller({s, 0.0, 0.0});
    if (!(own.side * roller.across > 0.0))
        return "the roller's arm points along the line to the cam's centre: the cam cannot move it";
    const double distance = std::hypot(roller.along, roller.across);
    const double radius = own.linkage[RemoteDimension::roller_radius];
    if (distance > radius) return {};
    return fmt::format("the roller's centre is {} from the cam's centre and its radius is {}",
                       length_text(distance), length_text(radius));
}

std::string dimension_fault(RemoteLinkage linkage, std::span<const double> dimensions) {
    for (int i = 0; i < remote_dimension_count; ++i) {
        const auto which = static_cast<RemoteDimension>(i);
        if (!has_dimension(linkage, which)) continue;
        std::string fault =
            length_fault(name_of(which), dimensions[static_cast<std::size_t>(i)], has_sign(which));
        if (!fault.empty()) return fault;
    }
    return {};
}

}  // namespace

RemoteCam::RemoteCam(const CamSpec& spec)
    : layout_{
          .linkage = chosen(spec, "linkage",
                            std::array{RemoteLinkage::lever, RemoteLinkage::lever_coupler_slider,
                                       RemoteLinkage::lever_coupler_lever,
                                       RemoteLinkage::lever_coupler_lever_coupler_slider}),
          .rotation = spec.rotation,
          .pressure_point = chosen(spec, "pressure_angle_at",
                                   std::array{PressurePoint::roller_center, PressurePoint::contact_point}),
          .lever_branch = sign_of_branch(spec, "lever_branch"),
          .rocker_branch = sign_of_branch(spec, "rocker_branch")} {
    if (spec.dimensions.size() != remote_dimension_count)
        throw InputError(fmt::format("a cam of type \"remote\": found {} dimensions; allowed: {}",
                                     spec.dimensions.size(), remote_dimension_count));
    const auto roller = remote::evaluation(layout_, spec.middle()).roller({0.0, 0.0, 0.0});
    if (roller.across < 0.0) layout_.side = -1.0;
}

std::shared_ptr<const CamMechanism> remote_mechanism(const CamSpec& spec) {
    return std::make_shared<RemoteCam>(spec);
}

CamSpec remote_spec(RemoteLinkage linkage) {
    CamSpec spec = blank_remote_spec(linkage);
    spec.make = remote_mechanism;
    return spec;
}

double RemoteCam::length(std::span<const double> dimensions) const {
    const auto at = [&](RemoteDimension which) { return dimensions[static_cast<std::size_t>(which)]; };
    return std::hypot(at(RemoteDimension::lever_pivot_x) - at(RemoteDimension::center_x),
                      at(RemoteDimension::lever_pivot_y) - at(RemoteDimension::center_y));
}

RemoteCam::LeverState RemoteCam::lever(const MechanismState& state) const {
    const auto own = remote::evaluation(layout_, state.dimensions);
    const remote::Turning<double> arm = own.linkage.roller_arm(state.output.s);
    const remote::RollerState<double> roller = own.roller(remote::numbers(state.output));
    return {std::atan2(arm.direction.y, arm.direction.x), roller.velocity, roller.acceleration};
}

MechanismPoint RemoteCam::point(double theta, const MechanismState& state, int) const {
    const auto own = remote::evaluation(layout_, state.dimensions);
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

std::string RemoteCam::fault(std::span<const double> dimensions, double least, double most) const {
    if (std::string found = dimension_fault(layout_.linkage, dimensions); !found.empty()) return found;
    const auto own = remote::evaluation(layout_, dimensions);
    for (int i = 0; i <= places; ++i) {
        const double s = least + (most - least) * i / places;
        std::string found = reach_fault(own.linkage, s);
        if (found.empty()) found = roller_fault(own, s);
        if (!found.empty())
            return fmt::format("at displacement {} {}", output_text(layout_.linkage, s), found);
    }
    return {};
}

}  // namespace camopt

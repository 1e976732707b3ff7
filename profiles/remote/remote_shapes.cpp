// SPDX-License-Identifier: MIT
// The linkage as shapes to draw, and followed forwards by positions alone.
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_formulas.hpp"

namespace camopt {
namespace {

using Kind = MechanismShape::Kind;

Eigen::Vector2d vector(const remote::Vector<double>& v) {
    return {v.x, v.y};
}

void add_slider(const remote::Linkage<double>& linkage, double s, std::vector<MechanismShape>& shapes) {
    shapes.push_back({Kind::guide, "slider", {vector(linkage.slider(0.0).at), vector(linkage.slider(s).at)}});
}

void add_rocker(const remote::Linkage<double>& linkage, double s, std::vector<MechanismShape>& shapes) {
    const Eigen::Vector2d pivot = vector(linkage.rocker_pivot()), input = vector(linkage.far_joint(s).at);
    shapes.push_back({Kind::pivot, "rocker_pivot", {pivot}});
    if (linkage.type == RemoteLinkage::lever_coupler_lever) {
        shapes.push_back({Kind::link, "rocker", {pivot, input}});
        return;
    }
    const remote::Joint<double> output = remote::end_of(
        linkage.rocker_pivot(), linkage[RemoteDimension::rocker_output_arm], linkage.rocker(s));
    shapes.push_back({Kind::link, "rocker", {input, pivot, vector(output.at)}});
    shapes.push_back({Kind::link, "second_coupler", {vector(output.at), vector(linkage.slider(s).at)}});
}

using Eigen::Vector2d;

double at(std::span<const double> dimensions, RemoteDimension which) {
    return dimensions[static_cast<std::size_t>(which)];
}

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vector2d direction_of(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// Where circles about two centres meet; branch +1: left of the line from the first centre to the second.
Vector2d meeting(const Vector2d& first, double first_radius, const Vector2d& second, double second_radius,
                 double branch) {
    const Vector2d line = second - first;
    const double distance = line.norm();
    const double along =
        0.5 * (distance + (first_radius - second_radius) * (first_radius + second_radius) / distance);
    const double height = std::sqrt(first_radius * first_radius - along * along);
    const Vector2d unit = line / distance;
    return first + along * unit + branch * height * Vector2d(-unit.y(), unit.x());
}

}  // namespace

std::vector<MechanismShape> RemoteCam::shapes(const MechanismState& state) const {
    const auto own = remote::evaluation(layout_, state.dimensions);
    const remote::Linkage<double>& linkage = own.linkage;
    const double s = state.output.s;
    const remote::Vector<double> pivot = linkage.lever_pivot();
    const remote::Vector<double> arm = linkage.roller_arm(s).direction;
    const Eigen::Vector2d roller =
        vector(remote::sum(pivot, remote::scaled(linkage[RemoteDimension::roller_arm], arm)));
    std::vector<MechanismShape> shapes = {
        {Kind::pivot,
         "cam_center",
         {vector(linkage.at(RemoteDimension::center_x, RemoteDimension::center_y))}},
        {Kind::pivot, "lever_pivot", {vector(pivot)}},
        {Kind::circle, "roller", {roller}, linkage[RemoteDimension::roller_radius]},
        {Kind::link, "lever", {roller, vector(pivot)}}};
    if (linkage.type == RemoteLinkage::lever) return shapes;
    const remote::Vector<double> joint =
        remote::turned(arm, remote::direction(linkage[RemoteDimension::lever_angle]));
    const Eigen::Vector2d end =
        vector(remote::sum(pivot, remote::scaled(linkage[RemoteDimension::lever_arm], joint)));
    shapes.back().points.push_back(end);
    shapes.push_back({Kind::link, "coupler", {end, vector(linkage.far_joint(s).at)}});
    if (linkage.type != RemoteLinkage::lever_coupler_slider) add_rocker(linkage, s, shapes);
    if (!output_swings(linkage.type)) add_slider(linkage, s, shapes);
    return shapes;
}

RemoteLinkageForward::RemoteLinkageForward(const RemoteCam& cam, std::span<const double> dimensions)
    : linkage_(cam.linkage()), dimensions_(dimensions.begin(), dimensions.end()) {
    if (linkage_ == RemoteLinkage::lever) return;
    const auto own = remote::evaluation(cam.layout(), dimensions);
    const remote::Vector<double> joint = own.linkage.far_joint(0.0).at;
    const Vector2d far(joint.x, joint.y);
    const Vector2d lever = lever_joint(cam.lever({dimensions, {}}).angle);
    const Vector2d pivot(at(dimensions, RemoteDimension::rocker_pivot_x),
                         at(dimensions, RemoteDimension::rocker_pivot_y));
    far_branch_ = cross(lever - pivot, far - pivot) >= 0.0 ? 1.0 : -1.0;
    if (output_swings(linkage_)) return;
    Vector2d last = lever;
    if (linkage_ == RemoteLinkage::lever_coupler_lever_coupler_slider) {
        const remote::Joint<double> end =
            remote::end_of(own.linkage.rocker_pivot(), own.linkage[RemoteDimension::rocker_output_arm],
                           own.linkage.rocker(0.0));
        last = {end.at.x, end.at.y};
    }
    const Vector2d slider(at(dimensions, RemoteDimension::slider_x),
                          at(dimensions, RemoteDimension::slider_y));
    const Vector2d way = direction_of(at(dimensions, RemoteDimension::slider_angle));
    slider_branch_ = way.dot(slider - last) >= 0.0 ? 1.0 : -1.0;
}

Vector2d RemoteLinkageForward::lever_joint(double angle) const {
    return Vector2d(at(dimensions_, RemoteDimension::lever_pivot_x),
                    at(dimensions_, RemoteDimension::lever_pivot_y)) +
           at(dimensions_, RemoteDimension::lever_arm) *
               direction_of(angle + at(dimensions_, RemoteDimension::lever_angle));
}

double RemoteLinkageForward::slid(const Vector2d& joint, double coupler) const {
    const Vector2d start(at(dimensions_, RemoteDimension::slider_x),
                         at(dimensions_, RemoteDimension::slider_y));
    const Vector2d way = direction_of(at(dimensions_, RemoteDimension::slider_angle));
    const double aside = cross(way, joint - start);
    return way.dot(joint - start) + slider_branch_ * std::sqrt(coupler * coupler - aside * aside);
}

double RemoteLinkageForward::output(double angle) const {
    using enum RemoteDimension;
    if (linkage_ == RemoteLinkage::lever)
        return std::remainder(angle - at(dimensions_, output_angle), 2.0 * std::numbers::pi);
    const Vector2d joint = lever_joint(angle);
    const double coupler_length = at(dimensions_, coupler);
    if (linkage_ == RemoteLinkage::lever_coupler_slider) return slid(joint, coupler_length);
    const Vector2d pivot(at(dimensions_, rocker_pivot_x), at(dimensions_, rocker_pivot_y));
    const Vector2d arm =
        meeting(pivot, at(dimensions_, rocker_input_arm), joint, coupler_length, far_branch_) - pivot;
    const double input = std::atan2(arm.y(), arm.x());
    if (linkage_ == RemoteLinkage::lever_coupler_lever)
        return std::remainder(input - at(dimensions_, output_angle), 2.0 * std::numbers::pi);
    const Vector2d end =
        pivot + at(dimensions_, rocker_output_arm) * direction_of(input - at(dimensions_, rocker_angle));
    return slid(end, at(dimensions_, second_coupler));
}

std::optional<FollowerGeometry> RemoteCam::follower(std::span<const double> dimensions, int) const {
    using enum RemoteDimension;
    const Vector2d center(at(dimensions, center_x), at(dimensions, center_y));
    const Vector2d pivot(at(dimensions, lever_pivot_x), at(dimensions, lever_pivot_y));
    FollowerGeometry found =
        follower_on_lever({pivot - center, at(dimensions, roller_arm),
                           at(dimensions, RemoteDimension::roller_radius), lever({dimensions, {}}).angle});
    found.linkage = [forward = RemoteLinkageForward(*this, dimensions)](double angle) {
        return forward.output(angle);
    };
    return found;
}

}  // namespace camopt

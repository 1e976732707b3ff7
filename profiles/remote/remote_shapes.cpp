// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_numbers.hpp"

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

}  // namespace

std::vector<MechanismShape> RemoteCam::shapes(const MechanismState& state) const {
    const auto own = remote::evaluation(*this, state.dimensions);
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

}  // namespace camopt

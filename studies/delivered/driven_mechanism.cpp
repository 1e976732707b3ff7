// SPDX-License-Identifier: MIT
#include "studies/delivered/driven_mechanism.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/between_ends.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt {

MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, int count, int station) {
    const std::vector<double> breakpoints = motion.breakpoints();
    MechanismProfile profile;
    for (const double x : even_places(breakpoints, count)) {
        const MotionPoint point = motion_at(motion, x);
        if (std::ranges::binary_search(breakpoints, x))
            profile.breaks.push_back(static_cast<int>(profile.points.size()));
        profile.points.push_back(mechanism_point(mechanism, point, scale, station));
        profile.outputs.push_back(scale.lift * point.derivative[0]);
    }
    return profile;
}

namespace {

EnclosedLimit along(const PointRule& rule, const Motion& motion) {
    const MaximaAlong found = maxima_along(rule, motion, Eigen::VectorXd());
    const Extremum largest = largest_of(found.maxima);
    return {rule.name(), largest.value / rule.scale(), largest.at, found.complete};
}

/// 1/ρ_cam + 1/r of a roller, which may be a little smaller than what the surface is offset by.
double contact_curvature(const DrivenMechanism& cam, const MechanismPoint& point, int station) {
    if (!cam.formulas->radius_quantity()) return 1.0 / point.contact_radius;
    if (cam.formulas->contact() != ContactKind::roller) return 1.0 / point.cam_radius;
    const int index = cam.formulas->roller_radius_at(station);
    const double roller = cam.dimensions[static_cast<std::size_t>(index)],
                 wider = cam.formulas->surface_offset(cam.dimensions, station) - roller;
    return (1.0 - wider * point.pitch_curvature) / (roller * point.regularity);
}

}  // namespace

std::vector<EnclosedLimit> enclosed_limits(const Scene& scene, const DrivenMechanism& cam,
                                           const Motion& motion) {
    CamVariables variables;
    variables.cam = cam;
    variables.scale = {scene.motion.lift, scene.motion.unit_angle()};
    std::vector<EnclosedLimit> all;
    for (const auto& rule : cam_limits(scene, variables)) {
        all.push_back(along(*rule, motion));
        if (!rule->at_every_station()) all.back().complete = false;
        all.back().made = made_cam_of(*rule);
    }
    if (!scene.tolerance) return all;
    for (const BetweenEnds& one : between_ends(scene, variables, motion))
        all.push_back({one.rule->name(),
                       one.worst,
                       one.at,
                       one.enclosed && one.rule->at_every_station(),
                       {},
                       one.parts});
    return all;
}

bool is_verified(const std::vector<EnclosedLimit>& limits, const std::string& key) {
    // A rule on a dimension of the cam is named without the unit that the scene gives it in.
    const auto has_key = [&](const EnclosedLimit& limit) {
        return key == limit.key || key.starts_with(limit.key + "_");
    };
    return std::ranges::any_of(limits, has_key) &&
           std::ranges::all_of(limits,
                               [&](const EnclosedLimit& limit) { return !has_key(limit) || limit.complete; });
}

double normal_force(const DrivenMechanism& cam, const FollowerState& state, double force, int station) {
    const double lever =
        cam.formulas->quantity(MechanismQuantity::normal_lever, {cam.dimensions, state}, station, {}).value;
    return cam.formulas->pressing_sense(station) * force / lever;
}

int carrying_side(const CamMechanism& cam, double force) {
    return cam.sides() > 1 && force < 0.0 ? 1 : 0;
}

double hertz_pressure(const DrivenMechanism& cam, const ForceSpec& forces, const MechanismPoint& point,
                      double normal_force, int station) {
    const double curvature = contact_curvature(cam, point, station);
    const double squared =
        normal_force * curvature / (forces.compliance() * std::numbers::pi * forces.contact_width.value());
    return squared > 0.0 ? std::sqrt(squared) : 0.0;
}

bool has_hertz_pressure(const CamMechanism& cam, const ForceSpec& forces) {
    return forces.contact_width && cam.contact() != ContactKind::edge;
}

FollowerLoads follower_loads(const DrivenMechanism& cam, const ForceSpec& forces, double force,
                             const FollowerState& state,
                             const std::function<MechanismPoint(int station)>& point_of) {
    FollowerLoads loads;
    loads.force = force;
    loads.torque = loads.force * state.velocity;
    if (const std::optional<double> slide = cam.formulas->slide(cam.dimensions))
        loads.driving_force = loads.torque / *slide;
    loads.side = carrying_side(*cam.formulas, loads.force);
    bool first = true;
    for (int station = 0; station < cam.formulas->stations(); ++station) {
        if (cam.formulas->sides() > 1 && cam.formulas->side_of(station) != loads.side) continue;
        const double normal = normal_force(cam, state, loads.force, station);
        if (first || normal > loads.normal_force) loads.normal_force = normal;
        first = false;
        if (!has_hertz_pressure(*cam.formulas, forces)) continue;
        loads.hertz_pressure = std::max(loads.hertz_pressure.value_or(0.0),
                                        hertz_pressure(cam, forces, point_of(station), normal, station));
    }
    return loads;
}

}  // namespace camopt

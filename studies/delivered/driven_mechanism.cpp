// SPDX-License-Identifier: MIT
#include "studies/delivered/driven_mechanism.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"

#include <algorithm>

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
    }
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

}  // namespace camopt

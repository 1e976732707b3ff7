// SPDX-License-Identifier: MIT
#include "studies/delivered/driven_mechanism.hpp"

#include <algorithm>

namespace camopt {

MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                               const MotionScale& scale, int station) {
    const double theta = scale.unit_angle * motion.x;
    return mechanism.formulas->point(theta, {mechanism.dimensions, state_of(motion, scale), theta}, station);
}

MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, int count, int station) {
    const std::vector<double> breakpoints = motion.breakpoints();
    MechanismProfile profile;
    for (const double x : even_places(breakpoints, count)) {
        const MotionPoint point = motion.at(x, x < motion.end() ? Side::right : Side::left);
        if (std::ranges::binary_search(breakpoints, x))
            profile.breaks.push_back(static_cast<int>(profile.points.size()));
        profile.points.push_back(mechanism_point(mechanism, point, scale, station));
        profile.outputs.push_back(scale.lift * point.derivative[0]);
    }
    return profile;
}

}  // namespace camopt

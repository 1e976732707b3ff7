// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_points.hpp"

namespace camopt {

const MechanismPoint& CamPoints::at(const MotionPoint& motion, int station) const {
    const FollowerState state = state_of(motion, scale_);
    const auto [found, is_new] =
        points_.try_emplace({scale_.unit_angle * motion.x, state.velocity, state.acceleration, station});
    if (is_new) found->second = mechanism_point(cam_, motion, scale_, station);
    return found->second;
}

std::size_t CamPoints::PlaceHash::operator()(const Place& place) const {
    return std::hash<double>()(std::get<0>(place)) + static_cast<std::size_t>(std::get<3>(place));
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/spatial/roller_path.hpp"

namespace camopt {

RollerPath roller_path(const SpatialCam& cam, const FollowerMotion& motion) {
    return [cam, motion](double theta, double station) {
        const FollowerState state = motion.state(theta);
        const SpatialPoint point = spatial_point(cam, theta, state, {station, 1});
        return RollerPose{point.center, roller_axis(cam, theta, state.s).direction, point.normal};
    };
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The disk cam that tests of programs and solids share.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "report/drawing/profile_shape.hpp"

#include <cmath>
#include <numbers>

namespace camopt::testing_support {

/// A roller of 10 mm on a base circle of 40 mm, pushed along its centre.
inline DrivenMechanism roller_cam() {
    DiskCam cam;
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 40e-3;
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] = 10e-3;
    return disk_mechanism(cam);
}

inline MechanismPoint point_at(const DrivenMechanism& cam, double theta, const FollowerState& state) {
    return cam.formulas->point(theta, {cam.dimensions, state, theta}, 0);
}

/// roller_cam with a harmonic of `lift`; lift 0: a circle.
inline ProfileShape harmonic_disk(double lift, double end = 2.0 * std::numbers::pi) {
    ProfileShape shape;
    shape.cam = roller_cam();
    shape.at = [cam = shape.cam, lift](double theta) {
        const double half = 0.5 * lift;
        return point_at(cam, theta,
                        {half * (1.0 - std::cos(theta)), half * std::sin(theta), half * std::cos(theta)});
    };
    shape.knots = {0.0, end};
    shape.closed = end == 2.0 * std::numbers::pi;
    return shape;
}

}  // namespace camopt::testing_support

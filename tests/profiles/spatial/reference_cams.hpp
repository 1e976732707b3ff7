// SPDX-License-Identifier: MIT
// The reference cams: the paper-cup machine's barrel cam, an indexing cam with a rotating follower, a
// cylindrical cam with a translating follower; each with its motion over one turn.
// Known of the barrel cam (paper 002): 160/200 deg, 360/7 deg, r = 31.75, roller length 38.1, r_i = 164 mm.
// Chosen: everything else.
#pragma once

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "scene/cam_flanks.hpp"
#include "tests/profiles/test_turn.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace camopt::test {

using units::degree;
using units::millimetre;

/// Rest to `from`, then the law over (from, from + width) by `lift`, then rest to the end; rad.
inline FollowerMotion rise_motion(double from, double width, double lift, double begin, double end) {
    const std::shared_ptr<const Law> law = make_law("modified_sine");
    FollowerMotion motion;
    motion.state = [=](double theta) -> FollowerState {
        const double x = (theta - from) / width;
        if (x <= 0.0) return {};
        if (x >= 1.0) return {lift, 0.0, 0.0};
        const auto y = law->at(x).derivative;
        return {lift * y[0], lift / width * y[1], lift / (width * width) * y[2]};
    };
    motion.breakpoints = {begin, from, from + 0.125 * width, from + 0.875 * width, from + width};
    if (end > from + width + 1e-12) motion.breakpoints.push_back(end);
    return motion;
}

/// 164 mm index of seven rollers; roller 0 runs from -pi/7 to pi/7.
inline SpatialCam barrel_cam() {
    const double index_radius = 164.0 * millimetre;
    SpatialCam cam;
    cam.follower = SpatialFollower::barrel;
    cam.dimensions = {31.75 * millimetre, index_radius, 150.0 * millimetre,
                      0.5 * index_radius * (1.0 + std::cos(std::numbers::pi / 7.0))};
    cam.start = -std::numbers::pi / 7.0;
    cam.roller_length = 38.1 * millimetre;
    return cam;
}

/// Dwell to 200 deg, then one seventh of a turn in 160 deg.
inline FollowerMotion barrel_motion() {
    return rise_motion(200.0 * degree, 160.0 * degree, full_turn / 7.0, 0.0, full_turn);
}

/// dx = dz = 0, dy = 150, f_l = 70, roller 8 x 20 mm, eight rollers; the paper's cam turns clockwise.
inline SpatialCam rotating_cam() {
    SpatialCam cam;
    cam.follower = SpatialFollower::cylindrical_rotating;
    cam.rotation = Rotation::clockwise;
    cam.dimensions = {8.0 * millimetre, 70.0 * millimetre, 150.0 * millimetre, 0.0};
    cam.start = -22.5 * degree;
    cam.roller_length = 20.0 * millimetre;
    return cam;
}

/// Dwell to 180 deg, then 45 deg in 180 deg.
inline FollowerMotion rotating_motion() {
    return rise_motion(180.0 * degree, 180.0 * degree, 45.0 * degree, 0.0, full_turn);
}

/// rho0 = 60, roller 10 x 15 mm, 40 mm in 150 deg.
inline SpatialCam translating_cam() {
    SpatialCam cam;
    cam.follower = SpatialFollower::cylindrical_translating;
    cam.dimensions = {10.0 * millimetre, 0.0, 60.0 * millimetre, 0.0};
    cam.roller_length = 15.0 * millimetre;
    return cam;
}
inline FollowerMotion translating_motion() {
    return rise_motion(100.0 * degree, 150.0 * degree, 40.0 * millimetre, 0.0, full_turn);
}

}  // namespace camopt::test

// SPDX-License-Identifier: MIT
// A cam that is the guide of a roller in a body that swings, as its forward check sees it: where the roller
// is, where the body must be, and what an error of the body moves the output by. Made by CamMechanism::guide
// (cam_mechanism.hpp). m, rad.
#pragma once

#include "core/motion.hpp"

#include <functional>

namespace camopt {

struct RollerGuide {
    double roller_radius = 0.0;
    /// From the body's pivot to the roller's centre at a cam angle; ascending.
    std::function<double(double theta)> distance;
    std::function<double(double distance)> cam_angle;  ///< its inverse
    /// ψ: polar angle of the roller's centre in the body where the output is in this state.
    std::function<double(const FollowerState& output)> angle;
    std::function<double(double angle)> ratio;  ///< |d output / dψ| where the body is at ψ
};

}  // namespace camopt

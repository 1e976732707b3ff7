// SPDX-License-Identifier: MIT
// What a normalised set point is in units: s = y · lift, ds/dθ = y' · lift / angle, ds/dt = y' · lift · speed
// / angle.
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// The normalisation of a stretch's set points. SI, rad.
struct SetPointScale {
    double angle = 1.0, lift = 1e-3;
    std::optional<double> speed;
};

/// SI value of one normalised unit of the derivative of `order` (0 to 3), by time or by the cam angle.
/// Throws InputError by time without a speed.
[[nodiscard]] inline double set_point_unit(const SetPointScale& scale, int order, bool in_time) {
    if (in_time && !scale.speed)
        throw InputError("a set point in time: found no speed; allowed: together with motion.speed");
    return scale.lift * std::pow((in_time ? *scale.speed : 1.0) / scale.angle, order);
}

}  // namespace camopt

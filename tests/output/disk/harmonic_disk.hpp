// SPDX-License-Identifier: MIT
// The disk cam that tests of programs and solids share.
#pragma once

#include "output/drawing/profile_shape.hpp"

#include <cmath>
#include <numbers>

namespace camopt::testing_support {

/// A roller of 10 mm on a base circle of 40 mm, a harmonic of `lift`; lift 0: a circle.
inline ProfileShape harmonic_disk(double lift, double end = 2.0 * std::numbers::pi) {
    constexpr double millimetre = 1e-3;
    ProfileShape shape;
    shape.cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 40.0 * millimetre;
    shape.cam.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] = 10.0 * millimetre;
    shape.at = [cam = shape.cam, lift](double theta) {
        const double half = 0.5 * lift;
        return profile_point(
            cam, theta, {half * (1.0 - std::cos(theta)), half * std::sin(theta), half * std::cos(theta)});
    };
    shape.knots = {0.0, end};
    shape.closed = end == 2.0 * std::numbers::pi;
    return shape;
}

}  // namespace camopt::testing_support

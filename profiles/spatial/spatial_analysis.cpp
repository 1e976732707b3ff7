// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_analysis.hpp"

#include "core/numbers/extremum.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

namespace camopt {
namespace {

using enum SpatialDimension;

constexpr int height_steps = 16;     // g is smooth over a roller
constexpr int height_sections = 40;  // golden sections between two of them
constexpr double end_share = 1e-12;  // of the motion: pieces are searched from this far inside their ends

/// Of function(θ) over the motion.
template <class Function>
Extremum largest_over(const FollowerMotion& motion, const Function& function) {
    const double inset = end_share * (motion.end() - motion.begin());
    return largest_along(motion.breakpoints, [&](double theta, Side side) {
        return function(side == Side::left ? theta - inset : theta + inset);
    });
}

spatial_formulas::AxisMotion<double> motion_at(const SpatialCam& cam, const FollowerMotion& motion,
                                               double theta, double height) {
    return spatial_formulas::axis_motion(cam, spatial_formulas::variables_of(cam, motion.state(theta)),
                                         height);
}

/// Of −g over the cam angle.
Extremum worst_undercut(const SpatialCam& cam, const FollowerMotion& motion, const RollerStation& station) {
    return largest_over(motion, [&](double theta) {
        return -spatial_formulas::undercut(motion_at(cam, motion, theta, station.height), cam[roller_radius],
                                           station.flank);
    });
}

}  // namespace

SpatialExtreme largest_pressure_angle(const SpatialCam& cam, const FollowerMotion& motion, double height) {
    const double sign = spatial_formulas::sign_of_b(cam);
    const Extremum worst = largest_over(motion, [&](double theta) {
        const auto axis = motion_at(cam, motion, theta, height);
        return std::abs(std::atan2(axis.across_travel, sign * axis.along_b));
    });
    return {worst.value, worst.at, height};
}

SpatialExtreme least_undercut(const SpatialCam& cam, const FollowerMotion& motion, int flank,
                              const HeightRange& heights) {
    const auto worst = [&](double height) { return worst_undercut(cam, motion, {height, flank}); };
    const double step = (heights.to - heights.from) / height_steps;
    int highest = 0;
    double value = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= height_steps; ++i)
        if (const double now = worst(heights.from + i * step).value; now > value) {
            value = now;
            highest = i;
        }
    double height = heights.from + highest * step;
    if (highest > 0 && highest < height_steps)
        height = golden_maximum([&](double place) { return worst(place).value; }, height - step,
                                height + step, height_sections)
                     .place();
    else if (highest == height_steps)
        height = heights.to;
    const Extremum found = worst(height);
    return {-found.value, found.at, height};
}

}  // namespace camopt

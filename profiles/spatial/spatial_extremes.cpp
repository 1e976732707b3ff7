// SPDX-License-Identifier: MIT
#include "core/numbers/extremum.hpp"
#include "profiles/spatial/spatial_analysis.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt {
namespace {

using enum SpatialDimension;

constexpr int height_steps = 16;     // g is smooth over a roller
constexpr int height_sections = 40;  // golden sections between two of them
constexpr int bisections = 60;       // to neighbouring doubles
constexpr int search_steps = 64;     // of the centre distance, until g < 0 is met
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

std::optional<SpatialExtreme> critical_roller_radius(const SpatialCam& cam, const FollowerMotion& motion,
                                                     const RollerStation& station) {
    // 1/r is smooth and bounded where r may be infinite: r = 2/(b + sqrt(b² + 4 t²)), b = σ_f bend.
    const double side = station.flank > 0 ? 1.0 : -1.0;
    const Extremum worst = largest_over(motion, [&](double theta) {
        const auto terms = spatial_formulas::undercut_terms(motion_at(cam, motion, theta, station.height));
        const double bend = side * terms.bend;
        return 0.5 * (bend + std::hypot(bend, 2.0 * terms.twist));
    });
    if (!(worst.value > 0.0)) return std::nullopt;
    return SpatialExtreme{1.0 / worst.value, worst.at, station.height};
}

std::optional<SpatialExtreme> critical_center_distance(const SpatialCam& cam, const FollowerMotion& motion,
                                                       const RollerStation& station) {
    const auto worst = [&](double distance) {
        SpatialCam moved = cam;
        moved[center_distance] = distance;
        return worst_undercut(moved, motion, station);
    };
    const bool arm_reaches = cam.follower == SpatialFollower::cylindrical_rotating;
    const double least = arm_reaches ? cam[arm_length] + station.height : station.height;
    double regular = cam[center_distance];
    if (worst(regular).value >= 0.0) return std::nullopt;
    const double step = (regular - least) / search_steps;
    double undercut = regular - step;
    for (int i = 2; i < search_steps && worst(undercut).value < 0.0; ++i) {
        regular = undercut;
        undercut -= step;
    }
    if (worst(undercut).value < 0.0) return std::nullopt;
    const auto is_regular = [&](double value) { return worst(value).value < 0.0; };
    undercut = bisected(is_regular, {regular, undercut}, bisections).without;
    return SpatialExtreme{undercut, worst(undercut).at, station.height};
}

}  // namespace camopt

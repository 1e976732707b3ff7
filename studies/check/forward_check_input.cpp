// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

constexpr double same_angle = 1e-9;  // rad; also of the base radius: two points are one

}  // namespace

ForwardCheckInput forward_check_input(const DiskCam& cam, const Motion& motion, const MotionScale& scale,
                                      int points) {
    std::vector<Eigen::Vector2d> found;
    std::vector<int> breaks;
    const std::vector<double> breakpoints = motion.breakpoints();
    ProfileSampling sampling;
    sampling.count = points;
    for (const ProfilePoint& point : sampled_profile(cam, motion, scale, sampling)) {
        const double x = point.theta / scale.unit_angle, near = same_angle / std::abs(scale.unit_angle);
        const auto next = std::lower_bound(breakpoints.begin(), breakpoints.end(), x - near);
        if (next != breakpoints.end() && *next <= x + near) breaks.push_back(static_cast<int>(found.size()));
        found.push_back(point.contact);
    }
    return forward_check_input(cam, motion, scale, std::move(found), std::move(breaks));
}

ForwardCheckInput forward_check_input(const DiskCam& cam, const Motion& motion, const MotionScale& scale,
                                      std::vector<Eigen::Vector2d> points, std::vector<int> breaks) {
    ForwardCheckInput input;
    input.cam = cam;
    input.points = std::move(points);
    input.breaks = std::move(breaks);
    input.begin = scale.unit_angle * motion.begin();
    input.end = scale.unit_angle * motion.end();
    const bool turn = std::abs(input.end - input.begin - units::turn) < same_angle;
    const double gap = (input.points.back() - input.points.front()).norm();
    input.closed = turn && gap < same_angle * cam[DimensionIndex::base_radius];
    input.designed = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return scale.lift * motion.at(x).derivative[0];
    };
    return input;
}

}  // namespace camopt

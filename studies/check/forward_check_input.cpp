// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double same_angle = 1e-9;  // rad; also of the base radius: two points are one

}  // namespace

ForwardCheckInput forward_check_input(const DiskCam& cam, const Motion& motion, const MotionScale& scale,
                                      int points) {
    ForwardCheckInput input;
    input.cam = cam;
    const std::vector<double> breakpoints = motion.breakpoints();
    ProfileSampling sampling;
    sampling.count = points;
    for (const ProfilePoint& point : sampled_profile(cam, motion, scale, sampling)) {
        const double x = point.theta / scale.unit_angle, near = same_angle / std::abs(scale.unit_angle);
        const auto next = std::lower_bound(breakpoints.begin(), breakpoints.end(), x - near);
        if (next != breakpoints.end() && *next <= x + near)
            input.breaks.push_back(static_cast<int>(input.points.size()));
        input.points.push_back(point.contact);
    }
    input.begin = scale.unit_angle * motion.begin();
    input.end = scale.unit_angle * motion.end();
    const bool turn = std::abs(input.end - input.begin - 2.0 * std::numbers::pi) < same_angle;
    const double gap = (input.points.back() - input.points.front()).norm();
    input.closed = turn && gap < same_angle * cam[DimensionIndex::base_radius];
    input.designed = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return scale.lift * motion.at(x).derivative[0];
    };
    return input;
}

}  // namespace camopt

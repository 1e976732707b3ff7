// SPDX-License-Identifier: MIT
#include "profiles/inverse/guide_points.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt {

GuidePoints guide_points(const Guide& guide, int count, double offset) {
    if (count < 2)
        throw InputError(fmt::format("{} points of the guide were requested; it needs at least 2", count));
    const double step = (guide.end() - guide.begin()) / (count - 1);
    GuidePoints result;
    const auto add = [&](double distance, Side side) {
        const GuidePoint point = guide.at(distance, side);
        const Eigen::Vector2d normal(-point.tangent.y(), point.tangent.x());
        result.distances.push_back(distance);
        result.points.push_back(point.position + offset * normal);
    };
    const std::vector<double>& joints = guide.joints();
    add(joints.front(), Side::right);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const double length = joints[i + 1] - joints[i];
        const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
        for (int k = 1; k < steps; ++k) add(joints[i] + length * k / steps, Side::right);
        add(joints[i + 1], Side::left);
        if (i + 2 < joints.size()) result.breaks.push_back(static_cast<int>(result.points.size()) - 1);
    }
    return result;
}

std::string wall_fault(const Guide& guide, double roller_radius) {
    constexpr int points_a_piece = 1000;
    const std::vector<double>& joints = guide.joints();
    double sharpest = 0.0, place = joints.front();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        for (int k = 0; k <= points_a_piece; ++k) {
            const double distance = k == points_a_piece
                                        ? joints[i + 1]
                                        : joints[i] + (joints[i + 1] - joints[i]) * k / points_a_piece;
            const double curvature =
                std::abs(guide.at(distance, k == 0 ? Side::right : Side::left).curvature);
            if (curvature <= sharpest) continue;
            sharpest = curvature;
            place = distance;
        }
    }
    if (sharpest * roller_radius < 1.0) return {};
    return fmt::format(
        "the guide's radius of curvature is {} m at L = {} m, less than the roller's radius of {} m",
        1.0 / sharpest, place, roller_radius);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/surface/weight_hull.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace camopt {

namespace {

// A point this far above a plane, relative to its height, sees the triangle from above.
constexpr double above = 1e-13;
// Triangles of less than this part of the whole have no inside: their corners lie on one line.
constexpr double least_area = 1e-14;

}  // namespace

WeightHull::WeightHull(const std::array<double, 3>& heights) : heights_(heights.begin(), heights.end()) {
    for (int k = 0; k < 3; ++k) points_.emplace_back(Eigen::Vector3d::Unit(k));
    add_triangle(0, 1, 2);
}

void WeightHull::add_triangle(int a, int b, int c) {
    Eigen::Matrix3d corners;
    corners << weights(a).transpose(), weights(b).transpose(), weights(c).transpose();
    if (std::abs(corners.determinant()) < least_area) return;
    const Eigen::Vector3d lifted(height(a), height(b), height(c));
    triangles_.push_back({{a, b, c}, corners.partialPivLu().solve(lifted)});
}

int WeightHull::add(const Eigen::Vector3d& weights, double height) {
    const int added = static_cast<int>(points_.size());
    points_.push_back(weights);
    heights_.push_back(height);
    // Everything that the new point sees from above goes; its border is joined to the point.
    std::set<std::pair<int, int>> border;
    std::erase_if(triangles_, [&](const HullTriangle& triangle) {
        if (!(weights.dot(triangle.plane) < height - above * std::max(1.0, std::abs(height)))) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = triangle.corners[k], to = triangle.corners[(k + 1) % 3];
            if (border.erase({to, from}) == 0) border.insert({from, to});
        }
        return true;
    });
    for (const auto& [from, to] : border) add_triangle(from, to, added);
    return added;
}

double WeightHull::at(const Eigen::Vector3d& weights) const {
    double least = std::numeric_limits<double>::infinity();
    for (const HullTriangle& triangle : triangles_) least = std::min(least, weights.dot(triangle.plane));
    return least;
}

}  // namespace camopt

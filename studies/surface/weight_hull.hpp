// SPDX-License-Identifier: MIT
// Heights over the triangle of all weights of three terms, and the least concave function above them.
//
// A weight point is (w_V, w_A, w_J) >= 0 with sum 1. The graph of the function is the upper side of the
// convex hull of the points lifted to their heights: triangles over the weights, each in a plane w · plane.
#pragma once

#include <Eigen/Core>

#include <array>
#include <limits>
#include <vector>

namespace camopt {

struct HullTriangle {
    std::array<int, 3> corners{};  ///< points of the hull
    Eigen::Vector3d plane;         ///< its height at w is w · plane
    /// Free for whoever looks at triangles one by one; of a new one not yet known.
    double gap = std::numeric_limits<double>::infinity();
    Eigen::Vector3d widest = Eigen::Vector3d::Zero();
    bool settled = false;
};

class WeightHull {
 public:
    /// Heights over (1, 0, 0), (0, 1, 0), (0, 0, 1): points 0, 1, 2.
    explicit WeightHull(const std::array<double, 3>& heights);

    /// The point's number. What lies on or below the hull changes nothing of it.
    int add(const Eigen::Vector3d& weights, double height);

    [[nodiscard]] const Eigen::Vector3d& weights(int point) const {
        return points_[static_cast<std::size_t>(point)];
    }
    [[nodiscard]] double height(int point) const { return heights_[static_cast<std::size_t>(point)]; }
    [[nodiscard]] std::vector<HullTriangle>& triangles() { return triangles_; }
    [[nodiscard]] const std::vector<HullTriangle>& triangles() const { return triangles_; }
    /// The function at these weights: the least of all planes, hence never above the hull by rounding.
    [[nodiscard]] double at(const Eigen::Vector3d& weights) const;

 private:
    void add_triangle(int a, int b, int c);

    std::vector<Eigen::Vector3d> points_;
    std::vector<double> heights_;
    std::vector<HullTriangle> triangles_;
};

}  // namespace camopt

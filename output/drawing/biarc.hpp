// SPDX-License-Identifier: MIT
// Two arcs between two points with given directions, and how far a point lies from them.
//
// Control polygon P0, P0 + d T0, P1 − d T1, P1 with |(P1 − d T1) − (P0 + d T0)| = 2 d; the arcs meet in the
// middle of that side. With v = P1 − P0, t = T0 + T1, c = T0 · T1:
//
//     d = v·v / (v·t + sqrt((v·t)² + 2 (1 − c) v·v)),
//
// which stays well-conditioned where the points lie on a line.
#pragma once

#include <Eigen/Core>

#include <array>

namespace camopt {

/// A point with the unit direction of travel.
struct DirectedPoint {
    Eigen::Vector2d position, direction;
};

/// The arc from `start`, tangent to its direction, to `end`. A straight line has bulge and curvature 0.
struct Arc {
    DirectedPoint start;
    Eigen::Vector2d end;
    double bulge = 0.0;      ///< tan(angle / 4), > 0 turns to the left
    double curvature = 0.0;  ///< signed as the bulge, 1/m
};

/// The arc is the one the start's direction asks for; `end` lies ahead of it.
[[nodiscard]] Arc arc_between(const DirectedPoint& start, const Eigen::Vector2d& end);

[[nodiscard]] std::array<Arc, 2> biarc(const DirectedPoint& start, const DirectedPoint& end);

/// From the point along its unit normal to the nearer crossing with the pair's circles; the arc ahead of or
/// behind their joint. Infinite where the normal misses the circle.
[[nodiscard]] double distance_along_normal(const std::array<Arc, 2>& pair, const Eigen::Vector2d& point,
                                           const Eigen::Vector2d& normal);

}  // namespace camopt

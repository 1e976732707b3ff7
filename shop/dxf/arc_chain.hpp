// SPDX-License-Identifier: MIT
// A smooth plane curve as a chain of circular arcs (biarcs) within a tolerance: what CAD and CAM systems
// read.
//
// Between two points of the curve stand two arcs that touch each other and, at the points, the curve's own
// tangents (control lengths equal at both ends). Each pair reaches as far as the tolerance allows; its
// deviation is of the third order in that length. Deviation: from dense points of the true curve to the chain
// along the curve's normal. Lengths in m; nothing here knows a cam. Source: K. M. Bolton, Biarc curves,
// Computer-Aided Design 7 (1975).
#pragma once

#include "report/drawing/drawing.hpp"

namespace camopt {

/// A point of a plane curve and its unit normal, to either side.
struct CurvePoint {
    Eigen::Vector2d position, normal;
};
using PlaneCurve = std::function<CurvePoint(double parameter)>;

struct ArcChainOptions {
    double tolerance = 1e-6;             ///< m, > 0: the largest deviation wanted
    double longest_step = 0.5235987756;  ///< of the parameter, > 0: a pair of arcs reaches no further

    void validate() const;  ///< throws InputError
};

struct ArcChain {
    std::vector<ArcVertex> vertices;  ///< closed: the last arc ends at the first vertex; open: its bulge is 0
    bool closed = false;
    int arcs = 0;
    double deviation = 0.0;  ///< m; above the tolerance only where the curve is not smooth between the knots
};

/// knots: ascending parameters, at least two; between them the curve is smooth, its curvature may jump there
/// and its direction may reverse (a cusp). `closed`: its end is its beginning. Throws InputError for knots
/// that do not ascend, a closed curve whose ends are apart, and points that are not finite.
[[nodiscard]] ArcChain arc_chain(const PlaneCurve& curve, std::span<const double> knots, bool closed,
                                 const ArcChainOptions& options = {});

/// Of its vertices from the origin.
[[nodiscard]] double largest_radius(const ArcChain& chain);

// Two arcs between two points with given directions, and how far a point lies from them.
//
// Control polygon P0, P0 + d T0, P1 − d T1, P1 with |(P1 − d T1) − (P0 + d T0)| = 2 d; the arcs meet in the
// middle of that side. With v = P1 − P0, t = T0 + T1, c = T0 · T1:
//
//     d = v·v / (v·t + sqrt((v·t)² + 2 (1 − c) v·v)),
//
// which stays well-conditioned where the points lie on a line.

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

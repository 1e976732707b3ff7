// SPDX-License-Identifier: MIT
// The guide of a curvilinear inverse cam: the path of the roller's centre, fixed to the swinging body.
//
// The body turns about the origin; the roller's centre moves along the +x axis of the fixed frame at (L, 0).
// In the body's frame the guide is psi(L), the polar angle of its point at the distance L from the pivot, so
// the body is at theta = -psi(L). A guide is a chain of lines, arcs and polar splines along which L
// grows. With tau the angle of the tangent (towards growing L) and mu = tau - psi the pressure angle,
//   tan mu = L psi',   psi'' = (kappa - sin mu / L) / (L cos³ mu) - tan mu / L²
// for any plane curve of curvature kappa; ' is d/dL. Where kappa jumps, psi'' jumps.
// Lengths m, angles rad counterclockwise, kappa > 0 where the guide bends to the left.
// Errors: InputError for pieces that do not meet, that pass the pivot, or on which L does not grow (the
// roller would have two places: a branch), naming the piece; and for a distance that is not on the guide.
// Source: J.-H. Shin, Y.-H. Choi, C.-S. Rho, Kinematic Analysis and Simulation of an Automatic Feeding
// Mechanism Subjected by a Curvilinear Inverse Cam (I), eqs. 1 to 12, corrected (docs/papers/000.md).
#pragma once

#include "core/numbers/extremum.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"

#include <Eigen/Core>

#include <variant>

namespace camopt {

struct GuideLine {
    Eigen::Vector2d begin, end;
};

struct GuideArc {
    Eigen::Vector2d begin, end, center;  ///< the shorter of both arcs
};

/// Quintic between neighbouring nodes, taking over psi, psi', psi'' of both: C2. Nodes by growing distance,
/// >= 2.
struct GuidePolarSpline {
    std::vector<PolarNode> nodes;
};

using GuidePiece = std::variant<GuideLine, GuideArc, GuidePolarSpline>;

struct GuidePoint {
    double distance = 0.0, angle = 0.0, slope = 0.0, bend = 0.0;  ///< L, psi, psi', psi''
    double pressure_angle = 0.0;                                  ///< mu
    double curvature = 0.0;                                       ///< kappa
    Eigen::Vector2d position, tangent;                            ///< body's frame; unit tangent
};

enum class Reach { within, before_guide, beyond_guide };

class Guide {
 public:
    explicit Guide(std::vector<GuidePiece> pieces);

    [[nodiscard]] double begin() const { return joints_.front(); }  ///< least L
    [[nodiscard]] double end() const { return joints_.back(); }     ///< largest L
    /// L where pieces meet, begin and end included.
    [[nodiscard]] const std::vector<double>& joints() const { return joints_; }
    [[nodiscard]] Reach reach(double distance) const;
    /// At a joint the piece on `side`. Throws InputError beyond the reach.
    [[nodiscard]] GuidePoint at(double distance, Side side = Side::right) const;
    /// Largest step of the tangent's angle at a joint: 0 for a G1 guide, up to round-off.
    [[nodiscard]] double largest_kink() const;

 private:
    std::vector<GuidePiece> pieces_;
    std::vector<double> joints_;
};

// The guide as points, for drawings and manufacturing: its middle line and the two walls of the slot for a
// roller of radius r, middle ± r n, n the left normal. Body's frame, m.

/// Whole only where r |curvature| < 1 on the concave side of every point (wall_fault).
struct GuidePoints {
    std::vector<double> distances;  ///< L
    std::vector<Eigen::Vector2d> points;
    std::vector<int> breaks;  ///< indices of the guide's joints, without the ends
};

/// About `count` points evenly by L, the joints besides. offset: 0 the middle line, +r the left wall, -r the
/// right. Throws InputError for fewer than 2.
[[nodiscard]] GuidePoints guide_points(const Guide& guide, int count, double offset = 0.0);

/// Why a roller of this radius cannot run in the guide: its radius of curvature is smaller somewhere. Empty:
/// it can. Curvature is sampled on a fine grid (1000 points per piece), both sides of every joint.
[[nodiscard]] std::string wall_fault(const Guide& guide, double roller_radius);

}  // namespace camopt

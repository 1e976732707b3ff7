// SPDX-License-Identifier: MIT
// Heights over the triangle of all weights of three terms, and the least concave function above them.
//
// A weight point is (w_V, w_A, w_J) >= 0 with sum 1. The graph of the function is the upper side of the
// convex hull of the points lifted to their heights: triangles over the weights, each in a plane w · plane.
#pragma once

#include "studies/compare/law_losses.hpp"
#include "studies/sweep/sweep_plan.hpp"

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

// The least weighted sum of the peaks V, A, J for every weight, to a stated error, by few solves.
//
// f(w) = min over all motions of w · p with p = (V, A, J) over the scene's references is concave in w,
// whatever the motions are. Each solve at a weight w_k gives a motion, hence f(w) <= w · p_k everywhere, and
// a proved bound b_k <= f(w_k). So for every w
//
//     hull of (w_k, b_k) at w  <=  f(w)  <=  min over k of w · p_k,
//
// and where the two lie farthest apart is where the next solve belongs (sandwich algorithm; A. Siem, D. den
// Hertog, A. Hoffmann, INFORMS J. Comput. 23 (2011)). On each triangle of the hull the farthest place is a
// matrix game of three columns. Where the scene is convex the points p_k span the surface of all trade-offs:
// some motion lies at or below every point of a triangle between three of them.

struct SurfaceRequest {
    double error = 1e-4;     ///< of the objective, relative to the larger of 1 and itself; in (0, 1)
    int most_solves = 5000;  ///< >= 3

    /// Throws InputError for numbers out of range, and for a scene whose objective has other terms than V, A
    /// and J or no finite references of these.
    void validate(const Scene& scene) const;
};

enum class SurfaceEnd {
    reached,      ///< the error asked for
    solves,       ///< most_solves
    own_gaps,     ///< what single solves leave unproved is more than the error asked for
    no_motion,    ///< a solve found none, or none with a bound: its row says why
    interrupted,  ///< by the control
};
[[nodiscard]] const char* name_of(SurfaceEnd value);

/// f lies between the two.
struct SurfaceValue {
    double lower = 0.0, upper = 0.0;
    int nearest = 0;  ///< the row whose motion has `upper`
};

struct TradeOffSurface {
    SweepTable table;        ///< one row a solve, keys objective.velocity, .acceleration, .jerk
    PeakTriple reference{};  ///< of V, A, J
    std::vector<std::array<int, 3>> triangles;  ///< of rows: neighbours on the surface
    std::optional<WeightHull> hull;             ///< of the proved bounds; none with fewer than three motions
    double error = infinity;  ///< proved, for every weight; infinity where there are fewer than three motions
    SurfaceEnd end = SurfaceEnd::no_motion;

    /// weights >= 0 with a positive sum; throws InputError else, and where there is no surface. For their
    /// share of the sum.
    [[nodiscard]] SurfaceValue at(const PeakTriple& weights) const;
    /// p of a row.
    [[nodiscard]] PeakTriple point(const SweepRow& row) const;
};

/// Throws as solve() does.
[[nodiscard]] TradeOffSurface trade_off_surface(const Scene& scene, const SurfaceRequest& request,
                                                const RowRun& run = {});

}  // namespace camopt

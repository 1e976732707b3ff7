// SPDX-License-Identifier: MIT
// A spline with free interior breakpoints. Segment i is represented by its derivatives at its left end,
//
//   y^{(r)}(t_i + τ) = Σ_{m=r}^{p} a_{i,m} τ^{m−r} / (m − r)!,
//
// a polynomial in a and in the breakpoints t: nothing is divided by a length, so a short segment is
// harmless, and dy^{(r)}/dτ = y^{(r+1)}. Continuity and exact points are rows; end states are rows or
// fixed entries. A symmetric motion is modelled up to its middle: the rest is its mirror image.
//
// Entries: a_{i,0} … a_{i,p} for every modelled segment i, then t_1 … t_{m−1}. x in rises, y in lifts.
#pragma once

#include "splines/design_vector.hpp"

namespace camopt {

/// A location on a segment: the fraction `at` of it (it moves along), or the fixed x `at`.
struct FreePlace {
    int segment = 0;
    bool moves = true;
    double at = 0.0;
};

/// y^{(order)}(place) − x[minus] − value = 0; minus < 0: without it.
struct FreeEquality {
    FreePlace place;
    int order = 0;
    int minus = -1;
    double value = 0.0;
    std::string name;
};

/// y … y^{(5)} at a location and its dependence on the breakpoints.
struct FreePoint {
    double x = 0.0, tau = 0.0;
    std::array<double, 8> derivative{};    ///< those above the degree are 0
    double by_left = 0.0, by_right = 0.0;  ///< dτ/dt_i, dτ/dt_{i+1}
};

class FreeKnotForm {
 public:
    /// From a request with fixed breakpoints, the start of the search. Exact points stay on the segment that
    /// contains them there. Segments stay longer than `least_part` of the mean one (or than the shortest at
    /// the start). Throws InputError for symmetry on breakpoints that are not symmetric.
    FreeKnotForm(const DesignRequest& request, double least_part);

    [[nodiscard]] int degree() const { return space_.degree(); }
    [[nodiscard]] int continuity() const { return space_.continuity(); }
    [[nodiscard]] Symmetry symmetry() const { return symmetry_; }
    /// Modelled segments: all, or those up to the middle (which may divide one).
    [[nodiscard]] int segments() const { return segments_; }
    [[nodiscard]] double begin() const { return space_.begin(); }
    /// Where the model ends: the end of the motion, or its middle.
    [[nodiscard]] double end() const { return end_; }
    [[nodiscard]] double whole_end() const { return space_.end(); }
    [[nodiscard]] double mean_length() const { return (space_.end() - space_.begin()) / space_.segments(); }

    [[nodiscard]] int size() const { return (degree() + 1) * segments_ + segments_ - 1; }
    [[nodiscard]] int coefficient(int segment, int order) const { return (degree() + 1) * segment + order; }
    /// The entry of t_k; -1 for the two ends.
    [[nodiscard]] int breakpoint(int k) const {
        return k <= 0 || k >= segments_ ? -1 : (degree() + 1) * segments_ + k - 1;
    }
    [[nodiscard]] std::string name(int entry) const;
    /// Order of the derivative an entry stands for; -1 for a breakpoint.
    [[nodiscard]] int order(int entry) const {
        return entry >= (degree() + 1) * segments_ ? -1 : entry % (degree() + 1);
    }

    [[nodiscard]] const Eigen::VectorXd& lower() const { return lower_; }
    [[nodiscard]] const Eigen::VectorXd& upper() const { return upper_; }
    /// Least length of modelled segment i.
    [[nodiscard]] double least_length(int segment) const;
    [[nodiscard]] const std::vector<FreeEquality>& equalities() const { return equalities_; }

    [[nodiscard]] double breakpoint_at(const Eigen::VectorXd& x, int k) const;
    [[nodiscard]] FreePoint point(const Eigen::VectorXd& x, const FreePlace& place) const;
    /// τ^{m−r} / (m − r)!: the partial of y^{(r)} by a_{i,m}; 0 for m < r.
    [[nodiscard]] static double power(double tau, int order, int m);

    /// y^{(r)}(mirror of x) = mirror_sign(r) · y^{(r)}(x) + mirror_offset(r).
    [[nodiscard]] double mirror_sign(int order) const;
    [[nodiscard]] double mirror_offset(int order) const {
        return symmetry_ == Symmetry::odd && order == 0 ? sum_ : 0.0;
    }

    /// All breakpoints of the motion, ascending and separated by the least lengths for any x.
    [[nodiscard]] std::vector<double> breakpoints(const Eigen::VectorXd& x) const;
    /// The spline of x on breakpoints(x); as continuous as x satisfies the equalities.
    [[nodiscard]] SplineCurve curve(const Eigen::VectorXd& x) const;
    /// The entries of a spline of this degree and number of segments.
    [[nodiscard]] Eigen::VectorXd values_of(const SplineCurve& curve) const;

 private:
    void add_ends(const DesignRequest& request);
    void add_joints();
    void add_condition(const PointCondition& condition);
    void add_equality(const FreePlace& place, int order, double value, const std::string& name);
    void fix(int entry, double value) { lower_[entry] = upper_[entry] = value; }

    SplineSpace space_;
    Symmetry symmetry_;
    double sum_ = 0.0;  ///< y at the begin + y at the end
    int segments_ = 0;
    double end_ = 0.0, least_ = 0.0;
    Eigen::VectorXd lower_, upper_;
    std::vector<FreeEquality> equalities_;
};

// The energy of one segment whose ends move, with exact partials:
//
//   E = ∫_0^h (y^{(r)})² dτ = Σ_{m,l >= r} a_m a_l h^{m+l−2r+1} / ((m − r)! (l − r)! (m + l − 2r + 1)),
//   dE/dh = y^{(r)}(h)².

/// Partials by a_{i,r} … a_{i,p}, t_i, t_{i+1} (also where an end is fixed).
struct SegmentEnergy {
    double value = 0.0;
    Eigen::VectorXd slope;
    Eigen::MatrixXd curvature;
};

[[nodiscard]] SegmentEnergy segment_energy(const FreeKnotForm& form, const Eigen::VectorXd& x, int segment,
                                           int order);

}  // namespace camopt

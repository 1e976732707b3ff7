// SPDX-License-Identifier: MIT
//
// Design vectors: three parametrizations of one spline by numbers x that an optimizer can move.
//
//   ordinates     y at the interior breakpoints (the paper's), of degree 7 y''' at both ends too; the end
//                 states determine the rest. Dense.
//   coefficients  B-spline control points except those fixed by the end states. Local.
//   states        y, y', y'' (degree 7: and y''') at the breakpoints, continuity as sparse rows. Local, the
//                 best conditioned.
//
// In every form the local polynomial of segment i is affine in x:  a_i = offset_i + M_i x[columns_i].
// Conditions that the form does not build in (continuity of `states`, set points, symmetry) are sparse rows
// E x = e. Redundant rows are omitted; contradictory rows are named.
#pragma once

#include "splines/design_request.hpp"

namespace camopt {

class DesignVector {
 public:
    /// Throws InputError if the form cannot span the space (ordinates with continuity below degree − 1), the
    /// conditions lie outside it, or breakpoints under symmetry are not symmetric.
    [[nodiscard]] static DesignVector make(const DesignRequest& request);

    [[nodiscard]] DesignKind kind() const { return kind_; }
    [[nodiscard]] const SplineSpace& space() const { return space_; }
    [[nodiscard]] int size() const { return static_cast<int>(names_.size()); }
    [[nodiscard]] const std::string& name(int index) const { return names_[index]; }
    /// y, y', y'' at the ends, as requested.
    [[nodiscard]] const std::array<double, 3>& begin_state() const { return begin_state_; }
    [[nodiscard]] const std::array<double, 3>& end_state() const { return end_state_; }
    /// Order of derivative that entry `index` stands for: 0 for ordinates and control points, 0 … 2 for
    /// states; 3 for y''' of degree 7.
    [[nodiscard]] int order(int index) const { return orders_[index]; }
    /// The breakpoint of an entry, x. Not of coefficients.
    [[nodiscard]] double place(int index) const {
        return space_.breakpoints()[static_cast<std::size_t>(places_[static_cast<std::size_t>(index)])];
    }

    [[nodiscard]] const LocalMap& local_map(int segment) const { return maps_[segment]; }
    [[nodiscard]] AffineRow functional(double x, int order, Side side = Side::right) const;
    [[nodiscard]] SplineCurve curve(const Eigen::VectorXd& x) const;

    /// Independent rows, each 0 for an admissible x.
    [[nodiscard]] const std::vector<Equality>& equalities() const { return equalities_; }
    [[nodiscard]] const std::vector<ConditionConflict>& redundant() const { return redundant_; }
    [[nodiscard]] const std::vector<ConditionConflict>& contradictions() const { return contradictions_; }
    /// Degrees of freedom: size() less the independent rows.
    [[nodiscard]] int freedom() const { return size() - static_cast<int>(equalities_.size()); }

    /// The entries to report: for ordinates the free ones, counted from the start; for the other forms all.
    [[nodiscard]] std::vector<int> reported_entries() const;

    /// The x whose curve has the given values: exact for a curve of this space.
    [[nodiscard]] Eigen::VectorXd values_of(const SplineCurve& curve) const;

    /// |x_j| <= result_j, given |a_{i,m}| m! <= derivative_bounds(m, i) for every segment i.
    [[nodiscard]] Eigen::VectorXd entry_bounds(const Eigen::MatrixXd& derivative_bounds) const;

 private:
    explicit DesignVector(SplineSpace space) : space_(std::move(space)) {}
    void add_equality(Equality equality);

    DesignKind kind_ = DesignKind::states;
    SplineSpace space_;
    std::array<double, 3> begin_state_{}, end_state_{};
    std::vector<std::string> names_;
    std::vector<int> orders_;
    std::vector<int>
        places_;  ///< breakpoint (ordinates, states) or basis function (coefficients) of an entry
    std::vector<LocalMap> maps_;
    std::vector<Equality> equalities_;
    std::vector<ConditionConflict> redundant_, contradictions_;
    Symmetry symmetry_ = Symmetry::none;
    std::vector<int> fixed_entries_;  ///< entries fixed by one condition alone
};

}  // namespace camopt

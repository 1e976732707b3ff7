// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: presolve that eliminates free variables of a ConvexModel in two
// equalities.
//
// The displacements of a motion in the states form occur only in continuity rows:
//     y_1 − y_0 = a_0ᵀ u,   y_2 − y_1 = a_1ᵀ u,   …
// A free variable without cost that occurs in exactly two rows, both equalities, joins them; a tree of m rows
// with m − 1 such variables becomes one row: the sum Σ τ_i row_i in which all of them cancel. The model
// gets smaller by two unknowns per knot, and its equalities' multipliers are λ_i = τ_i λ of the sum.
// The variables follow by back-substitution. Only long trees are worth it: their sums are dense.
#pragma once

#include "solvers/structured/interior_point.hpp"

namespace camopt::structured {

class PathReduction {
 public:
    /// `start`: any point, used to test whether the cost depends on a variable. The model must outlive this
    /// object.
    PathReduction(const ConvexModel& model, const Eigen::VectorXd& start);

    /// The smaller model; the given one if nothing was eliminated.
    [[nodiscard]] const ConvexModel& model() const { return removed_.empty() ? full_ : reduced_; }

    [[nodiscard]] Eigen::VectorXd reduced(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd restored(const Eigen::VectorXd& x) const;
    /// One per row of the given model.
    [[nodiscard]] Eigen::VectorXd restored_multipliers(const Eigen::VectorXd& lambda) const;
    /// The inverse: of a sum as its last row has it.
    [[nodiscard]] Eigen::VectorXd reduced_multipliers(const Eigen::VectorXd& lambda) const;

 private:
    struct Candidate;
    class Edges;
    /// The variable is found from its row once the variables before it are.
    struct Removed {
        int variable, row, other_row;
        double entry, other_entry;
    };
    [[nodiscard]] std::vector<Candidate> candidates(const Eigen::VectorXd& start) const;
    void join(const std::vector<Candidate>& candidates);
    void number();
    void build();
    void append_column(Eigen::Index k, std::vector<std::pair<int, double>>& column);
    [[nodiscard]] std::unique_ptr<ConvexCost> reduced_cost(const Eigen::VectorXd& start) const;

    const ConvexModel& full_;
    ConvexModel reduced_;
    std::vector<Removed> removed_;     ///< in the order of back-substitution
    std::vector<int> row_, variable_;  ///< of the smaller model, for each of the given one; −1: eliminated
    std::vector<double> part_;         ///< τ, 1 outside the trees
    std::vector<int> kept_variables_;
    int row_count_ = 0;
};

}  // namespace camopt::structured

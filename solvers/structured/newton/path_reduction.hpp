// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a ConvexModel without the variables that only carry a sum along.
//
// The displacements of a motion given by its states stand in continuity rows and nowhere else:
//     y_1 − y_0 = a_0ᵀ u,   y_2 − y_1 = a_1ᵀ u,   …
// A free variable without cost that stands in exactly two rows, both equalities, joins them; rows joined to a
// tree, with m − 1 such variables, become one: the sum Σ τ_i row_i in which all of them cancel. The model
// gets smaller by two unknowns a knot, and its equalities' multipliers are λ_i = τ_i λ of the sum.
// The variables come back row by row. Only long trees are worth it: their sums are dense.
#pragma once

#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace camopt::structured {

class PathReduction {
 public:
    /// `start`: any point; there the cost is asked whether it depends on a variable. The model must outlive
    /// this object.
    PathReduction(const ConvexModel& model, const Eigen::VectorXd& start);

    /// The smaller model; the given one where nothing was to be gained.
    [[nodiscard]] const ConvexModel& model() const { return removed_.empty() ? full_ : reduced_; }

    [[nodiscard]] Eigen::VectorXd reduced(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd restored(const Eigen::VectorXd& x) const;
    /// One a row of the given model.
    [[nodiscard]] Eigen::VectorXd restored_multipliers(const Eigen::VectorXd& lambda) const;
    /// The other way: of a sum as its last row has it.
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
    std::vector<Removed> removed_;     ///< in the order of their return
    std::vector<int> row_, variable_;  ///< of the smaller model, for each of the given one; −1: gone
    std::vector<double> part_;         ///< τ, 1 outside the trees
    std::vector<int> kept_variables_;
    int row_count_ = 0;
};

}  // namespace camopt::structured

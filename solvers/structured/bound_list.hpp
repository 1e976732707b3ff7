// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the finite bounds of a ConvexModel, one by one.
//
// Bound b limits the quantity t_b, a variable x_j or an inequality row C_i x:  gap_b = σ_b (t_b − value_b) >=
// 0, σ = +1 for a lower bound, −1 for an upper one. Bounds of variables come first. Equalities are no bounds.
#pragma once

#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt::structured {

struct BoundList {
    explicit BoundList(const ConvexModel& model);
    Eigen::VectorXd sign, value;
    std::vector<int> of;            ///< variable or row
    Eigen::Index of_variables = 0;  ///< how many limit variables
    std::vector<int> equalities;    ///< rows
    [[nodiscard]] Eigen::Index size() const { return sign.size(); }

    /// Calls visit(b, t_b) with t_b from x (variables) or image (rows).
    template <typename Visit>
    void each(const Eigen::VectorXd& x, const Eigen::VectorXd& image, Visit&& visit) const {
        const Eigen::Index count = size();
        for (Eigen::Index b = 0; b < of_variables; ++b) visit(b, x[of[b]]);
        for (Eigen::Index b = of_variables; b < count; ++b) visit(b, image[of[b]]);
    }
};

}  // namespace camopt::structured

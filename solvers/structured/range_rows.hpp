// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: the bounds of a ConvexModel as ranges,
//
//     lower side   t_r + w_r >= l_r,        t_r = C_r x,   w_r = d_r x_{v(r)},
//     upper side   w_r − t_r >= −u_r.
//
// The rows v <= V and −v <= V of a peak are twins: one range of width V around the core row v. So are
// the two bounds of a row or of a variable, with no width. Quantities common to both twins are computed once,
// and the dense columns of the widths never enter a product of matrices.
// Sides are numbered: the lower sides of all ranges, then their upper ones. A missing side has an index too,
// with present = 0. Equalities are not ranges.
#pragma once

#include "solvers/structured/interior_point.hpp"

namespace camopt::structured {

struct RangeRows {
    using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    explicit RangeRows(const ConvexModel& model);

    /// Ranges [first, last) have the width width[r] · x[variable].
    struct Group {
        int variable = 0;
        Eigen::Index first = 0, last = 0;
    };
    /// The origin of a side: a bound of a row of the model, or (row −1) of a variable; sign +1 lower, −1
    /// upper.
    struct Source {
        int row = -1, variable = -1;
        double sign = 0.0;
    };

    RowMajor matrix;                 ///< the core rows C, then the equalities E
    std::vector<Group> groups;       ///< ranges in none have no width
    Eigen::VectorXd width;           ///< d, one per range
    Eigen::VectorXd limit, present;  ///< one per side: l, then −u; 1 or 0
    std::vector<Source> source;      ///< of every side
    std::vector<int> equalities;     ///< rows of the model
    Eigen::VectorXd equal_to;        ///< their right-hand sides
    Eigen::Index sides_present = 0;

    [[nodiscard]] Eigen::Index ranges() const { return width.size(); }
    [[nodiscard]] Eigen::Index sides() const { return limit.size(); }

    /// out = [t + w; w − t] from image = [t; …].
    void slides(const Eigen::VectorXd& x, const Eigen::VectorXd& image, Eigen::VectorXd& out) const;
    /// Multipliers of the model's rows from those of equalities and sides (z >= 0): −Σ sign z.
    [[nodiscard]] Eigen::VectorXd row_multipliers(const Eigen::VectorXd& of_equalities,
                                                  const Eigen::VectorXd& of_sides) const;
};

}  // namespace camopt::structured

// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a step problem (linearized_problem.hpp, without relaxation) by its active
// set.
//
// Close to a minimum the rows and bounds that hold the step are those that carried multipliers before. With
// these as equalities  N d = b  the step is the solution of one linear system,
//
//     [ H  Nᵀ ] [ d ]   [ −c ]
//     [ N  0  ] [ λ ] = [  b ],
//
// exact to round-off where the interior point takes some fifteen factorizations. Rows that the solution
// violates are added, those whose multiplier has the wrong sign are released, a few times; where this does
// not end, the caller takes the interior point. Source: Hintermüller, Ito, Kunisch, The primal-dual active
// set strategy as a semismooth Newton method, SIAM J. Optim. 13 (2002).
#pragma once

#include "solvers/structured/linearized_problem.hpp"

namespace camopt::structured {

class ActiveSetStep {
 public:
    struct Solution {
        Eigen::VectorXd step, multipliers;  ///< of the Nlp's rows
    };
    /// `jacobian` at the point of `model`. `tolerance`: of rows, relative to their scales.
    ActiveSetStep(const NlpShape& shape, const RowMatrix& jacobian, const StepModel& model, double tolerance);

    /// From the rows that carry these multipliers; nullopt: not found in a few corrections.
    [[nodiscard]] std::optional<Solution> solve(const Eigen::VectorXd& multipliers);

 private:
    enum class Side : signed char { lower = -1, none = 0, upper = 1 };
    void guess(const Eigen::VectorXd& multipliers);
    [[nodiscard]] bool solve_equalities();
    [[nodiscard]] int corrected();
    void add_held(int index, Side side, double target);
    [[nodiscard]] Side corrected_side(int index, double value, double lower, double upper, double slack);

    const NlpShape& shape_;
    const RowMatrix& jacobian_;
    const StepModel& model_;
    double tolerance_, unit_;  ///< unit_: factor on the cost
    int variables_, rows_;
    Eigen::VectorXd length_;      ///< of every row's normal
    std::vector<Side> side_;      ///< of the rows, then of the variables
    std::vector<int> held_;       ///< those with a side
    std::vector<double> target_;  ///< b
    std::vector<int> place_;      ///< of every row and variable in held_; −1: none
    Eigen::VectorXd solution_;    ///< [d; λ]
};

}  // namespace camopt::structured

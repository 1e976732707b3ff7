// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: one step of the sequential method, by the interior point for linear rows.
#pragma once

#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/linearized_problem.hpp"

namespace camopt::structured {

struct Step {
    bool usable = false;  ///< accurate enough to be tried
    Stop stop = Stop::breakdown;
    Eigen::VectorXd step;         ///< d
    double elastic = 0.0;         ///< t
    Eigen::VectorXd multipliers;  ///< of the Nlp's rows
    [[nodiscard]] bool stopped() const { return stop == Stop::time_limit || stop == Stop::interrupted; }
};

class StepSolver {
 public:
    StepSolver(const Nlp& problem, const InteriorPointLimits& limits, const SolveControl& control)
        : problem_(problem), limits_(limits), control_(control) {}

    [[nodiscard]] Step solve(const NlpPoint& point, const StepModel& model);

    /// With elastic rows, and with a penalty ν large enough: ν grows until the step takes its part of the
    /// least violation that the linearized rows allow. Source: Byrd, Nocedal, Waltz, Steering exact penalty
    /// methods for nonlinear programming, Optim. Methods Softw. 23 (2008).
    struct Steered {
        Step step;
        Eigen::VectorXd least_multipliers;  ///< with Σ |λ_i| w_i = 1, where least_elastic was asked for
        double least_elastic = 0.0;         ///< of any step; the violation itself where that was not asked
    };
    [[nodiscard]] Steered solve_elastic(const NlpPoint& point, StepModel& model, double violation);

    [[nodiscard]] int interior_iterations() const { return iterations_; }

 private:
    const Nlp& problem_;
    InteriorPointLimits limits_;
    const SolveControl& control_;
    int iterations_ = 0;
};

}  // namespace camopt::structured

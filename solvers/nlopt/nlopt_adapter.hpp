// SPDX-License-Identifier: MIT
// An Nlp as NLopt wants to see it: C callbacks for the cost, the equalities h(x) = 0 and the inequalities
// c(x) <= 0. Private to this folder (an NLopt type appears).
#pragma once

#include "solvers/backend_support.hpp"

#include <Eigen/SparseCore>

#include <nlopt.h>
#include <vector>

namespace camopt {

class NloptAdapter {
 public:
    NloptAdapter(const Nlp& problem, SolveGuard& guard);
    NloptAdapter(const NloptAdapter&) = delete;
    NloptAdapter& operator=(const NloptAdapter&) = delete;

    /// Gives NLopt the cost, the rows and the bounds; this object must outlive every run of `optimizer`.
    [[nodiscard]] nlopt_result attach(nlopt_opt optimizer, double constraint_tolerance);

    /// Largest violation of a row or a bound, each relative to max(1, |bound|).
    [[nodiscard]] double violation(const Eigen::VectorXd& x);

    [[nodiscard]] int equality_rows() const { return static_cast<int>(equalities_.size()); }
    [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
    /// sign (g_row − bound): an equality, or an inequality <= 0.
    struct Side {
        int row;
        double sign, bound;
    };

    static double cost(unsigned n, const double* x, double* gradient, void* self);
    static void equalities(unsigned m, double* values, unsigned n, const double* x, double* gradient,
                           void* self);
    static void inequalities(unsigned m, double* values, unsigned n, const double* x, double* gradient,
                             void* self);

    void write(const std::vector<Side>& sides, const Eigen::VectorXd& x, double* values, double* gradient);
    bool update_constraints(const Eigen::VectorXd& x);
    bool update_jacobian(const Eigen::VectorXd& x);
    bool may_go_on(const Eigen::VectorXd& x);
    bool accept(bool called, bool finite);

    const Nlp& problem_;
    const NlpShape& shape_;
    SolveGuard& guard_;
    nlopt_opt optimizer_ = nullptr;
    std::vector<Side> equalities_, inequalities_;
    int evaluations_ = 0;
    // NLopt asks for equalities and inequalities at one x in two calls; both are answered from here.
    Eigen::VectorXd constraints_x_, constraints_, jacobian_x_;
    std::vector<double> jacobian_;
};

}  // namespace camopt

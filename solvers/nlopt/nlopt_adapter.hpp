// SPDX-License-Identifier: MIT
// Adapter from an Nlp to NLopt: C callbacks for the cost, the equalities h(x) = 0 and the inequalities c(x)
// <= 0. Private to this folder (an NLopt type appears).
#pragma once

#include "solvers/backend_support.hpp"

#include <Eigen/SparseCore>

#include <nlopt.h>

namespace camopt {

class NloptAdapter {
 public:
    NloptAdapter(const Nlp& problem, SolveGuard& guard);
    NloptAdapter(const NloptAdapter&) = delete;
    NloptAdapter& operator=(const NloptAdapter&) = delete;

    /// Passes the cost, the rows and the bounds to NLopt; this object must outlive every run of `optimizer`.
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

    static double cost(unsigned n, const double* x_in, double* gradient, void* self);
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
    // NLopt asks for equalities and inequalities at one x in two calls; both use this cache.
    Eigen::VectorXd constraints_x_, constraints_, jacobian_x_;
    std::vector<double> jacobian_;
};

// Runs one NLopt optimizer until it makes no progress. Private to this folder (an NLopt type appears).
struct NloptOutcome {
    Termination termination;
    const char* word;
};
/// A positive code is not success: the limits on evaluations and time have such codes too.
[[nodiscard]] NloptOutcome outcome_of(nlopt_result status);

[[nodiscard]] bool is_finished(Termination termination);

/// Runs, and restarts from the result, until a run ends feasible without lowering the cost, or `restarts` are
/// used up. SLSQP needs it on degenerate linear programs, where it stops early or stalls with an
/// ill-conditioned quasi-Newton matrix; so do MMA, CCSAQ and L-BFGS, which end with FAILURE where their dual
/// or their line search finds no progress and mostly continue from there. A FAILURE without a change is
/// acceptable.
class NloptRuns {
 public:
    NloptRuns(nlopt_opt optimizer, NloptAdapter& adapter, SolveGuard& guard, const BackendOptions& options)
        : optimizer_(optimizer), adapter_(adapter), guard_(guard), options_(options) {}

    [[nodiscard]] BackendResult from(Eigen::VectorXd x, int restarts);

 private:
    NloptOutcome once(Eigen::VectorXd& x, double& cost);

    nlopt_opt optimizer_;
    NloptAdapter& adapter_;
    SolveGuard& guard_;
    const BackendOptions& options_;
};

}  // namespace camopt

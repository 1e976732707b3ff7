// SPDX-License-Identifier: MIT
// Exchange algorithm of semi-infinite programming: solve on a grid, find the continuous maxima of violation,
// add their rows, solve again.
//
// Ends when the violation between samples is below the tolerance: the true objective of the curve exceeds the
// grid's by less, and no limit is violated by more, than `tolerance`. The grid is a relaxation, so its
// optimum remains a bound.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

struct ExchangeResult;

struct ExchangeOptions {
    BackendOptions backend;
    double tolerance = 1e-9;  ///< relative, of objective and limits between the samples; > 0
    int most_rounds = 60;     ///< rounds are few; this only ends a backend that does not converge
    /// Of large problems and the structured solver: the first rounds end early on the central path, where the
    /// maxima are found already. False on a grid that had its rows before.
    bool staged = true;
    /// Of find_feasible: ends with the first proof; the least violation is then a rough one.
    bool decides_only = false;
    /// Called after each round; true ends the exchange. Empty: never.
    std::function<bool(const ExchangeResult& found)> enough = {};
};

/// The best point found, feasible ones first.
struct Candidate {
    Eigen::VectorXd x;            ///< completed: peaks true, equalities to round-off
    double objective = infinity;  ///< true
    double violation = infinity;  ///< worst continuous violation of a limit, relative; <= 0 is satisfied
};

struct ExchangeResult {
    Candidate best;      ///< none if it was interrupted before a first iteration
    Candidate latest;    ///< result of the last round: better than `best` once a small violation is repaired
    BackendResult last;  ///< of the last round; its multipliers belong to the final grid where `converged`
    Termination termination = Termination::not_run;
    bool converged = false;  ///< the exchange itself converged
    bool known = false;      ///< it ended near a minimum known to SolveControl::known
    int rounds = 0;
    int iterations = 0;           ///< summed over the rounds
    double seconds_solver = 0.0;  ///< wall time inside the backend, summed over the rounds
};

/// By a time limit or the user.
[[nodiscard]] bool was_stopped(Termination termination);

/// Completes and verifies x.
[[nodiscard]] Candidate judged(const ContinuousProblem& problem, const Eigen::VectorXd& x);

/// Whether a candidate beats another: feasible (to `tolerance`) before infeasible, then objective, then
/// violation.
[[nodiscard]] bool is_better(const Candidate& left, const Candidate& right, double tolerance);

/// options.backend.max_seconds is the time of all rounds together.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Eigen::VectorXd& start,
                                                  const ExchangeOptions& options,
                                                  const SolveControl& control);
/// The same from a point that is verified already.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Candidate& start, const ExchangeOptions& options,
                                                  const SolveControl& control);

// Elastic problem: the least common violation, min t such that every limit can be satisfied when relaxed by t
// times its scale.
//
// t* > 0, proved by weak duality, proves the scene infeasible, for any backend. t* < 0 gives a point inside
// all limits, towards which a slightly violating one is pulled back.

/// Variables: those of the base problem, then t >= −least_slack. Cost t.
class ElasticProblem final : public ContinuousProblem {
 public:
    /// Slack of half a limit is deep enough inside.
    static constexpr double least_slack = 0.5;

    /// Refining the elastic problem refines `base`, which must outlive it.
    explicit ElasticProblem(ContinuousProblem& base);
    ~ElasticProblem() override;

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override {
        return std::max(judged(base_, x.head(x.size() - 1)).violation, -least_slack);
    }
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override;

 private:
    class Grid;
    ContinuousProblem& base_;
    std::unique_ptr<Grid> grid_;
};

// A problem with each limit relaxed by the same part of its scale.
//
// A delivered point may use the tolerance of its limits. If a problem is infeasible to within round-off or
// the tolerance, its multipliers are unbounded, and a bound for the limits exactly as written exceeds the
// objective of the point, or is infinite. The relevant problem is the one that has room. Its bound does not
// exceed the optimum for the limits as written, so it is a weaker bound for these as well.

class RelaxedProblem final : public ContinuousProblem {
 public:
    /// Refining it refines `base`, which must outlive it.
    RelaxedProblem(ContinuousProblem& base, double slack);
    ~RelaxedProblem() override;

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override { return base_.start(); }
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override {
        return base_.completed(x);
    }
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override { return base_.objective(x); }
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override {
        return base_.box(incumbent, relaxation + slack_);
    }
    [[nodiscard]] bool convex(double incumbent) const override { return base_.convex(incumbent); }

 private:
    class Grid;
    int regridded(int added);

    ContinuousProblem& base_;
    double slack_;
    std::unique_ptr<Grid> grid_;
};

/// ContinuousProblem::violations where each limit is relaxed by `relaxation` times its scale; worst first.
[[nodiscard]] std::vector<Violation> violations_beyond(const ContinuousProblem& problem,
                                                       const Eigen::VectorXd& x, double slack,
                                                       double relaxation);

struct Feasibility {
    Candidate point;                    ///< of the base problem, with the least violation
    std::optional<DualityProof> proof;  ///< of infeasibility: its bound is above what rounding may be
    Termination termination = Termination::not_run;
    double seconds_solver = 0.0;  ///< wall time inside the backend
};

/// Convex problems only. `other`: a backend in place of the structured solver.
[[nodiscard]] Feasibility find_feasible(ContinuousProblem& problem, const ExchangeOptions& options,
                                        const SolveControl& control, const Solver* other = nullptr);

// Solves one continuous problem with one backend: exchange, repair, proof, verdict.

struct JudgeOptions {
    double tolerance = 1e-9;     ///< a violation below this, relative to its scale, counts as satisfied
    double gap = 1e-7;           ///< proved relative gap below which the verdict is optimal
    double stationarity = 1e-6;  ///< residual below which a feasible point is called local; sizes are O(1)
};

/// Wall time of a continuous solve.
struct ContinuousSeconds {
    double solver = 0.0;     ///< inside the backends of the search
    double judgement = 0.0;  ///< starts, continuous maxima and new rows
    double proof = 0.0;      ///< the bound, with backends called for it
    ContinuousSeconds& operator+=(const ContinuousSeconds& more) {
        solver += more.solver;
        judgement += more.judgement;
        proof += more.proof;
        return *this;
    }
};

struct ContinuousResult {
    Eigen::VectorXd x;  ///< completed; empty if nothing is delivered
    Certificate certificate;
    ExchangeResult exchange;
    Candidate inside;          ///< a feasible point (if there is one), towards which results are pulled
    std::string proof_source;  ///< whose multipliers proved the bound
    ContinuousSeconds seconds = {};
};

/// If the current bound exceeds the objective of the delivered point (the limits are infeasible to within
/// round-off), the proof is replaced by that of relaxed limits (RelaxedProblem), or removed if there is
/// none. Afterwards no bound exceeds the objective. `problem`: that of the bound.
void settle_passed_bound(ContinuousResult& result, ContinuousProblem& problem,
                         const ExchangeOptions& exchange, const JudgeOptions& judge,
                         const SolveControl& control);

/// The verdict for a delivered point whose lower bound (if any) is already in the certificate.
void settle_verdict(Certificate& certificate, Termination termination, const JudgeOptions& options);

/// Repairs a small violation left by a backend: the point moves towards a feasible one as far as its
/// violation requires (convex problems). Unchanged if there is none or nothing to repair.
[[nodiscard]] Candidate pulled_inside(const ContinuousProblem& problem, const Candidate& point,
                                      const Candidate& inside);

/// Searches for a feasible point first, and if there is none proves infeasibility on the elastic problem, for
/// any backend. Then runs the backend by exchange from that point, repairs its result, and proves a bound:
/// with the backend's multipliers, fitted ones, or the structured solver's. All of it takes
/// exchange.backend.max_seconds at most. Interrupted before it searched: no x.
[[nodiscard]] ContinuousResult solve_continuous(ContinuousProblem& problem, const Solver& solver,
                                                const ExchangeOptions& exchange, const JudgeOptions& judge,
                                                const SolveControl& control);

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/solve_from_starts.hpp"

#include "objectives/scene_model.hpp"
#include "solvers/duality.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace camopt {

namespace {

using Clock = std::chrono::steady_clock;

// Rows this close to their bound may carry a multiplier.
constexpr double active_row = 1e-6;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double gap_of(double objective, double bound) {
    return (objective - bound) / std::max(1.0, std::abs(objective));
}

/// One search, and the multipliers of its last grid.
struct Search {
    Candidate found;
    Eigen::VectorXd multipliers;
};

class StartSearch {
 public:
    StartSearch(const CamModel& model, const Solver& solver, const ExchangeOptions& exchange,
                const JudgeOptions& judge, const SolveControl& control)
        : problem_(model), solver_(solver), exchange_(exchange), judge_(judge), control_(control) {}

    void run(int starts, unsigned seed, const Eigen::VectorXd& relaxed) {
        for (int k = 0; k < starts; ++k) {
            const double left = exchange_.backend.max_seconds - seconds_since(begin_);
            if (k > 0 && (control_.stopped() || left <= 0.0)) break;
            ExchangeOptions options = exchange_;
            options.backend.max_seconds = left;
            keep(search(start_of(k, seed, relaxed), options), k);
            ++ran_;
        }
    }

    [[nodiscard]] const Search& best() const { return best_; }
    [[nodiscard]] int best_start() const { return best_start_; }
    [[nodiscard]] int ran() const { return ran_; }
    [[nodiscard]] const ExchangeResult& totals() const { return totals_; }
    [[nodiscard]] const CamProblem& problem() const { return problem_; }

 private:
    CamProblem problem_;
    const Solver& solver_;
    const ExchangeOptions& exchange_;
    const JudgeOptions& judge_;
    const SolveControl& control_;
    Clock::time_point begin_ = Clock::now();
    Search best_;
    ExchangeResult totals_;
    int best_start_ = 0, ran_ = 0;

    [[nodiscard]] Eigen::VectorXd start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const {
        if (index == 0 && relaxed.size() > 0) return relaxed;
        if (index <= 1) return problem_.start();
        return problem_.random_start(seed + static_cast<unsigned>(index));
    }

    Search search(const Eigen::VectorXd& start, const ExchangeOptions& options) {
        ExchangeResult ran = minimize_by_exchange(problem_, solver_, start, options, control_);
        totals_.rounds += ran.rounds;
        totals_.iterations += ran.iterations;
        totals_.termination = ran.termination;
        totals_.last = std::move(ran.last);
        Search search{ran.best, {}};
        if (is_better(ran.latest, search.found, judge_.tolerance)) search.found = ran.latest;
        if (totals_.last.row_multipliers) search.multipliers = *totals_.last.row_multipliers;
        return search;
    }

    void keep(Search search, int start) {
        if (search.found.x.size() == 0) return;
        const bool better =
            best_.found.x.size() == 0 || is_better(search.found, best_.found, judge_.tolerance);
        if (!better) return;
        best_ = std::move(search);
        best_start_ = start;
    }
};

/// Rows that later searches added carry no multiplier.
Eigen::VectorXd padded(const Eigen::VectorXd& multipliers, int rows) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows);
    if (multipliers.size() <= rows) all.head(multipliers.size()) = multipliers;
    return all;
}

void judge_search(ContinuousResult& result, const StartSearch& search) {
    const Candidate& found = search.best().found;
    Certificate& certificate = result.certificate;
    certificate.objective = found.objective;
    certificate.worst_violation = found.violation;
    if (found.x.size() == 0) return;
    result.x = found.x;
    const Nlp& grid = search.problem().grid();
    const int rows = grid.shape().constraints();
    const double own = stationarity_of(grid, found.x, padded(search.best().multipliers, rows), active_row);
    const double fitted =
        stationarity_of(grid, found.x, fitted_multipliers(grid, found.x, active_row), active_row);
    certificate.stationarity = std::isfinite(own) ? std::min(own, fitted) : fitted;
}

}  // namespace

bool needs_starts(const CamModel& model) {
    return std::ranges::any_of(model.rules, [&](const PlacedRule& rule) {
        return rule->curvature(model.least_displacement, model.most_displacement) == Curvature::general;
    });
}

StartsResult solve_from_starts(const CamModel& model, const Solver& solver, const ExchangeOptions& exchange,
                               const JudgeOptions& judge, int starts, unsigned seed,
                               const SolveControl& control) {
    StartsResult all;
    ExchangeOptions relaxed_options = exchange;
    relaxed_options.backend.native.clear();  // they belong to the backend the user chose
    CamProblem relaxed(convex_part(model));
    ContinuousResult bound =
        solve_continuous(relaxed, *make_structured_solver(), relaxed_options, judge, control);
    if (bound.certificate.verdict == Verdict::infeasible) {
        all.result = std::move(bound);
        return all;
    }
    const CamProblem whole(model);
    if (bound.x.size() > 0) {
        const Candidate kept = judged(whole, bound.x);
        if (kept.violation <= judge.tolerance) {
            bound.certificate.worst_violation = kept.violation;
            all.result = std::move(bound);
            return all;
        }
    }
    StartSearch search(model, solver, exchange, judge, control);
    search.run(starts, seed, bound.x);
    all.starts = search.ran();
    all.best_start = search.best_start();
    ContinuousResult& result = all.result;
    result.exchange = search.totals();
    judge_search(result, search);
    if (bound.certificate.lower_bound) {
        result.certificate.lower_bound = bound.certificate.lower_bound;
        result.certificate.gap = gap_of(result.certificate.objective, *bound.certificate.lower_bound);
        result.certificate.proof = std::move(bound.certificate.proof);
        result.certificate.proof_kind = bound.certificate.proof_kind;
        result.proof_source = "structured, convex relaxation";
    }
    settle_verdict(result.certificate, result.exchange.termination, judge);
    if (result.certificate.verdict == Verdict::failed) {
        all.least_violating = result.x;
        result.x.resize(0);
    }
    return all;
}

}  // namespace camopt

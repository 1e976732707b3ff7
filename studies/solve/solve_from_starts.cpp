// SPDX-License-Identifier: MIT
#include "studies/solve/solve_from_starts.hpp"

#include "objectives/scene_model.hpp"
#include "solvers/certificate/duality.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/delivered/delivered_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace camopt {

namespace {

// Rows this close to their bound may carry a multiplier.
constexpr double active_row = 1e-6;

/// One search, and the multipliers of its last grid.
struct SearchState {
    Candidate found;
    Eigen::VectorXd multipliers;
};

class StartSearch {
 public:
    StartSearch(const CamModel& model, const Solver& solver, const ExchangeOptions& exchange,
                const JudgeOptions& judge, const SolveControl& control)
        : problem_(model), solver_(solver), exchange_(exchange), judge_(judge), control_(control) {}

    void run(int starts, unsigned seed, const Eigen::VectorXd& relaxed) {
        for (int k = 0; k < starts && !ends(k); ++k) {
            const Eigen::VectorXd start = start_of(k, seed, relaxed);
            const bool in_vain = !found();
            keep(search(start, in_vain ? control_.sooner(control_.in_vain.seconds_left()) : control_));
            // The limit of a search in vain does not hold for one that was on its way.
            if (in_vain && found() && totals_.termination == Termination::time_limit && !control_.ending())
                keep(search(best_.found.x, control_));
            ++ran_;
        }
    }

    [[nodiscard]] const SearchState& best() const { return best_; }
    [[nodiscard]] int ran() const { return ran_; }
    [[nodiscard]] const ExchangeResult& totals() const { return totals_; }
    [[nodiscard]] const CamProblem& problem() const { return problem_; }

 private:
    CamProblem problem_;
    const Solver& solver_;
    const ExchangeOptions& exchange_;
    const JudgeOptions& judge_;
    const SolveControl& control_;
    SearchState best_;
    ExchangeResult totals_;
    int ran_ = 0;

    [[nodiscard]] Eigen::VectorXd start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const {
        const bool measured = problem_.model().start_design.size() > 0;
        if (measured && index == 0) return start_from(problem_.model().start_design);
        if (index == (measured ? 1 : 0) && relaxed.size() > 0) return relaxed;
        if (index <= (measured ? 2 : 1)) return problem_.start();
        return problem_.random_start(seed + static_cast<unsigned>(index));
    }

    /// A motion that the scene brings, with the dimensions any search starts from.
    [[nodiscard]] Eigen::VectorXd start_from(const Eigen::VectorXd& design) const {
        Eigen::VectorXd x = problem_.start();
        x.head(design.size()) = design.cwiseQuotient(design_scales(problem_.model()));
        return problem_.completed(x);
    }

    /// Something that keeps the limits.
    [[nodiscard]] bool found() const {
        return best_.found.x.size() > 0 && best_.found.violation <= judge_.tolerance;
    }

    /// Whether the first starts are all there will be: then it is told why.
    bool ends(int done) {
        if (done == 0) return false;
        std::optional<Termination> ending = control_.ending();
        if (!ending && !found() && control_.in_vain.passed()) ending = Termination::time_limit;
        if (ending) totals_.termination = *ending;
        return ending.has_value();
    }

    SearchState search(const Eigen::VectorXd& start, const SolveControl& control) {
        ExchangeResult ran = minimize_by_exchange(problem_, solver_, start, exchange_, control);
        totals_.rounds += ran.rounds;
        totals_.iterations += ran.iterations;
        totals_.termination = ran.termination;
        totals_.last = std::move(ran.last);
        SearchState search{ran.best, {}};
        if (is_better(ran.latest, search.found, judge_.tolerance)) search.found = ran.latest;
        if (totals_.last.row_multipliers) search.multipliers = *totals_.last.row_multipliers;
        return search;
    }

    void keep(SearchState search) {
        if (search.found.x.size() == 0) return;
        const bool first = best_.found.x.size() == 0;
        if (first || is_better(search.found, best_.found, judge_.tolerance)) best_ = std::move(search);
    }
};

/// Rows that later searches added carry no multiplier.
Eigen::VectorXd padded(const Eigen::VectorXd& multipliers, int rows) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows);
    if (multipliers.size() <= rows) all.head(multipliers.size()) = multipliers;
    return all;
}

void judge_search(ContinuousResult& result, const StartSearch& search, const SolveControl& control) {
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
        stationarity_of(grid, found.x, fitted_multipliers(grid, found.x, active_row, control), active_row);
    certificate.stationarity = std::isfinite(own) ? std::min(own, fitted) : fitted;
}

/// What a relaxation gives. `settled`: the answer of the whole already.
struct Relaxed {
    ContinuousResult result;
    std::shared_ptr<const CamProblem> problem;  ///< what its bound is of
    bool settled = false;
};

Relaxed solve_relaxed(CamModel part, const CamProblem& whole, const ExchangeOptions& exchange,
                      const JudgeOptions& judge, const SolveControl& control, GridMemory* memory) {
    ExchangeOptions options = exchange;
    options.backend.native.clear();  // they belong to the backend the user chose
    const auto problem = std::make_shared<CamProblem>(memory != nullptr ? memory->problem(std::move(part))
                                                                        : CamProblem(std::move(part)));
    Relaxed relaxed{solve_continuous(*problem, *make_structured_solver(), options, judge, control), problem};
    if (memory != nullptr) memory->keep(*problem);
    Certificate& certificate = relaxed.result.certificate;
    drop_idle_bound(certificate);
    relaxed.settled = certificate.verdict == Verdict::infeasible;
    if (certificate.verdict != Verdict::optimal) return relaxed;
    const Candidate kept = judged(whole, relaxed.result.x);
    if (kept.violation > judge.tolerance) return relaxed;
    certificate.worst_violation = kept.violation;
    relaxed.settled = true;
    return relaxed;
}

}  // namespace

bool needs_starts(const CamModel& model) {
    return std::ranges::any_of(model.rules, [](const PlacedRule& rule) {
        return rule->curvature(-infinity, infinity) == Curvature::general;
    });
}

StartsResult solve_from_starts(const CamModel& model, const Solver& solver, const ExchangeOptions& exchange,
                               const JudgeOptions& judge, int starts, unsigned seed,
                               const SolveControl& control, GridMemory* memory) {
    const SolveControl timed = control.sooner(exchange.backend.max_seconds);
    StartsResult all;
    const CamProblem whole(model);
    CamModel always_convex = convex_part(model, ConvexOver::every_motion);
    CamModel usually_convex = convex_part(model, ConvexOver::sensible_motion);
    const bool more_rules = usually_convex.rules.size() > always_convex.rules.size();
    Relaxed relaxed = solve_relaxed(std::move(always_convex), whole, exchange, judge, timed, memory);
    if (!relaxed.settled && more_rules && !timed.ending()) {
        Relaxed tighter = solve_relaxed(std::move(usually_convex), whole, exchange, judge, timed, memory);
        const bool unproved = !tighter.result.certificate.lower_bound;
        if (unproved && !tighter.settled) {  // keep the bound at hand, start from the better motion
            if (tighter.result.x.size() > 0) relaxed.result.x = tighter.result.x;
        } else {
            relaxed = std::move(tighter);
        }
    }
    if (relaxed.settled) {
        all.result = std::move(relaxed.result);
        return all;
    }
    StartSearch search(model, solver, exchange, judge, timed);
    search.run(starts, seed, relaxed.result.x);
    all.starts = search.ran();
    ContinuousResult& result = all.result;
    result.exchange = search.totals();
    judge_search(result, search, timed);
    Certificate& bound = relaxed.result.certificate;
    if (bound.lower_bound) {
        result.certificate.lower_bound = bound.lower_bound;
        result.certificate.gap = relative_gap(result.certificate.objective, *bound.lower_bound);
        result.certificate.proof = std::move(bound.proof);
        result.certificate.proof_kind = bound.proof_kind;
        result.proof_source = "structured, convex relaxation";
        settle_passed_bound(result, *relaxed.problem, exchange, judge, timed);
    }
    settle_verdict(result.certificate, result.exchange.termination, judge);
    if (result.certificate.verdict == Verdict::failed) result.x.resize(0);
    return all;
}

}  // namespace camopt

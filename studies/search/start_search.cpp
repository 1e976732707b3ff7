// SPDX-License-Identifier: MIT
#include "studies/search/start_search.hpp"

#include "objectives/grid/cam_problem.hpp"

#include <algorithm>
#include <optional>

namespace camopt {

namespace {

// Of the size of each variable: nearer than this lies the same minimum. Where it is a minimum of second
// order, the objective there differs from the least by some 1e-8.
constexpr double same_minimum = 1e-4;

bool is_beside(const Eigen::VectorXd& x, const Eigen::VectorXd& known) {
    if (x.size() != known.size()) return false;
    return ((x - known).array().abs() <= same_minimum * known.array().abs().max(1.0)).all();
}

}  // namespace

void StartSearch::run(int first, int end, unsigned seed, const Eigen::VectorXd& relaxed) {
    for (int k = first; k < end && !ends(k); ++k) run_from(start_of(k, seed, relaxed));
}

void StartSearch::run_from(const Eigen::VectorXd& start) {
    const bool in_vain = !found();
    keep(search(start, in_vain ? control_.sooner(control_.in_vain.seconds_left()) : beside_best(control_)));
    // The limit of a search in vain does not hold for one that was on its way.
    if (in_vain && found() && totals_.termination == Termination::time_limit && !control_.ending())
        keep(search(best_.found.x, control_));
    ++ran_;
}

void StartSearch::continue_from(const Eigen::VectorXd& x) {
    keep(search(x, control_));
    ++ran_;
}

Eigen::VectorXd StartSearch::start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const {
    const bool measured = problem_.model().start_design.size() > 0;
    if (measured && index == 0) return start_from(problem_.model().start_design);
    if (index == (measured ? 1 : 0) && relaxed.size() > 0) return relaxed;
    if (index <= (measured ? 2 : 1)) return problem_.start();
    return problem_.random_start(seed + static_cast<unsigned>(index));
}

/// A motion that the scene brings, with the dimensions any search starts from.
Eigen::VectorXd StartSearch::start_from(const Eigen::VectorXd& design) const {
    Eigen::VectorXd x = problem_.start();
    x.head(design.size()) = design.cwiseQuotient(design_scales(problem_.model()));
    return problem_.completed(x);
}

/// Whether the first starts are all there will be: then it is told why.
bool StartSearch::ends(int done) {
    if (done == 0) return false;
    std::optional<Termination> ending = control_.ending();
    if (!ending && !found() && control_.in_vain.passed()) ending = Termination::time_limit;
    if (ending) totals_.termination = *ending;
    return ending.has_value();
}

SolveControl StartSearch::beside_best(SolveControl control) const {
    if (best_.converged)
        control.known = [best = best_.found.x](const Eigen::VectorXd& x) { return is_beside(x, best); };
    return control;
}

/// Nothing where it ended beside the best that is known.
SearchState StartSearch::search(const Eigen::VectorXd& start, const SolveControl& control) {
    ExchangeResult ran = minimize_by_exchange(problem_, solver_, start, exchange_, control);
    totals_.rounds += ran.rounds;
    totals_.iterations += ran.iterations;
    if (ran.known) return {};
    totals_.termination = ran.termination;
    totals_.last = std::move(ran.last);
    SearchState search{ran.best, {}, ran.converged && ran.termination == Termination::converged};
    if (is_better(ran.latest, search.found, judge_.tolerance)) search.found = ran.latest;
    if (totals_.last.row_multipliers) search.multipliers = *totals_.last.row_multipliers;
    return search;
}

void StartSearch::keep(SearchState search) {
    if (search.found.x.size() == 0) return;
    const bool first = best_.found.x.size() == 0;
    if (first || is_better(search.found, best_.found, judge_.tolerance)) best_ = std::move(search);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_adapter.hpp"

#include <fmt/core.h>

namespace camopt {

namespace {

bool all_finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

Eigen::VectorXd vector_of(const double* x, unsigned n) {
    return Eigen::Map<const Eigen::VectorXd>(x, n);
}

/// The result of a line search, or of the dual inside MMA and CCSAQ.
bool found_no_progress(const NloptOutcome& outcome) {
    return outcome.word == std::string_view("FAILURE");
}

}  // namespace

NloptAdapter::NloptAdapter(const Nlp& problem, SolveGuard& guard)
    : problem_(problem),
      shape_(problem.shape()),
      guard_(guard),
      constraints_(shape_.constraints()),
      jacobian_(shape_.jacobian.rows.size()) {
    for (int row = 0; row < shape_.constraints(); ++row) {
        const double lower = shape_.g_lower[row], upper = shape_.g_upper[row];
        if (lower == upper) {
            equalities_.push_back({row, 1.0, upper});
            continue;
        }
        if (std::isfinite(upper)) inequalities_.push_back({row, 1.0, upper});
        if (std::isfinite(lower)) inequalities_.push_back({row, -1.0, lower});
    }
}

nlopt_result NloptAdapter::attach(nlopt_opt optimizer, double constraint_tolerance) {
    optimizer_ = optimizer;
    const auto tolerances = [&](const std::vector<Side>& sides) {
        std::vector<double> all;
        all.reserve(sides.size());
        for (const Side& side : sides)
            all.push_back(constraint_tolerance * std::max(1.0, std::abs(side.bound)));
        return all;
    };
    nlopt_result status = nlopt_set_min_objective(optimizer, cost, this);
    if (status > 0) status = nlopt_set_lower_bounds(optimizer, shape_.x_lower.data());
    if (status > 0) status = nlopt_set_upper_bounds(optimizer, shape_.x_upper.data());
    if (status > 0 && !equalities_.empty())
        status = nlopt_add_equality_mconstraint(optimizer, static_cast<unsigned>(equalities_.size()),
                                                equalities, this, tolerances(equalities_).data());
    if (status > 0 && !inequalities_.empty())
        status = nlopt_add_inequality_mconstraint(optimizer, static_cast<unsigned>(inequalities_.size()),
                                                  inequalities, this, tolerances(inequalities_).data());
    return status;
}

double NloptAdapter::violation(const Eigen::VectorXd& x) {
    if (!update_constraints(x)) return infinity;
    double worst = 0.0;
    const auto measure = [&worst](double value, double lower, double upper) {
        worst = std::max(worst, (lower - value) / std::max(1.0, std::abs(lower)));
        worst = std::max(worst, (value - upper) / std::max(1.0, std::abs(upper)));
    };
    for (int i = 0; i < shape_.constraints(); ++i) {
        if (std::isfinite(shape_.g_lower[i])) measure(constraints_[i], shape_.g_lower[i], infinity);
        if (std::isfinite(shape_.g_upper[i])) measure(constraints_[i], -infinity, shape_.g_upper[i]);
    }
    return worst;  // NLopt keeps x inside its bounds
}

// After force_stop NLopt may call a few more times and receives zeros. A point that is not finite is NLopt's
// own failure (a singular subproblem), not one of the Nlp.
bool NloptAdapter::may_go_on(const Eigen::VectorXd& x) {
    if (!x.allFinite()) guard_.stop(Termination::numerical_failure);
    if (!guard_.must_stop()) return true;
    nlopt_force_stop(optimizer_);
    return false;
}

bool NloptAdapter::accept(bool called, bool finite) {
    if (called && finite) return true;
    if (called) guard_.stop(Termination::evaluation_error);
    nlopt_force_stop(optimizer_);
    return false;
}

double NloptAdapter::cost(unsigned n, const double* x_in, double* gradient, void* self) {
    NloptAdapter& me = *static_cast<NloptAdapter*>(self);
    const Eigen::VectorXd x = vector_of(x_in, n);
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(n);
    double value = 0.0;
    if (me.may_go_on(x)) {
        ++me.evaluations_;
        const bool called = me.guard_.call([&] {
            value = me.problem_.cost(x);
            if (gradient) me.problem_.gradient(x, slope);
        });
        if (!me.accept(called, std::isfinite(value) && slope.allFinite())) {
            value = 0.0;
            slope.setZero();
        }
        me.guard_.report(me.evaluations_, value,
                         me.constraints_x_.size() ? me.violation(me.constraints_x_) : 0.0);
    }
    if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, n) = slope;
    return value;
}

bool NloptAdapter::update_constraints(const Eigen::VectorXd& x) {
    if (constraints_x_.size() == x.size() && constraints_x_ == x) return true;
    constraints_x_.resize(0);
    const bool called = guard_.call([&] { problem_.constraints(x, constraints_); });
    if (!accept(called, constraints_.allFinite())) return false;
    constraints_x_ = x;
    return true;
}

bool NloptAdapter::update_jacobian(const Eigen::VectorXd& x) {
    if (jacobian_x_.size() == x.size() && jacobian_x_ == x) return true;
    jacobian_x_.resize(0);
    const bool called = guard_.call([&] { problem_.jacobian(x, jacobian_); });
    if (!accept(called, all_finite(jacobian_))) return false;
    jacobian_x_ = x;
    return true;
}

void NloptAdapter::write(const std::vector<Side>& sides, const Eigen::VectorXd& x, double* values,
                         double* gradient) {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto m = static_cast<Eigen::Index>(sides.size());
    Eigen::Map<Eigen::VectorXd>(values, m).setZero();
    if (gradient) Eigen::Map<RowMajor>(gradient, m, x.size()).setZero();
    if (!may_go_on(x) || !update_constraints(x)) return;
    for (Eigen::Index i = 0; i < m; ++i)
        values[i] = sides[i].sign * (constraints_[sides[i].row] - sides[i].bound);
    if (!gradient || !update_jacobian(x)) return;
    Eigen::SparseMatrix<double, Eigen::RowMajor> all(shape_.constraints(), x.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(jacobian_.size());
    for (int k = 0; k < shape_.jacobian.size(); ++k)
        entries.emplace_back(shape_.jacobian.rows[k], shape_.jacobian.columns[k], jacobian_[k]);
    all.setFromTriplets(entries.begin(), entries.end());
    for (Eigen::Index i = 0; i < m; ++i)
        for (decltype(all)::InnerIterator entry(all, sides[i].row); entry; ++entry)
            gradient[i * x.size() + entry.col()] = sides[i].sign * entry.value();
}

void NloptAdapter::equalities(unsigned, double* values, unsigned n, const double* x, double* gradient,
                              void* self) {
    NloptAdapter& me = *static_cast<NloptAdapter*>(self);
    me.write(me.equalities_, vector_of(x, n), values, gradient);
}

void NloptAdapter::inequalities(unsigned, double* values, unsigned n, const double* x, double* gradient,
                                void* self) {
    NloptAdapter& me = *static_cast<NloptAdapter*>(self);
    me.write(me.inequalities_, vector_of(x, n), values, gradient);
}

NloptOutcome outcome_of(nlopt_result status) {
    using enum Termination;
    switch (status) {
        case NLOPT_SUCCESS:
            return {converged, "SUCCESS"};
        case NLOPT_FTOL_REACHED:
            return {converged, "FTOL_REACHED"};
        case NLOPT_XTOL_REACHED:
            return {converged, "XTOL_REACHED"};
        case NLOPT_STOPVAL_REACHED:
            return {unbounded, "STOPVAL_REACHED"};
        case NLOPT_MAXEVAL_REACHED:
            return {iteration_limit, "MAXEVAL_REACHED"};
        case NLOPT_MAXTIME_REACHED:
            return {time_limit, "MAXTIME_REACHED"};
        case NLOPT_FAILURE:
            return {numerical_failure, "FAILURE"};
        case NLOPT_INVALID_ARGS:
            return {unsupported, "INVALID_ARGS"};
        case NLOPT_OUT_OF_MEMORY:
            return {numerical_failure, "OUT_OF_MEMORY"};
        case NLOPT_ROUNDOFF_LIMITED:
            return {acceptable, "ROUNDOFF_LIMITED"};
        case NLOPT_FORCED_STOP:
            return {interrupted, "FORCED_STOP"};
        default:
            return {numerical_failure, "unknown to camopt"};  // a code of a later NLopt
    }
}

bool is_finished(Termination termination) {
    return termination == Termination::converged || termination == Termination::acceptable;
}

BackendResult NloptRuns::from(Eigen::VectorXd x, int restarts) {
    const double feasible = 10.0 * number_or(options_, "constraint_tolerance", options_.tolerance);
    BackendResult result;
    const Eigen::VectorXd start = x;
    double best = infinity, violation = infinity;
    for (int run = 0; run <= restarts; ++run) {
        double cost = 0.0;
        const NloptOutcome outcome = once(x, cost);
        result.termination = outcome.termination;
        result.native_status = outcome.word;
        const bool failed = found_no_progress(outcome) && !guard_.stopping();
        if (!is_finished(outcome.termination) && !failed) break;
        violation = adapter_.violation(x);
        const bool settled =
            std::abs(best - cost) <= 0.1 * options_.tolerance * std::max(1.0, std::abs(cost));
        best = cost;
        if (settled && run > 0 && violation <= feasible) {
            // No descent from here, twice in a row: the result of a line search at an optimum.
            if (failed && x != start) result.termination = Termination::acceptable;
            break;
        }
    }
    if (is_finished(result.termination) && violation > feasible) {
        result.termination = Termination::numerical_failure;
        result.native_status += fmt::format(" with violation {:.2g}", violation);
    }
    result.x = std::move(x);
    result.iterations = adapter_.evaluations();
    return result;
}

NloptOutcome NloptRuns::once(Eigen::VectorXd& x, double& cost) {
    const int left = options_.max_iterations - adapter_.evaluations();
    if (left < 1) return {Termination::iteration_limit, "MAXEVAL_REACHED"};
    nlopt_set_maxeval(optimizer_, left);
    nlopt_set_maxtime(optimizer_, guard_.seconds_left());
    Eigen::VectorXd end = x;
    const NloptOutcome outcome = outcome_of(nlopt_optimize(optimizer_, end.data(), &cost));
    if (outcome.termination == Termination::time_limit) (void)guard_.must_stop();  // NLopt's clock, and ours
    if (end.allFinite()) x = end;
    return outcome;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "solvers/structured/sequential_solver.hpp"

#include "solvers/backend_support.hpp"
#include "solvers/structured/convexified_hessian.hpp"
#include "solvers/structured/run_limits.hpp"
#include "solvers/structured/step_solver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double least_radius = 1e-13;
constexpr double largest_size = 1e10;   // of a variable: beyond it the point runs away
constexpr double linear_reach = 100.0;  // how much further variables may move in which all is linear
constexpr double proximal = 1e-8;       // multiple of I in H, of the size of the gradient
constexpr double significant = 1e-6;    // part of the largest multiplier that makes a row carry one
constexpr double loose = 0.1;           // part of the last step: a row that far from its bound is not active
constexpr double at_bound = 1e-7;       // relative distance
constexpr double least_unit = 1e-3;     // of a step problem while the last digits are sought
constexpr double penalty_excess =
    8.0;  // over what the multipliers ask for: the merit then clings to the rows
constexpr double least_penalty = 1e-6;
constexpr int most_reductions = 20;
constexpr int most_polishing = 6;    // passes
constexpr double polished = 1e-3;    // of the tolerance: stationarity that no pass can improve
constexpr double stationary = 1e-6;  // what deserves the word converged
constexpr double nearly_kept = 1e3;  // tolerances of violation that further passes remove
constexpr int slow_passes = 25;      // in which the violation must fall by a tenth
constexpr int most_corrections = 3;
constexpr int most_failures = 8;  // step problems in a row that end without a step
constexpr double stationary_violation = 1e-7;
constexpr double nudge = 0.01;  // of the size of a variable
constexpr double rounding = 1e-14;

double excess(double value, double lower, double upper) {
    return std::max({lower - value, value - upper, 0.0});
}

class SequentialRun {
 public:
    SequentialRun(const Nlp& problem, const BackendOptions& options, const SolveControl& control);
    BackendResult run(const VectorXd& start);

 private:
    std::optional<BackendResult> begin(const VectorXd& start);
    [[nodiscard]] VectorXd nudged() const;
    std::optional<BackendResult> pass();
    void linearize();
    [[nodiscard]] StepModel step_model() const;
    [[nodiscard]] ActiveRows active_rows(const RowMatrix& jacobian) const;
    Step next_step(StepModel& model);
    std::optional<BackendResult> contradiction();
    [[nodiscard]] bool settled(const Step& step);
    bool take(const StepModel& model, Step step);
    [[nodiscard]] BackendResult finished() const;
    [[nodiscard]] bool hopeless(double least_elastic);
    [[nodiscard]] bool stationary_in_violation(double least_elastic) const;
    void raise_penalty(const StepModel& model, const Step& step);
    [[nodiscard]] double slope_change(const VectorXd& step) const;
    [[nodiscard]] VectorXd corrected_rows(const NlpPoint& trial, const VectorXd& step) const;
    [[nodiscard]] NlpPoint moved(const VectorXd& step) const;
    [[nodiscard]] double violation(const NlpPoint& point) const;
    [[nodiscard]] double merit(const NlpPoint& point) const;
    [[nodiscard]] bool kept(const NlpPoint& point) const;
    [[nodiscard]] double stationarity(const VectorXd& multipliers) const;
    [[nodiscard]] VectorXd lagrangian_gradient(const VectorXd& multipliers) const;
    [[nodiscard]] double cost_size() const { return std::max(1.0, std::abs(here_.cost)); }
    BackendResult ended(Termination termination, std::string why) const;

    const Nlp& problem_;
    const NlpShape& shape_;
    const BackendOptions& options_;
    const SolveControl& control_;
    SolveGuard guard_;
    StepSolver steps_;
    int most_passes_;
    VectorXd weights_, reach_;
    std::vector<bool> curved_;  ///< variables in which something is not linear
    NlpPoint here_;
    RowMatrix jacobian_;
    ConvexifiedHessian hessian_;
    Eigen::SparseMatrix<double> true_hessian_;
    VectorXd multipliers_;
    double radius_, penalty_ = 1.0, last_length_ = infinity, least_elastic_ = 0.0;
    bool fresh_ = true, relaxed_ = true, spoiled_ = false;
    double marked_violation_ = infinity;
    int marked_pass_ = 0, reductions_ = 0;
    bool nudged_ = false, shrunk_ = false, flat_ = false;
    int passes_ = 0, polishing_ = 0, failures_ = 0, patience_ = 0;
    struct Best {
        NlpPoint point;
        VectorXd multipliers;
        double error = infinity;  ///< stationarity or violation
        bool kept = false;        ///< every row to the tolerance
    };
    std::optional<Best> best_;
};

SequentialRun::SequentialRun(const Nlp& problem, const BackendOptions& options, const SolveControl& control)
    : problem_(problem),
      shape_(problem.shape()),
      options_(options),
      control_(control),
      guard_(options, control),
      steps_(problem, interior_point_limits(options, structured_options(options.native)), control),
      weights_(VectorXd::Ones(shape_.constraints())),
      curved_(static_cast<std::size_t>(shape_.variables()), false),
      multipliers_(VectorXd::Zero(shape_.constraints())) {
    const StructuredOptions own = structured_options(options.native);
    most_passes_ = std::min(own.max_passes, options.max_iterations);
    radius_ = own.first_radius;
    for (Index i = 0; i < weights_.size(); ++i) weights_[i] = shape_.rows[static_cast<std::size_t>(i)].scale;
    for (int e = 0; e < shape_.jacobian.size(); ++e) {
        const auto entry = static_cast<std::size_t>(e);
        if (!shape_.rows[static_cast<std::size_t>(shape_.jacobian.rows[entry])].linear)
            curved_[static_cast<std::size_t>(shape_.jacobian.columns[entry])] = true;
    }
    if (!shape_.linear_cost)
        for (std::size_t e = 0; e < shape_.hessian.rows.size(); ++e) {
            curved_[static_cast<std::size_t>(shape_.hessian.rows[e])] = true;
            curved_[static_cast<std::size_t>(shape_.hessian.columns[e])] = true;
        }
}

double SequentialRun::violation(const NlpPoint& point) const {
    double worst = 0.0;
    for (Index i = 0; i < weights_.size(); ++i)
        if (!shape_.rows[static_cast<std::size_t>(i)].linear)
            worst =
                std::max(worst, excess(point.rows[i], shape_.g_lower[i], shape_.g_upper[i]) / weights_[i]);
    return worst;
}

double SequentialRun::merit(const NlpPoint& point) const {
    return point.cost + penalty_ * violation(point);
}

/// Every row to the tolerance of its scale, or to what rounding leaves of it.
bool SequentialRun::kept(const NlpPoint& point) const {
    VectorXd noise = VectorXd::Zero(weights_.size());
    for (Index i = 0; i < weights_.size(); ++i)
        for (RowMatrix::InnerIterator entry(jacobian_, i); entry; ++entry)
            noise[i] += rounding * std::abs(entry.value()) * (1.0 + std::abs(point.x[entry.col()]));
    for (Index i = 0; i < weights_.size(); ++i)
        if (excess(point.rows[i], shape_.g_lower[i], shape_.g_upper[i]) >
            std::max(options_.tolerance * shape_.rows[static_cast<std::size_t>(i)].scale, noise[i]))
            return false;
    return true;
}

NlpPoint SequentialRun::moved(const VectorXd& step) const {
    return evaluated(problem_, (here_.x + step).cwiseMax(shape_.x_lower).cwiseMin(shape_.x_upper));
}

/// A first point that keeps the linear rows and the bounds: all later ones then do.
std::optional<BackendResult> SequentialRun::begin(const VectorXd& start) {
    here_ = evaluated(problem_, start.cwiseMax(shape_.x_lower).cwiseMin(shape_.x_upper));
    double off = 0.0;
    for (Index i = 0; i < weights_.size(); ++i)
        if (shape_.rows[static_cast<std::size_t>(i)].linear)
            off = std::max(off, excess(here_.rows[i], shape_.g_lower[i], shape_.g_upper[i]) / weights_[i]);
    if (off > 0.0) {
        differentiate(problem_, here_);
        const StepModel model = projection_model(problem_, here_);
        const LinearizedProblem projection(problem_, here_, model);
        BackendOptions options = options_;
        options.max_seconds = guard_.seconds_left();
        const BackendResult found = make_structured_solver()->minimize(
            projection, VectorXd::Zero(shape_.variables()), options, control_);
        if (found.termination != Termination::converged && found.termination != Termination::acceptable) {
            BackendResult result = found;
            result.native_status = "linear rows: " + found.native_status;
            result.x = found.x.size() > 0 ? VectorXd(here_.x + found.x) : here_.x;
            return result;
        }
        here_ = moved(found.x);
    }
    differentiate(problem_, here_);
    fresh_ = true;
    if (!here_.finite())
        return ended(Termination::evaluation_error, "the start gives values that are not finite");
    return std::nullopt;
}

VectorXd SequentialRun::lagrangian_gradient(const VectorXd& multipliers) const {
    return here_.gradient + jacobian_.transpose() * multipliers;
}

/// ‖∇L + z‖ relative to the gradient, z where x is at a bound.
double SequentialRun::stationarity(const VectorXd& multipliers) const {
    const VectorXd rest = lagrangian_gradient(multipliers);
    double worst = 0.0, size = cost_size();
    for (Index j = 0; j < rest.size(); ++j) {
        const double bound = rest[j] > 0.0 ? shape_.x_lower[j] : shape_.x_upper[j];
        if (std::abs(here_.x[j] - bound) > at_bound * (1.0 + std::abs(here_.x[j])))
            worst = std::max(worst, std::abs(rest[j]));
    }
    return worst / size;
}

ActiveRows SequentialRun::active_rows(const RowMatrix& jacobian) const {
    VectorXd force = VectorXd::Zero(multipliers_.size()), length = force;
    for (Index i = 0; i < multipliers_.size(); ++i) {
        length[i] = jacobian.row(i).norm();
        force[i] = std::abs(multipliers_[i]) * length[i];
    }
    const double most = force.size() > 0 ? force.maxCoeff() : 0.0;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> residuals;
    const auto row = [&] { return static_cast<int>(residuals.size()); };
    for (Index i = 0; i < force.size(); ++i) {
        const bool equality = shape_.g_lower[i] == shape_.g_upper[i];
        if (length[i] == 0.0 || (!equality && !(force[i] > significant * most))) continue;
        const double side = multipliers_[i] > 0.0 ? shape_.g_upper[i] : shape_.g_lower[i];
        const double residual = std::isfinite(side) ? (here_.rows[i] - side) / length[i] : 0.0;
        const double slack = multipliers_[i] > 0.0 ? -residual : residual;
        if (!equality && slack > loose * last_length_) continue;  // the last step left it after all
        for (RowMatrix::InnerIterator entry(jacobian, i); entry; ++entry)
            entries.emplace_back(row(), static_cast<int>(entry.col()), entry.value() / length[i]);
        residuals.push_back(residual);
    }
    const VectorXd rest = lagrangian_gradient(multipliers_);
    for (Index j = 0; j < rest.size(); ++j) {
        const double bound = rest[j] > 0.0 ? shape_.x_lower[j] : shape_.x_upper[j];
        const bool held = std::abs(here_.x[j] - bound) <= at_bound * (1.0 + std::abs(bound)) &&
                          std::abs(rest[j]) > significant * most;
        if (!held && shape_.x_lower[j] != shape_.x_upper[j]) continue;
        entries.emplace_back(row(), static_cast<int>(j), 1.0);
        residuals.push_back(0.0);
    }
    ActiveRows result;
    result.normals.resize(row(), shape_.variables());
    result.normals.setFromTriplets(entries.begin(), entries.end());
    result.residuals = Eigen::Map<const VectorXd>(residuals.data(), row());
    return result;
}

void SequentialRun::linearize() {
    jacobian_ = jacobian_of(problem_, here_);
    std::vector<double> values(static_cast<std::size_t>(shape_.hessian.size()));
    problem_.hessian(here_.x, 1.0, multipliers_, values);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t e = 0; e < values.size(); ++e)
        entries.emplace_back(std::max(shape_.hessian.rows[e], shape_.hessian.columns[e]),
                             std::min(shape_.hessian.rows[e], shape_.hessian.columns[e]),
                             std::isfinite(values[e]) ? values[e] : 0.0);
    true_hessian_.resize(shape_.variables(), shape_.variables());
    true_hessian_.setFromTriplets(entries.begin(), entries.end());
    const double size = here_.gradient.size() > 0 ? here_.gradient.cwiseAbs().maxCoeff() : 0.0;
    hessian_ = convexified(true_hessian_, active_rows(jacobian_), proximal * std::max(size, 1e-8));
    reach_.resize(shape_.variables());
    for (Index j = 0; j < reach_.size(); ++j)
        reach_[j] =
            std::max(1.0, std::abs(here_.x[j])) * (curved_[static_cast<std::size_t>(j)] ? 1.0 : linear_reach);
    fresh_ = false;
}

StepModel SequentialRun::step_model() const {
    StepModel model;
    model.slope = here_.gradient + hessian_.slope;
    model.curvature = hessian_.lower;
    model.rows = here_.rows;
    model.step_lower = (shape_.x_lower - here_.x).cwiseMax(-radius_ * reach_);
    model.step_upper = (shape_.x_upper - here_.x).cwiseMin(radius_ * reach_);
    model.weights = weights_;
    model.elastic_base = violation(here_);
    model.cost_unit = cost_size();
    model.unit = std::min(1.0, radius_);
    model.sharp = polishing_ > 0;
    if (model.sharp)
        model.unit = std::clamp(100.0 * last_length_, std::min(least_unit, model.unit), model.unit);
    return model;
}

Step SequentialRun::next_step(StepModel& model) {
    least_elastic_ = 0.0;
    if (!relaxed_) {
        model.penalty = 0.0;
        Step step = steps_.solve(here_, model);
        if (!step.usable && !step.stopped() && model.sharp) {
            model.sharp = false;
            model.unit = std::min(1.0, radius_);
            step = steps_.solve(here_, model);
        }
        if (step.usable || step.stopped()) return step;
        relaxed_ = true;
        patience_ = 3;
    }
    model.penalty = penalty_;
    const double before = violation(here_);
    StepSolver::Steered steered = steps_.solve_elastic(here_, model, before);
    penalty_ = model.penalty;
    if (!steered.step.usable) return steered.step;
    const bool free = steered.step.elastic <= 1e-8;
    least_elastic_ = free ? 0.0 : steered.least_elastic;
    relaxed_ = !free || --patience_ > 0;
    return steered.step;
}

/// Tangents of convex rows that contradict each other, with the linear rows, prove that nothing is feasible.
std::optional<BackendResult> SequentialRun::contradiction() {
    StepModel model = step_model();
    model.slope.setZero();
    model.curvature.setZero();
    model.step_lower = shape_.x_lower - here_.x;
    model.step_upper = shape_.x_upper - here_.x;
    model.unit = model.cost_unit = 1.0;
    const LinearizedProblem tangents(problem_, here_, model);
    BackendOptions options = options_;
    options.max_seconds = guard_.seconds_left();
    BackendResult found =
        make_structured_solver()->minimize(tangents, VectorXd::Zero(shape_.variables()), options, control_);
    if (found.termination != Termination::infeasible) return std::nullopt;
    BackendResult result =
        ended(Termination::infeasible, "tangents of the rows contradict: " + found.native_status);
    result.row_multipliers = found.row_multipliers;
    result.bound_multipliers = found.bound_multipliers;
    return result;
}

double SequentialRun::slope_change(const VectorXd& step) const {
    const VectorXd image = true_hessian_.selfadjointView<Eigen::Lower>() * step;
    return here_.gradient.dot(step) + 0.5 * step.dot(image);
}

bool SequentialRun::settled(const Step& step) {
    flat_ = std::abs(slope_change(step.step)) <= options_.tolerance * cost_size();
    if (!flat_) polishing_ = 0;
    if (!flat_ || violation(here_) > nearly_kept * options_.tolerance) return false;
    if (!kept(here_) && ++polishing_ <= most_polishing) return false;
    const double now = std::max(stationarity(step.multipliers), violation(here_));
    const bool better = !best_ || now < 0.5 * best_->error;
    if (!best_ || now < best_->error) best_ = Best{here_, step.multipliers, now, kept(here_)};
    return now <= polished * options_.tolerance || (!better && polishing_ >= 2) ||
           ++polishing_ > most_polishing;
}

void SequentialRun::raise_penalty(const StepModel& model, const Step& step) {
    double needed = 0.0;
    for (Index i = 0; i < weights_.size(); ++i)
        if (!shape_.rows[static_cast<std::size_t>(i)].linear)
            needed += std::abs(step.multipliers[i]) * weights_[i];
    const bool too_large = penalty_ > penalty_excess * needed && reductions_ < most_reductions;
    if (model.penalty == 0.0 && (penalty_ < 1.1 * needed || too_large)) {
        penalty_ = 2.0 * needed + least_penalty;
        reductions_ += too_large ? 1 : 0;
    }
    const double change = slope_change(step.step), reduction = violation(here_) - step.elastic;
    if (reduction > 0.0 && change > 0.0) penalty_ = std::max(penalty_, 2.0 * change / reduction);
}

VectorXd SequentialRun::corrected_rows(const NlpPoint& trial, const VectorXd& step) const {
    VectorXd rows = trial.rows - jacobian_ * step;
    for (Index i = 0; i < rows.size(); ++i)
        if (shape_.rows[static_cast<std::size_t>(i)].linear) rows[i] = here_.rows[i];
    return rows;
}

bool SequentialRun::take(const StepModel& model, Step step) {
    constexpr double accept = 1e-4, poor = 0.25, good = 0.75;
    raise_penalty(model, step);
    const double before = merit(here_);
    const double noise = rounding * (cost_size() + penalty_);
    const double predicted = penalty_ * (violation(here_) - step.elastic) - slope_change(step.step) + noise;
    const auto ratio = [&](const NlpPoint& point) {
        if (!std::isfinite(point.cost) || !point.rows.allFinite()) return -infinity;
        return (before - merit(point) + noise) / std::max(predicted, noise);
    };
    NlpPoint trial = moved(step.step);
    double gained = ratio(trial);
    for (int k = 0; k < most_corrections; ++k) {
        if (!(gained < good) || !std::isfinite(gained) || violation(trial) <= step.elastic + rounding) break;
        StepModel again = model;
        again.rows = corrected_rows(trial, step.step);
        Step corrected = steps_.solve(here_, again);
        if (!corrected.usable) break;
        NlpPoint other = moved(corrected.step);
        const double value = ratio(other);
        if (!(value > gained)) break;
        trial = std::move(other);
        step = std::move(corrected);
        gained = value;
    }
    const double length = step.step.cwiseAbs().cwiseQuotient(reach_).maxCoeff();
    if (gained > accept) {
        differentiate(problem_, trial);
        if (!trial.finite()) gained = -infinity;
    }
    spoiled_ = gained == -infinity;
    // The last digits do not show in the merit any more.
    const bool polishing = flat_ && !spoiled_ && merit(trial) - before <= options_.tolerance * cost_size();
    if (polishing && gained <= accept) {
        differentiate(problem_, trial);
        gained = trial.finite() ? 1.0 : -infinity;
    }
    if (gained > accept) {
        here_ = std::move(trial);
        multipliers_ = step.multipliers;
        last_length_ = length;
        fresh_ = true;
        if (gained > good && length > 0.9 * radius_) radius_ *= shrunk_ ? 1.5 : 4.0;
        shrunk_ = false;
        if (gained < poor) radius_ = std::min(radius_, 0.5 * length);
    } else {
        radius_ = 0.25 * std::min(radius_, length);
        shrunk_ = true;
    }
    return gained > accept;
}

BackendResult SequentialRun::finished() const {
    return best_->kept && best_->error <= stationary ? ended(Termination::converged, "converged")
                                                     : ended(Termination::acceptable, "no further progress");
}

/// No step reduces the linearized violation. By convexity a feasible point would then be far away: at
/// 1 / stationary_violation times the size of the point at least.
bool SequentialRun::stationary_in_violation(double least_elastic) const {
    const double now = violation(here_);
    return now - least_elastic <= stationary_violation * now * std::min(1.0, radius_);
}

/// Another point than a stationary one of the violation, such as the center of a disc to be left.
VectorXd SequentialRun::nudged() const {
    VectorXd x = here_.x;
    for (Index j = 0; j < x.size(); ++j)
        if (curved_[static_cast<std::size_t>(j)])
            x[j] += nudge * std::max(1.0, std::abs(x[j])) * std::cos(2.4 * static_cast<double>(j) + 1.0);
    return x;
}

/// The violation is least nearby, or falls so slowly that it never ends.
bool SequentialRun::hopeless(double least_elastic) {
    const double now = violation(here_);
    if (now <= 0.9 * marked_violation_) {
        marked_violation_ = now;
        marked_pass_ = passes_;
    }
    return stationary_in_violation(least_elastic) || passes_ - marked_pass_ > slow_passes;
}

std::optional<BackendResult> SequentialRun::pass() {
    if (fresh_) linearize();
    StepModel model = step_model();
    Step step = next_step(model);
    if (step.stopped())
        return ended(step.stop == Stop::time_limit ? Termination::time_limit : Termination::interrupted,
                     "stopped");
    if (!step.usable) {
        if (best_) return finished();
        radius_ *= 0.25;
        if (++failures_ > most_failures)
            return ended(Termination::numerical_failure, "no step could be computed");
        return std::nullopt;
    }
    failures_ = 0;
    if (settled(step)) return finished();
    const double before = violation(here_);
    if (least_elastic_ > options_.tolerance && before > options_.tolerance) {
        if (shape_.convex)
            if (auto proved = contradiction()) return proved;
        const bool over = hopeless(least_elastic_);
        if (over && shape_.convex && stationary_in_violation(least_elastic_))
            return ended(Termination::infeasible, "the least violation of convex rows is positive");
        if (over && !shape_.convex && !nudged_) {
            nudged_ = true;
            marked_violation_ = infinity;
            return begin(nudged());
        }
        if (over)
            return ended(Termination::numerical_failure,
                         "no feasible point found: the violation is least nearby");
    }
    if (!take(model, std::move(step)) && best_ && polishing_ > 0) return finished();
    if (radius_ < least_radius)
        return ended(spoiled_      ? Termination::evaluation_error
                     : kept(here_) ? Termination::acceptable
                                   : Termination::numerical_failure,
                     "the steps became too small");
    if (here_.x.size() > 0 && here_.x.cwiseAbs().maxCoeff() > largest_size)
        return ended(Termination::unbounded, "the point runs away downhill");
    return std::nullopt;
}

BackendResult SequentialRun::ended(Termination termination, std::string why) const {
    BackendResult result;
    result.termination = termination;
    result.iterations = passes_;
    const NlpPoint& point = best_ ? best_->point : here_;
    result.x = point.x;
    result.native_status = fmt::format("{}: {} passes, {} interior iterations, largest violation {:.1e}", why,
                                       passes_, steps_.interior_iterations(), violation(point));
    result.row_multipliers = best_ ? best_->multipliers : multipliers_;
    VectorXd rest = VectorXd::Zero(shape_.variables());
    if (point.finite() && point.gradient.size() > 0)
        rest = -(point.gradient +
                 camopt::structured::jacobian_of(problem_, point).transpose() * *result.row_multipliers);
    for (Index j = 0; j < rest.size(); ++j)
        if (!std::isfinite(rest[j] > 0.0 ? shape_.x_upper[j] : shape_.x_lower[j])) rest[j] = 0.0;
    result.bound_multipliers = rest;
    return result;
}

BackendResult SequentialRun::run(const VectorXd& start) {
    if (std::optional<BackendResult> refused = begin(start)) return *refused;
    for (;;) {
        if (guard_.must_stop()) {
            guard_.rethrow();
            return ended(*guard_.reason(), "stopped");
        }
        if (passes_ >= most_passes_) return ended(Termination::iteration_limit, "limit of passes");
        ++passes_;
        guard_.report(passes_, here_.cost, violation(here_));
        if (std::optional<BackendResult> end = pass()) return *end;
    }
}

}  // namespace

BackendResult sequential_minimize(const Nlp& problem, const VectorXd& start, const BackendOptions& options,
                                  const SolveControl& control) {
    if (std::optional<BackendResult> crossed = result_of_crossed_bounds(problem)) {
        crossed->x = start;
        return *crossed;
    }
    return SequentialRun(problem, options, control).run(start);
}

}  // namespace camopt::structured

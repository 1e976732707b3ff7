// SPDX-License-Identifier: MIT
#include "studies/search/free_knot_descent.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// The first step moves a breakpoint by at most this part of the mean segment; later ones by what held.
constexpr double first_radius = 0.25, largest_radius = 1.0, least_radius = 1e-9, telling_radius = 1e-4;
// Of the promised gain: what a step must bring to be taken, and to let the radius grow.
constexpr double taken = 1e-4, good = 0.75, poor = 0.25;
// Steps in a row that gain next to nothing.
constexpr int most_idle = 3;

/// ∇f + Jᵀ multipliers at x.
Eigen::VectorXd lagrangian_slope(const Nlp& problem, const Eigen::VectorXd& x,
                                 const Eigen::VectorXd& multipliers) {
    const SparsityPattern& pattern = problem.shape().jacobian;
    std::vector<double> values(static_cast<std::size_t>(pattern.size()));
    problem.jacobian(x, values);
    Eigen::VectorXd slope(x.size());
    problem.gradient(x, slope);
    for (std::size_t k = 0; k < values.size(); ++k) {
        slope[pattern.columns[k]] += values[k] * multipliers[pattern.rows[k]];
    }
    return slope;
}

/// One step of the breakpoints, d: a convex quadratic program around the motion x.
class StepProgram final : public Nlp {
 public:
    /// min ∇fᵀd + ½ d_tᵀ B d_t over the rows of `base` linearized at x; d_t are the entries from `first` on
    /// that B has, within ±radius.
    StepProgram(const Nlp& base, const Eigen::VectorXd& x, Eigen::Index first, const Eigen::MatrixXd& bfgs,
                double radius)
        : base_(base), first_(first), bfgs_(bfgs), gradient_(x.size()) {
        const NlpShape& shape = base.shape();
        Eigen::VectorXd rows(shape.constraints());
        base.constraints(x, rows);
        base.gradient(x, gradient_);
        jacobian_.resize(static_cast<std::size_t>(shape.jacobian.size()));
        base.jacobian(x, jacobian_);
        shape_.x_lower = shape.x_lower - x;
        shape_.x_upper = shape.x_upper - x;
        for (Eigen::Index j = first; j < first + bfgs.rows(); ++j) {
            shape_.x_lower[j] = std::min(0.0, std::max(shape_.x_lower[j], -radius));
            shape_.x_upper[j] = std::max(0.0, std::min(shape_.x_upper[j], radius));
        }
        shape_.g_lower = shape.g_lower - rows;
        shape_.g_upper = shape.g_upper - rows;
        shape_.rows = shape.rows;
        for (RowKind& row : shape_.rows) row.linear = true;
        shape_.jacobian = shape.jacobian;
        shape_.convex = shape_.quadratic_cost = true;
        shape_.linear_cost = bfgs.isZero();
        if (shape_.linear_cost) return;
        for (Eigen::Index a = 0; a < bfgs.rows(); ++a) {
            for (Eigen::Index b = 0; b <= a; ++b) {
                shape_.hessian.rows.push_back(static_cast<int>(first + a));
                shape_.hessian.columns.push_back(static_cast<int>(first + b));
            }
        }
    }

    [[nodiscard]] double cost(const ConstVectorRef& d) const override {
        const auto moved = d.segment(first_, bfgs_.rows());
        return gradient_.dot(d) + 0.5 * moved.dot(bfgs_ * moved);
    }
    void gradient(const ConstVectorRef& d, VectorRef out) const override {
        out = gradient_;
        out.segment(first_, bfgs_.rows()) += bfgs_ * d.segment(first_, bfgs_.rows());
    }
    void constraints(const ConstVectorRef& d, VectorRef out) const override {
        out.setZero();
        for (std::size_t k = 0; k < jacobian_.size(); ++k) {
            out[shape_.jacobian.rows[k]] += jacobian_[k] * d[shape_.jacobian.columns[k]];
        }
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::ranges::copy(jacobian_, out.begin());
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k) {
            out[k] = sigma * bfgs_(shape_.hessian.rows[k] - first_, shape_.hessian.columns[k] - first_);
        }
    }
    [[nodiscard]] std::string variable_name(int index) const override { return base_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return base_.row_name(index); }
    [[nodiscard]] RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

 private:
    const Nlp& base_;
    Eigen::Index first_;
    const Eigen::MatrixXd& bfgs_;
    Eigen::VectorXd gradient_;
    std::vector<double> jacobian_;
};

class Descent {
 public:
    Descent(FreeKnotProblem& problem, const Solver& solver, const FreeKnotOptions& options,
            const SolveControl& control)
        : problem_(problem), solver_(solver), options_(options), control_(control) {}

    FreeKnotResult run(const Eigen::VectorXd& start) {
        result_.found = best_motion(start);
        if (result_.found.x.size() == 0) return result_;
        bfgs_ = Eigen::MatrixXd::Zero(breakpoints(), breakpoints());
        while (result_.steps < options_.most_steps) {
            if (const std::optional<Termination> ending = control_.ending()) {
                result_.termination = *ending;
                return result_;
            }
            if (done()) break;
            step();
        }
        result_.termination =
            result_.steps < options_.most_steps ? Termination::converged : Termination::iteration_limit;
        return result_;
    }

 private:
    FreeKnotProblem& problem_;
    const Solver& solver_;
    const FreeKnotOptions& options_;
    const SolveControl& control_;
    FreeKnotResult result_;
    Eigen::MatrixXd bfgs_;
    double radius_ = first_radius;
    int idle_ = 0;

    [[nodiscard]] Eigen::Index breakpoints() const { return problem_.form().segments() - 1; }
    [[nodiscard]] Eigen::Index first() const { return problem_.form().breakpoint(1); }
    [[nodiscard]] double size() const { return std::max(1.0, std::abs(result_.found.objective)); }
    [[nodiscard]] bool feasible(const Candidate& candidate) const {
        return candidate.violation <= options_.exchange.tolerance;
    }

    [[nodiscard]] bool done() const {
        return breakpoints() < 1 || idle_ >= most_idle || radius_ < least_radius ||
               (feasible(result_.found) && result_.found.objective <= options_.enough);
    }

    /// The best motion for the breakpoints of x; the least violating one where none keeps the limits.
    Candidate best_motion(const Eigen::VectorXd& x) {
        CamProblem fixed = problem_.fixed_problem(x);
        if (!fixed.model().design.contradictions().empty()) return {};
        const ExchangeOptions& options = options_.exchange;
        const Eigen::VectorXd start = fixed.completed(problem_.fixed_point(fixed, x));
        const ExchangeResult ran = minimize_by_exchange(fixed, solver_, start, options, control_);
        result_.rounds += ran.rounds;
        result_.iterations += ran.iterations;
        Candidate best = is_better(ran.latest, ran.best, options.tolerance) ? ran.latest : ran.best;
        if (best.x.size() == 0) return {};
        if (!feasible(best) && fixed.grid().shape().convex && !control_.ending()) {
            const Feasibility nearest = find_feasible(fixed, options, control_);
            if (nearest.point.x.size() > 0 && is_better(nearest.point, best, options.tolerance))
                best = nearest.point;
        }
        best.x = problem_.free_point(fixed, best.x);
        return best;
    }

    void step() {
        ++result_.steps;
        const Eigen::VectorXd here = result_.found.x;
        see_peaks(here);
        const StepProgram model(problem_.grid(), here, first(), bfgs_, radius_);
        BackendOptions options;
        options.tolerance = options_.exchange.backend.tolerance;
        options.max_seconds = options_.exchange.backend.max_seconds;
        const BackendResult ran =
            solver_.minimize(model, Eigen::VectorXd::Zero(here.size()), options, control_);
        result_.iterations += ran.iterations;
        ++result_.rounds;
        if (control_.ending()) return;  // half a step promises nothing
        if (ran.x.size() == 0 || !ran.x.allFinite()) {
            radius_ *= 0.25;
            return;
        }
        const double promised = -model.cost(ran.x);
        const Eigen::VectorXd move = ran.x.segment(first(), breakpoints());
        const Candidate found = best_motion(here + ran.x);
        // A short step promises little more than rounding.
        if (feasible(result_.found) && radius_ >= telling_radius)
            result_.stationarity = std::max(0.0, promised) / size() / radius_;
        judge(here, ran, found, promised, move.lpNorm<Eigen::Infinity>());
    }

    void judge(const Eigen::VectorXd& here, const BackendResult& ran, const Candidate& found, double promised,
               double length) {
        const bool better =
            found.x.size() > 0 && is_better(found, result_.found, options_.exchange.tolerance);
        const bool comparable = feasible(found) && feasible(result_.found);
        const double gain = comparable ? result_.found.objective - found.objective
                            : better   ? infinity
                                       : -infinity;
        const double ratio = comparable ? gain / std::max(promised, 1e-15) : better ? 1.0 : -1.0;
        idle_ = comparable && std::max(gain, promised) <= options_.tolerance * size() ? idle_ + 1 : 0;
        if (ran.row_multipliers && found.x.size() > 0) learn(here, found.x, *ran.row_multipliers);
        if (better && ratio > taken) result_.found = found;
        if (ratio > good && length > 0.9 * radius_) radius_ = std::min(2.0 * radius_, largest_radius);
        if (ratio < poor) radius_ = 0.5 * std::min(radius_, std::max(length, least_radius));
        if (control_.progress && result_.steps % 10 == 0) {
            const std::string line =
                fmt::format("breakpoints, step {}: objective {:.9g}", result_.steps, result_.found.objective);
            Progress progress(line);
            progress.incumbent = result_.found.objective;
            progress.violation = result_.found.violation;
            control_.progress(progress);
        }
    }

    /// Rows at the true maxima of the motion at hand, so that the next step sees them.
    void see_peaks(const Eigen::VectorXd& x) {
        std::vector<Violation> near = problem_.violations(x, options_.tolerance * 10.0);
        static_cast<void>(problem_.refine(near));
    }

    /// Damped BFGS on the Lagrangian's slope by the breakpoints.
    void learn(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Eigen::VectorXd& multipliers) {
        const Eigen::VectorXd whole = to - from;
        const Eigen::VectorXd s = whole.segment(first(), breakpoints());
        if (s.norm() < 1e-12) return;
        const Eigen::VectorXd change = lagrangian_slope(problem_.grid(), to, multipliers) -
                                       lagrangian_slope(problem_.grid(), from, multipliers);
        Eigen::VectorXd y = change.segment(first(), breakpoints());
        // The motion moves with the breakpoints: the curvature along the step is that of both.
        y += (whole.dot(change) - s.dot(y)) / s.squaredNorm() * s;
        if (bfgs_.isZero()) {
            const double curvature = std::abs(s.dot(y)) / s.squaredNorm();
            bfgs_ = std::clamp(curvature, 1e-6, 1e3) * Eigen::MatrixXd::Identity(s.size(), s.size());
        }
        const Eigen::VectorXd image = bfgs_ * s;
        const double curved = s.dot(image), seen = s.dot(y);
        if (seen < 0.2 * curved) {
            const double part = 0.8 * curved / (curved - seen);
            y = part * y + (1.0 - part) * image;
        }
        bfgs_ += y * y.transpose() / s.dot(y) - image * image.transpose() / curved;
    }
};

}  // namespace

FreeKnotResult descend(FreeKnotProblem& problem, const Eigen::VectorXd& start, const Solver& solver,
                       const FreeKnotOptions& options, const SolveControl& control) {
    const SolveControl timed = control.sooner(options.exchange.backend.max_seconds);
    return Descent(problem, solver, options, timed).run(start);
}

}  // namespace camopt

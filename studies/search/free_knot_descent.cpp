// SPDX-License-Identifier: MIT
#include "studies/search/free_knot_descent.hpp"

#include "studies/search/start_search.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// The first step moves a breakpoint by at most this part of the mean segment; later ones by what held.
constexpr double first_radius = 0.25, largest_radius = 1.0, least_radius = 1e-9, telling_radius = 1e-4;
// Of the promised gain: what a step must bring to be taken, and to let the radius grow.
constexpr double least_gain = 1e-4, good = 0.75, poor = 0.25;
// Of the mean segment: the square root of what doubles leave of a row of high derivatives.
constexpr double difference = 1e-6;
// By the moves, where cost and segments are near one: more is rounding over a short step.
constexpr double most_curvature = 1e3;
// Samples of maxima that steps have left behind are dropped when they are this many times those of the start;
// those of rows this near to their bounds stay.
constexpr double most_growth = 1.25;
constexpr double nearly_active = 2e-3;
// Steps in a row that gain next to nothing.
constexpr int most_idle = 3;

/// A best motion for its breakpoints.
struct BestMotion {
    Eigen::VectorXd moves;
    Candidate found;
    std::shared_ptr<const CamProblem> problem;
};

/// Cost and rows of a problem around a motion and its breakpoints.
struct LinearParts {
    const Nlp& grid;
    Eigen::VectorXd rows, gradient, gradient_by_moves;
    std::vector<double> jacobian;
    Eigen::MatrixXd rows_by_moves;  ///< a column for each breakpoint that moves

    /// ∇f + Jᵀ multipliers, by x and then by the moves.
    [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& multipliers) const {
        Eigen::VectorXd all(gradient.size() + gradient_by_moves.size());
        const Eigen::VectorXd of_rows = padded(multipliers);
        all << gradient, gradient_by_moves + rows_by_moves.transpose() * of_rows;
        const SparsityPattern& pattern = grid.shape().jacobian;
        for (std::size_t k = 0; k < jacobian.size(); ++k)
            all[pattern.columns[k]] += jacobian[k] * of_rows[pattern.rows[k]];
        return all;
    }
    /// Those of the first rows; 0 for the others.
    [[nodiscard]] Eigen::VectorXd padded(const Eigen::VectorXd& multipliers) const {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(rows.size());
        all.head(multipliers.size()) = multipliers;
        return all;
    }
};

/// One step of the breakpoints, d: a convex quadratic program over the changes of x, then of the moves.
class StepProgram final : public Nlp {
 public:
    /// `curvature`: the lower triangle of H, on the pattern of the grid; empty: 0.
    StepProgram(const LinearParts& parts, const MovingBreakpoints& breakpoints, const BestMotion& here,
                std::vector<double> curvature, const Eigen::MatrixXd& bfgs, double radius)
        : parts_(parts), curvature_(std::move(curvature)) {
        const NlpShape& shape = parts.grid.shape();
        const Eigen::VectorXd& x = here.found.x;
        const Eigen::Index size = x.size(), moves = bfgs.rows();
        const Eigen::VectorXd room = breakpoints.room(here.moves);
        gradient_.resize(size + moves);
        gradient_ << parts.gradient, parts.gradient_by_moves;
        shape_.x_lower.resize(size + moves);
        shape_.x_upper.resize(size + moves);
        shape_.x_lower << shape.x_lower - x, Eigen::VectorXd::Constant(moves, -radius);
        shape_.x_upper << shape.x_upper - x, Eigen::VectorXd::Constant(moves, radius);
        shape_.g_lower.resize(parts.rows.size() + room.size());
        shape_.g_upper.resize(parts.rows.size() + room.size());
        shape_.g_lower << shape.g_lower - parts.rows, (-room).cwiseMin(0.0);
        shape_.g_upper << shape.g_upper - parts.rows, Eigen::VectorXd::Constant(room.size(), infinity);
        shape_.rows = shape.rows;
        for (RowKind& row : shape_.rows) row.linear = true;
        shape_.rows.insert(shape_.rows.end(), static_cast<std::size_t>(room.size()),
                           RowKind{true, false, 1.0});
        shape_.jacobian = shape.jacobian;
        jacobian_ = parts.jacobian;
        add_columns(parts.rows_by_moves, 0);
        add_columns(breakpoints.room_slope(), parts.rows.size());
        shape_.convex = shape_.quadratic_cost = true;
        if (!curvature_.empty()) shape_.hessian = shape.hessian;
        for (Eigen::Index a = 0; a < (bfgs.isZero() ? 0 : moves); ++a)
            for (Eigen::Index b = 0; b <= a; ++b) {
                shape_.hessian.rows.push_back(static_cast<int>(size + a));
                shape_.hessian.columns.push_back(static_cast<int>(size + b));
                curvature_.push_back(bfgs(a, b));
            }
        shape_.linear_cost = curvature_.empty();
    }

    [[nodiscard]] double cost(const ConstVectorRef& d) const override {
        return gradient_.dot(d) + 0.5 * d.dot(curved(d));
    }
    void gradient(const ConstVectorRef& d, VectorRef out) const override { out = gradient_ + curved(d); }
    void constraints(const ConstVectorRef& d, VectorRef out) const override {
        out.setZero();
        for (std::size_t k = 0; k < jacobian_.size(); ++k)
            out[shape_.jacobian.rows[k]] += jacobian_[k] * d[shape_.jacobian.columns[k]];
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::ranges::copy(jacobian_, out.begin());
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k) out[k] = sigma * curvature_[k];
    }
    [[nodiscard]] std::string variable_name(int index) const override {
        const auto size = static_cast<int>(parts_.gradient.size());
        return index < size ? parts_.grid.variable_name(index) : fmt::format("move {}", index - size);
    }
    [[nodiscard]] std::string row_name(int index) const override { return row_origin(index).text(); }
    [[nodiscard]] RowOrigin row_origin(int index) const override {
        if (index < static_cast<int>(parts_.rows.size())) return parts_.grid.row_origin(index);
        RowOrigin origin;
        origin.rule = "least length of a segment";
        return origin;
    }
    /// H d of a change of x.
    [[nodiscard]] Eigen::VectorXd curved(const Eigen::VectorXd& d) const {
        Eigen::VectorXd image = Eigen::VectorXd::Zero(d.size());
        for (std::size_t k = 0; k < curvature_.size(); ++k) {
            const int row = shape_.hessian.rows[k], column = shape_.hessian.columns[k];
            image[row] += curvature_[k] * d[column];
            if (row != column) image[column] += curvature_[k] * d[row];
        }
        return image;
    }

 private:
    const LinearParts& parts_;
    std::vector<double> curvature_;
    Eigen::VectorXd gradient_;
    std::vector<double> jacobian_;

    void add_columns(const Eigen::MatrixXd& columns, Eigen::Index first_row) {
        for (Eigen::Index k = 0; k < columns.cols(); ++k)
            for (Eigen::Index i = 0; i < columns.rows(); ++i) {
                if (columns(i, k) == 0.0) continue;
                shape_.jacobian.rows.push_back(static_cast<int>(first_row + i));
                shape_.jacobian.columns.push_back(static_cast<int>(parts_.gradient.size() + k));
                jacobian_.push_back(columns(i, k));
            }
    }
};

bool was_solved(Termination termination) {
    return termination == Termination::converged || termination == Termination::acceptable;
}

class Descent {
 public:
    Descent(const MovingBreakpoints& breakpoints, const Solver& solver, const FreeKnotOptions& options,
            const SolveControl& control)
        : breakpoints_(breakpoints), solver_(solver), options_(options), control_(control) {}

    FreeKnotResult run(const MotionChain* start) {
        here_ = best_motion(Eigen::VectorXd::Zero(breakpoints_.size()), start);
        if (here_.found.x.size() == 0) return result_;
        bfgs_ = Eigen::MatrixXd::Zero(breakpoints_.size(), breakpoints_.size());
        most_samples_ = most_growth * static_cast<double>(here_.problem->samples().size());
        std::optional<Termination> ending;
        while (result_.steps < options_.most_steps && !ending && !done()) {
            step();
            ending = control_.ending();
        }
        result_.termination = ending                                ? *ending
                              : result_.steps < options_.most_steps ? Termination::converged
                                                                    : Termination::iteration_limit;
        result_.breakpoints = breakpoints_.points(here_.moves);
        result_.problem = std::move(here_.problem);
        result_.found = std::move(here_.found);
        return result_;
    }

 private:
    const MovingBreakpoints& breakpoints_;
    const Solver& solver_;
    const FreeKnotOptions& options_;
    const SolveControl& control_;
    FreeKnotResult result_;
    BestMotion here_;
    std::optional<LinearParts> parts_;  ///< around here_
    Eigen::VectorXd multipliers_;       ///< of the first rows of parts_
    Eigen::MatrixXd bfgs_;
    double most_samples_ = 0.0;
    double radius_ = first_radius;
    int idle_ = 0;

    [[nodiscard]] double size() const { return std::max(1.0, std::abs(here_.found.objective)); }
    [[nodiscard]] bool feasible(const Candidate& candidate) const {
        return candidate.violation <= options_.exchange.tolerance;
    }
    [[nodiscard]] bool done() const {
        return breakpoints_.size() < 1 || idle_ >= most_idle || radius_ < least_radius ||
               (feasible(here_.found) && here_.found.objective <= options_.enough);
    }

    /// The best motion for given breakpoints; the least violating one where none keeps the limits. From
    /// `first`, or from here_ changed by `change`.
    BestMotion best_motion(const Eigen::VectorXd& moves, const MotionChain* first,
                           const Eigen::VectorXd& change = {}) {
        BestMotion best{moves, {}, {}};
        CamModel model = breakpoints_.model(moves);
        if (!model.design.contradictions().empty()) return best;
        const std::vector<RuleSample> samples =
            here_.problem ? moved_samples(here_.problem->model(), model, here_.problem->samples())
                          : samples_between(model);
        const auto problem = std::make_shared<CamProblem>(std::move(model), samples);
        Eigen::VectorXd start = problem->start();
        if (first != nullptr) {
            const MotionFamily& family = problem->model().design;
            start.head(family.size()) =
                same_motion(family, *first).cwiseQuotient(design_scales(problem->model()));
        } else if (change.size() > 0 && here_.found.x.size() == start.size()) {
            start = carried(*here_.problem, here_.found.x, problem->model()) + change.head(start.size());
        }
        const ExchangeOptions& options = options_.exchange;
        const ExchangeResult ran =
            minimize_by_exchange(*problem, solver_, problem->completed(start), options, control_);
        result_.rounds += ran.rounds;
        result_.iterations += ran.iterations;
        best.found = is_better(ran.latest, ran.best, options.tolerance) ? ran.latest : ran.best;
        if (best.found.x.size() == 0) return best;
        if (!feasible(best.found) && problem->grid().shape().convex && !control_.ending()) {
            const Feasibility nearest = find_feasible(*problem, options, control_);
            if (nearest.point.x.size() > 0 && is_better(nearest.point, best.found, options.tolerance))
                best.found = nearest.point;
        }
        best.problem = problem;
        return best;
    }

    [[nodiscard]] LinearParts linear_parts(const BestMotion& at) const {
        const Eigen::VectorXd& x = at.found.x;
        const CamProblem& problem = *at.problem;
        const NlpShape& shape = problem.grid().shape();
        LinearParts parts{problem.grid(),
                          Eigen::VectorXd(shape.constraints()),
                          Eigen::VectorXd(x.size()),
                          Eigen::VectorXd::Zero(at.moves.size()),
                          {},
                          {}};
        parts.grid.constraints(x, parts.rows);
        parts.grid.gradient(x, parts.gradient);
        parts.jacobian.resize(static_cast<std::size_t>(shape.jacobian.size()));
        parts.grid.jacobian(x, parts.jacobian);
        parts.rows_by_moves = Eigen::MatrixXd::Zero(shape.constraints(), at.moves.size());
        const double cost = parts.grid.cost(x);
        for (Eigen::Index k = 0; k < at.moves.size() && !control_.ending(); ++k) {
            Eigen::VectorXd moves = at.moves;
            moves[k] += difference;
            const auto model = std::make_shared<const CamModel>(breakpoints_.model(moves));
            const GridNlp grid(model, moved_samples(problem.model(), *model, problem.samples()));
            // Where other pieces take part a step shows what comes of it.
            if (grid.shape().variables() != x.size() || grid.shape().constraints() != parts.rows.size())
                continue;
            const Eigen::VectorXd same = carried(problem, x, *model);
            Eigen::VectorXd rows(parts.rows.size());
            grid.constraints(same, rows);
            parts.rows_by_moves.col(k) = (rows - parts.rows) / difference;
            parts.gradient_by_moves[k] = (grid.cost(same) - cost) / difference;
        }
        return parts;
    }

    /// H on the pattern of the grid of parts_.
    [[nodiscard]] std::vector<double> curvature() const {
        const NlpShape& shape = parts_->grid.shape();
        std::vector<double> values(static_cast<std::size_t>(shape.hessian.size()));
        if (values.empty()) return values;
        const Eigen::VectorXd multipliers = parts_->padded(shape.convex ? multipliers_ : Eigen::VectorXd());
        parts_->grid.hessian(here_.found.x, 1.0, multipliers, values);
        return values;
    }

    void thin() {
        const CamProblem& problem = *here_.problem;
        const std::vector<RuleSample>& samples = problem.samples();
        Eigen::VectorXd rows(problem.grid().shape().constraints());
        problem.grid().constraints(here_.found.x, rows);
        CamModel model = problem.model();
        std::vector<RuleSample> kept = samples_between(model);
        const Eigen::Index first = rows.size() - static_cast<Eigen::Index>(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (rows[first + static_cast<Eigen::Index>(i)] > -nearly_active) kept.push_back(samples[i]);
        here_.problem = std::make_shared<const CamProblem>(std::move(model), kept);
        most_samples_ = most_growth * static_cast<double>(here_.problem->samples().size());
        parts_.reset();
        multipliers_.resize(0);
    }

    void step() {
        ++result_.steps;
        if (static_cast<double>(here_.problem->samples().size()) > most_samples_) thin();
        if (!parts_) parts_.emplace(linear_parts(here_));
        const StepProgram model(*parts_, breakpoints_, here_, curvature(), bfgs_, radius_);
        BackendOptions options;
        options.tolerance = options_.exchange.backend.tolerance;
        options.max_seconds = options_.exchange.backend.max_seconds;
        options.has_optimum = feasible(here_.found);
        const BackendResult ran =
            solver_.minimize(model, Eigen::VectorXd::Zero(model.shape().variables()), options, control_);
        result_.iterations += ran.iterations;
        ++result_.rounds;
        if (control_.ending()) return;  // half a step promises nothing
        if (ran.x.size() == 0 || !ran.x.allFinite()) {
            radius_ *= 0.25;
            return;
        }
        if (ran.row_multipliers) multipliers_ = ran.row_multipliers->head(parts_->rows.size());
        const Eigen::VectorXd change = within_room(ran.x);
        const double promised = -model.cost(change);
        const Eigen::VectorXd move = change.tail(breakpoints_.size());
        BestMotion found = best_motion(here_.moves + move, nullptr, change);
        // A short step promises little more than rounding.
        if (feasible(here_.found) && radius_ >= telling_radius && was_solved(ran.termination))
            result_.stationarity = std::max(0.0, promised) / size() / radius_;
        const bool taken =
            judge(found, promised, move.lpNorm<Eigen::Infinity>(), was_solved(ran.termination));
        const bool comparable = found.found.x.size() == here_.found.x.size();
        std::optional<LinearParts> beyond;
        if (comparable) beyond.emplace(linear_parts(found));
        if (beyond && beyond->rows.size() >= parts_->rows.size()) learn(model, found, *beyond);
        if (taken) {
            here_ = std::move(found);
        } else if (beyond && beyond->rows.size() > parts_->rows.size()) {
            // The maxima of a motion that was not taken: the next step sees them.
            CamModel own = here_.problem->model();
            std::vector<RuleSample> samples =
                moved_samples(found.problem->model(), own, found.problem->samples());
            here_.problem = std::make_shared<const CamProblem>(std::move(own), samples);
            beyond.reset();
        } else {
            return;
        }
        if (!beyond || multipliers_.size() > beyond->rows.size()) multipliers_.resize(0);
        parts_.reset();
        if (beyond) parts_.emplace(std::move(*beyond));
    }

    /// As much of a change as leaves every segment its least length: a step program without a solution gives
    /// any point.
    [[nodiscard]] Eigen::VectorXd within_room(Eigen::VectorXd change) const {
        const Eigen::VectorXd room = breakpoints_.room(here_.moves).cwiseMax(0.0);
        const Eigen::VectorXd moved = breakpoints_.room_slope() * change.tail(breakpoints_.size());
        double part = 1.0;
        for (Eigen::Index i = 0; i < room.size(); ++i)
            if (room[i] + moved[i] < 0.0) part = std::min(part, room[i] / -moved[i]);
        return part * change;
    }

    /// Whether a motion is taken.
    [[nodiscard]] bool judge(const BestMotion& found, double promised, double length, bool solved) {
        const bool better =
            found.found.x.size() > 0 && is_better(found.found, here_.found, options_.exchange.tolerance);
        const bool comparable = feasible(found.found) && feasible(here_.found);
        const double gain = comparable ? here_.found.objective - found.found.objective
                            : better   ? infinity
                                       : -infinity;
        const double ratio = comparable ? gain / std::max(promised, 1e-15) : better ? 1.0 : -1.0;
        const bool idle = comparable && solved && std::max(gain, promised) <= options_.tolerance * size();
        idle_ = idle ? idle_ + 1 : 0;
        if (ratio > good && length > 0.9 * radius_) radius_ = std::min(2.0 * radius_, largest_radius);
        if (ratio < poor) radius_ = 0.5 * std::min(radius_, std::max(length, least_radius));
        if (control_.progress && result_.steps % 10 == 0) {
            const std::string line =
                fmt::format("breakpoints, step {}: objective {:.9g}", result_.steps, here_.found.objective);
            Progress progress(line);
            progress.incumbent = here_.found.objective;
            progress.violation = here_.found.violation;
            control_.progress(progress);
        }
        return better && ratio > least_gain;
    }

    /// Damped BFGS on the Lagrangian's slope by the breakpoints.
    void learn(const StepProgram& model, const BestMotion& found, const LinearParts& beyond) {
        const Eigen::Index size = here_.found.x.size();
        Eigen::VectorXd whole(size + breakpoints_.size());
        whole << found.found.x - carried(*here_.problem, here_.found.x, found.problem->model()),
            found.moves - here_.moves;
        const Eigen::VectorXd s = whole.tail(breakpoints_.size());
        if (s.norm() < 1e-12) return;
        Eigen::VectorXd change = beyond.slope(multipliers_) - parts_->slope(multipliers_);
        Eigen::VectorXd only_x = whole;
        only_x.tail(breakpoints_.size()).setZero();
        change -= model.curved(only_x);  // known already
        Eigen::VectorXd y = change.tail(breakpoints_.size());
        // The motion moves with the breakpoints: the curvature along the step is that of both.
        y += (whole.dot(change) - s.dot(y)) / s.squaredNorm() * s;
        if (bfgs_.isZero()) {
            const double curvature = std::abs(s.dot(y)) / s.squaredNorm();
            bfgs_ =
                std::clamp(curvature, 1e-6, most_curvature) * Eigen::MatrixXd::Identity(s.size(), s.size());
        }
        const Eigen::VectorXd image = bfgs_ * s;
        const double curved = s.dot(image), seen = s.dot(y);
        if (seen < 0.2 * curved) {
            const double part = 0.8 * curved / (curved - seen);
            y = part * y + (1.0 - part) * image;
        }
        if (y.squaredNorm() > most_curvature * s.dot(y)) return;
        bfgs_ += y * y.transpose() / s.dot(y) - image * image.transpose() / curved;
    }
};

}  // namespace

FreeKnotResult descend(const MovingBreakpoints& breakpoints, const MotionChain* start, const Solver& solver,
                       const FreeKnotOptions& options, const SolveControl& control) {
    const SolveControl timed = control.sooner(options.exchange.backend.max_seconds);
    return Descent(breakpoints, solver, options, timed).run(start);
}

}  // namespace camopt

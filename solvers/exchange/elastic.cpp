// SPDX-License-Identifier: MIT
#include "solvers/exchange/exchange.hpp"
#include "solvers/structured/structured_solver.hpp"

namespace camopt {

class ElasticProblem::Grid final : public Nlp {
 public:
    explicit Grid(const Nlp& base) : base_(base), t_(base.shape().variables()) {
        shape_ = base.shape();
        shape_.linear_cost = true;
        shape_.quadratic_cost = true;
        shape_.x_lower.conservativeResize(t_ + 1);
        shape_.x_upper.conservativeResize(t_ + 1);
        shape_.x_lower[t_] = -least_slack;
        shape_.x_upper[t_] = infinity;
        leave_out_idle();
        for (int i = 0; i < shape_.constraints(); ++i) {
            if (!shape_.rows[i].limit) continue;
            if (shape_.g_lower[i] > -infinity) throw ModelError(base.row_name(i) + ": a limit has one side");
            relaxed_.push_back(i);
            shape_.jacobian.rows.push_back(i);
            shape_.jacobian.columns.push_back(t_);
        }
    }
    double cost(const ConstVectorRef& x) const override { return x[t_]; }
    void gradient(const ConstVectorRef&, VectorRef out) const override {
        out.setZero();
        out[t_] = 1.0;
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        base_.constraints(x.head(t_), out);
        for (const int i : relaxed_) out[i] -= x[t_] * shape_.rows[i].scale;
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        const std::size_t base_size = out.size() - relaxed_.size();
        base_.jacobian(x.head(t_), out.first(base_size));
        for (std::size_t k = 0; k < relaxed_.size(); ++k)
            out[base_size + k] = -shape_.rows[relaxed_[k]].scale;
    }
    void hessian(const ConstVectorRef& x, double, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        base_.hessian(x.head(t_), 0.0, lambda, out);
    }
    std::string variable_name(int index) const override {
        return index == t_ ? "least common violation" : base_.variable_name(index);
    }
    std::string row_name(int index) const override { return base_.row_name(index); }
    RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

    /// Peaks that occur in no limit: they follow any curve, and are computed from it.
    const std::vector<int>& idle() const { return idle_; }

 private:
    /// A variable that is unbounded, and only relaxes its rows, none of them a limit: these rows decide
    /// nothing here. They would weaken the proof: the boxes of such variables are wide, and multiply the
    /// round-off of the multipliers.
    void leave_out_idle() {
        const SparsityPattern& pattern = shape_.jacobian;
        std::vector<double> slopes(static_cast<std::size_t>(pattern.size()));
        base_.jacobian(Eigen::VectorXd::Zero(t_), slopes);
        std::vector<char> eases(static_cast<std::size_t>(t_), 0), hurts(static_cast<std::size_t>(t_), 0);
        for (int k = 0; k < pattern.size(); ++k) {
            const int i = pattern.rows[k], j = pattern.columns[k];
            const RowKind& row = shape_.rows[i];
            const bool eased = row.linear && !row.limit && shape_.g_lower[i] == -infinity && slopes[k] < 0.0;
            (eased ? eases : hurts)[j] = 1;
        }
        for (int j = 0; j < t_; ++j)
            if (eases[j] && !hurts[j] && shape_.x_upper[j] == infinity) idle_.push_back(j);
        for (int k = 0; k < pattern.size(); ++k)
            if (std::ranges::binary_search(idle_, pattern.columns[k]))
                shape_.g_upper[pattern.rows[k]] = infinity;
    }

    const Nlp& base_;
    int t_;
    std::vector<int> relaxed_;
    std::vector<int> idle_;
};

ElasticProblem::ElasticProblem(ContinuousProblem& base)
    : base_(base), grid_(std::make_unique<Grid>(base.grid())) {}

ElasticProblem::~ElasticProblem() = default;

const Nlp& ElasticProblem::grid() const {
    return *grid_;
}

Eigen::VectorXd ElasticProblem::start() const {
    Eigen::VectorXd x(grid_->shape().variables());
    x << base_.start(), 0.0;
    return completed(x);
}

Eigen::VectorXd ElasticProblem::completed(const Eigen::VectorXd& x) const {
    const Candidate base = judged(base_, x.head(x.size() - 1));
    Eigen::VectorXd full = x;
    if (base.x.size() == 0) return full;
    full.head(base.x.size()) = base.x;
    // Where a limit is undefined (an arm that does not reach) no t suffices: the point is unchanged, and the
    // limit violated.
    if (std::isfinite(base.violation)) full[x.size() - 1] = std::max(base.violation, -least_slack);
    return full;
}

std::vector<Violation> ElasticProblem::violations(const Eigen::VectorXd& x, double slack) const {
    const double t = x[x.size() - 1];
    Eigen::VectorXd base = x.head(x.size() - 1);
    if (!grid_->idle().empty()) {
        const Eigen::VectorXd complete = base_.completed(base);
        for (const int j : grid_->idle()) base[j] = complete[j];
    }
    return violations_beyond(base_, base, slack, t);
}

double ElasticProblem::worst_of_limits(const Eigen::VectorXd& x) const {
    const Eigen::Index last = x.size() - 1;
    return std::max(-1.0, base_.worst_of_limits(x.head(last)) - x[last]);
}

int ElasticProblem::refine(std::span<const Violation> worst) {
    const int added = base_.refine(worst);
    if (added > 0) grid_ = std::make_unique<Grid>(base_.grid());
    return added;
}

int ElasticProblem::refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) {
    const int added = base_.refine_pressed(worst, row_multipliers);
    if (added > 0) grid_ = std::make_unique<Grid>(base_.grid());
    return added;
}

Box ElasticProblem::box(double incumbent, double) const {
    const double most = std::max(incumbent, 0.0);
    const Box base = base_.box(infinity, most);
    Box box{Eigen::VectorXd(base.lower.size() + 1), Eigen::VectorXd(base.upper.size() + 1)};
    box.lower << base.lower, -least_slack;
    box.upper << base.upper, most;
    return box;
}

bool ElasticProblem::convex(double) const {
    return base_.convex(infinity);
}

namespace {

// A first solve with this tolerance on the least violation, and what it must find to be the last: a point so
// far inside that nothing much deeper can be missing. Points are pulled towards it, by their own violation
// over its depth.
constexpr double first_look = 1e-3, deep_inside = -1e-2;
// Its rounds end at this part of the depth that the grid allows.
constexpr double deep_enough = 0.75;
// A proof of less than this part of the least violation is sharpened.
constexpr double well_proved = 0.9;
// A least violation close to the tolerance is proved only by multipliers of higher accuracy.
constexpr double second_look = 1e-2;
// Of a second solve where the first has a proof.
constexpr int most_rounds_of_proved = 20;

/// Of a contradiction that these multipliers prove: Σ |λ_i| · uncertainty_i.
double uncertainty_of(const NlpShape& shape, const Eigen::VectorXd& multipliers) {
    double sum = 0.0;
    for (int i = 0; i < shape.constraints(); ++i)
        sum += std::abs(multipliers[i]) * shape.rows[static_cast<std::size_t>(i)].uncertainty;
    return sum;
}

/// Points whose limits are off by more than `violates` call for a proof that there are none.
Feasibility look(ContinuousProblem& problem, ElasticProblem& elastic, const Solver& solver,
                 const Eigen::VectorXd& start, const ExchangeOptions& options, double violates,
                 const SolveControl& control) {
    const ExchangeResult result = minimize_by_exchange(elastic, solver, start, options, control);
    Feasibility found;
    found.termination = result.termination;
    found.seconds_solver = result.seconds_solver;
    if (result.best.x.size() == 0 || !std::isfinite(result.best.violation)) return found;
    const Eigen::VectorXd x = result.best.x;
    found.point = judged(problem, x.head(x.size() - 1));
    const bool on_final_grid = result.last.row_multipliers &&
                               result.last.row_multipliers->size() == elastic.grid().shape().constraints();
    if (found.point.violation > violates && on_final_grid && elastic.convex(result.best.objective)) {
        DualityProof proof = duality_proof(elastic.grid(), x, *result.last.row_multipliers,
                                           elastic.box(result.best.objective, 0.0), "least_common_violation");
        const double least = x[x.size() - 1];
        const bool is_last = options.tolerance <= violates;
        if (is_last && proof.bound < well_proved * least) sharpen(proof, least);
        const double rounding = uncertainty_of(elastic.grid().shape(), *result.last.row_multipliers);
        if (proof.bound > std::max(least_contradiction, rounding)) found.proof = std::move(proof);
    }
    return found;
}

/// By how much a point is off the grid's equations.
double missed_equations(const Nlp& grid, const Eigen::VectorXd& x) {
    const NlpShape& shape = grid.shape();
    Eigen::VectorXd values(shape.constraints());
    grid.constraints(x, values);
    double most = 0.0;
    for (int i = 0; i < shape.constraints(); ++i)
        if (shape.g_lower[i] == shape.g_upper[i])
            most = std::max(most, std::abs(values[i] - shape.g_upper[i]));
    return most;
}

/// Of the first look: it ends deep inside, and its tolerance is one on the least violation.
ExchangeOptions roughly(ExchangeOptions options, const ElasticProblem& elastic) {
    options.tolerance = std::max(options.tolerance, first_look);
    options.backend.tolerance = std::max(options.backend.tolerance, first_look);
    options.enough = [&elastic, decides = options.decides_only](const ExchangeResult& result) {
        const double deepest = deep_enough * elastic.grid().cost(result.last.x);
        const double enough = decides ? 0.0 : std::min(deep_inside, deepest);
        return result.latest.x.size() > 0 && result.latest.objective <= enough;
    };
    return options;
}

/// Of a second look where the first has a proof: only the least violation is not known closely, and where
/// rounding hides it, rounds follow without end.
ExchangeOptions once_proved(ExchangeOptions options) {
    options.most_rounds = std::min(options.most_rounds, most_rounds_of_proved);
    options.enough = [](const ExchangeResult& result) {
        return result.last.termination == Termination::numerical_failure;
    };
    return options;
}

ExchangeOptions more_closely(ExchangeOptions options) {
    options.tolerance *= second_look;
    options.backend.tolerance *= second_look;
    options.backend.exact_steps = ExactSteps::always;
    return options;
}

/// Where rows nearly depend on each other a point close to their equations may be far inside limits that no
/// point on them satisfies.
bool is_inside(const Feasibility& found, const ContinuousProblem& problem, const ExchangeOptions& options) {
    const double inside = options.decides_only ? 0.0 : deep_inside;
    return found.point.x.size() > 0 && found.point.violation <= inside &&
           missed_equations(problem.grid(), found.point.x) <= options.tolerance;
}

/// A proof that there is no point stays one where the next solve finds none.
void keep_proof(Feasibility& found, Feasibility rough, double tolerance) {
    if (!rough.proof || found.proof || found.point.violation <= tolerance) return;
    found.proof = std::move(rough.proof);
    if (!(found.point.violation <= rough.point.violation)) found.point = std::move(rough.point);
}

}  // namespace

Feasibility find_feasible(ContinuousProblem& problem, const ExchangeOptions& options,
                          const SolveControl& control, const Solver* other) {
    ElasticProblem elastic(problem);
    const std::unique_ptr<Solver> structured = make_structured_solver();
    ExchangeOptions own = options;
    own.backend.native.clear();  // they belong to the user's backend
    own.enough = {};
    double seconds = 0.0;
    const auto look_from = [&](const Eigen::VectorXd& start, const ExchangeOptions& how) {
        Feasibility found =
            look(problem, elastic, other ? *other : *structured, start, how, options.tolerance, control);
        seconds = found.seconds_solver += seconds;
        return found;
    };
    const Eigen::VectorXd begin = elastic.start();
    Feasibility rough = look_from(begin, roughly(own, elastic));
    const bool decided = options.decides_only && rough.proof && rough.proof->bound > options.tolerance;
    if (is_inside(rough, problem, options) || decided || control.ending()) return rough;
    Feasibility found = look_from(begin, rough.proof ? once_proved(own) : own);
    keep_proof(found, std::move(rough), options.tolerance);
    const bool open = found.point.violation > options.tolerance && !found.proof;
    if (found.point.x.size() == 0 || !open || control.stopped()) return found;
    Eigen::VectorXd start(found.point.x.size() + 1);
    start << found.point.x, found.point.violation;
    Feasibility again = look_from(start, more_closely(own));
    if (again.point.violation <= options.tolerance) again.proof.reset();
    found.seconds_solver = seconds;
    if (again.point.x.size() > 0 && (again.proof || again.point.violation < found.point.violation))
        return again;
    return found;
}

}  // namespace camopt

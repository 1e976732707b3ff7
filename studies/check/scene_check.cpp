// SPDX-License-Identifier: MIT
#include "studies/check/scene_check.hpp"

#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/least/least_value.hpp"
#include "studies/measured/given_motion.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <random>

namespace camopt {

namespace {

// A derivative by central differences together with how far it can be trusted.
//
//     D(h) = (f(x + h e_j) − f(x − h e_j)) / 2h = f' + c₂h² + c₄h⁴ + …
// is taken at four steps h, h/2, h/4, h/8. Three of them at a time are extrapolated to h = 0 (Richardson,
// error of order h⁶). The two results differ by about the error of the coarser one; a value of f that is
// right to some units in its last place adds rounding, which grows as the step shrinks. Both together are
// the error that is stated: it follows from the step and the size of what is differenced, and needs no
// tolerance of its own.
struct ExtrapolatedDifference {
    Eigen::VectorXd derivative;
    Eigen::VectorXd error;  ///< estimated, >= 0; infinite where a value is not finite
};

struct DifferencedFunction {
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> values;  ///< the components of f at a point
    /// The sum of the magnitudes that each component is summed from near x: its rounding goes by that, and
    /// not by what is left of it.
    Eigen::VectorXd sizes;
};

// A value is taken to be right to so many units in the last place of what it was summed from.
constexpr double value_error = 16.0 * std::numeric_limits<double>::epsilon();
// What Richardson's weights (16/45·…, 64/45) make of the rounding of three differences, at most.
constexpr double amplification = 2.0;

/// From D(h), D(h/2), D(h/4): the terms in h² and h⁴ cancel.
Eigen::VectorXd extrapolated(const Eigen::VectorXd& coarse, const Eigen::VectorXd& middle,
                             const Eigen::VectorXd& fine) {
    return (coarse - 20.0 * middle + 64.0 * fine) / 45.0;
}

/// `step`: h, > 0.
ExtrapolatedDifference extrapolated_difference(const DifferencedFunction& function, const Eigen::VectorXd& x,
                                               Eigen::Index variable, double step) {
    std::array<Eigen::VectorXd, 4> differences;
    Eigen::VectorXd size = function.sizes, at = x;
    double width = step;
    for (Eigen::VectorXd& difference : differences) {
        at[variable] = x[variable] + width;
        const double above = at[variable];
        const Eigen::VectorXd high = function.values(at);
        at[variable] = x[variable] - width;
        const double below = at[variable];
        const Eigen::VectorXd low = function.values(at);
        difference = (high - low) / (above - below);  // the steps that were taken, not those wished for
        size = size.cwiseMax(high.cwiseAbs()).cwiseMax(low.cwiseAbs());
        width *= 0.5;
    }
    const Eigen::VectorXd coarse = extrapolated(differences[0], differences[1], differences[2]);
    ExtrapolatedDifference result;
    result.derivative = extrapolated(differences[1], differences[2], differences[3]);
    const double finest = step / 8.0;
    result.error = (result.derivative - coarse).cwiseAbs() + size * (amplification * value_error / finest);
    for (Eigen::Index i = 0; i < result.error.size(); ++i)
        if (!std::isfinite(result.error[i])) result.error[i] = std::numeric_limits<double>::infinity();
    return result;
}

// Of the coarsest difference, relative: its error of order h⁶ lies far below 1e-10, and no mechanism is led
// out of its reach.
constexpr double difference_step = 2e-3;
// A derivative is wrong where it is off by so many times the estimated error of the difference: that is an
// estimate. A formula that is wrong by 1e-4 of its value is off by far more.
constexpr double surely = 20.0;
constexpr int most_columns = 400;  // of a large problem so many variables are checked, spread evenly

/// A point off every special place, so that a wrong formula cannot agree by chance; seeded, hence repeatable.
Eigen::VectorXd check_point(const ContinuousProblem& problem) {
    Eigen::VectorXd x = problem.completed(problem.start());
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> shift(0.01, 0.1);
    for (double& value : x) value += shift(generator) * std::max(1.0, std::abs(value));
    return x;
}

class Checker {
 public:
    explicit Checker(const Nlp& problem) : problem_(problem), shape_(problem.shape()) {
        std::mt19937_64 generator(2);
        std::uniform_real_distribution<double> weight(-1.0, 1.0);
        multipliers_.resize(shape_.constraints());
        for (double& value : multipliers_) value = weight(generator);
    }

    std::vector<DerivativeError> run(const Eigen::VectorXd& x) {
        const Eigen::VectorXd gradient = gradient_at(x);
        jacobian_ = jacobian_at(x);
        hessian_.resize(static_cast<std::size_t>(shape_.hessian.size()));
        problem_.hessian(x, 1.0, multipliers_, hessian_);
        const DifferencedFunction cost{[this](const Eigen::VectorXd& at) { return cost_at(at); },
                                       Eigen::VectorXd::Constant(1, gradient.cwiseAbs().dot(x.cwiseAbs()))};
        const DifferencedFunction rows{[this](const Eigen::VectorXd& at) { return rows_at(at); },
                                       row_sizes(x)};
        const DifferencedFunction slopes{
            [this](const Eigen::VectorXd& at) { return lagrangian_gradient(at); }, slope_sizes(gradient, x)};
        const int stride = std::max(1, shape_.variables() / most_columns);
        for (int column = 0; column < shape_.variables(); column += stride) {
            const double step = difference_step * std::max(1.0, std::abs(x[column]));
            const ExtrapolatedDifference of_cost = extrapolated_difference(cost, x, column, step);
            compare(errors_[0], gradient[column], {of_cost.derivative[0], of_cost.error[0]}, column, -1);
            compare_rows(extrapolated_difference(rows, x, column, step), column);
            compare_hessian(extrapolated_difference(slopes, x, column, step), column);
        }
        return {errors_.begin(), errors_.end()};
    }

 private:
    Eigen::VectorXd gradient_at(const Eigen::VectorXd& x) const {
        Eigen::VectorXd out(shape_.variables());
        problem_.gradient(x, out);
        return out;
    }
    Eigen::VectorXd rows_at(const Eigen::VectorXd& x) const {
        Eigen::VectorXd out(shape_.constraints());
        problem_.constraints(x, out);
        return out;
    }
    std::vector<double> jacobian_at(const Eigen::VectorXd& x) const {
        std::vector<double> values(static_cast<std::size_t>(shape_.jacobian.size()));
        problem_.jacobian(x, values);
        return values;
    }
    Eigen::VectorXd cost_at(const Eigen::VectorXd& x) const {
        return Eigen::VectorXd::Constant(1, problem_.cost(x));
    }
    Eigen::VectorXd lagrangian_gradient(const Eigen::VectorXd& x) const {
        Eigen::VectorXd out = gradient_at(x);
        const std::vector<double> values = jacobian_at(x);
        for (std::size_t k = 0; k < values.size(); ++k)
            out[shape_.jacobian.columns[k]] += multipliers_[shape_.jacobian.rows[k]] * values[k];
        return out;
    }
    /// What a row is summed from, as if it were linear.
    Eigen::VectorXd row_sizes(const Eigen::VectorXd& x) const {
        Eigen::VectorXd sizes = Eigen::VectorXd::Zero(shape_.constraints());
        for (std::size_t k = 0; k < jacobian_.size(); ++k)
            sizes[shape_.jacobian.rows[k]] += std::abs(jacobian_[k] * x[shape_.jacobian.columns[k]]);
        return sizes;
    }
    /// What the gradient of the Lagrangian is summed from.
    Eigen::VectorXd slope_sizes(const Eigen::VectorXd& gradient, const Eigen::VectorXd& x) const {
        Eigen::VectorXd sizes = gradient.cwiseAbs();
        for (std::size_t k = 0; k < jacobian_.size(); ++k)
            sizes[shape_.jacobian.columns[k]] +=
                std::abs(multipliers_[shape_.jacobian.rows[k]] * jacobian_[k]);
        for (std::size_t k = 0; k < hessian_.size(); ++k) {
            const int row = shape_.hessian.rows[k], column = shape_.hessian.columns[k];
            sizes[row] += std::abs(hessian_[k] * x[column]);
            if (row != column) sizes[column] += std::abs(hessian_[k] * x[row]);
        }
        return sizes;
    }
    struct Difference {
        double value, error;
    };
    void compare(DerivativeError& kind, double exact, const Difference& difference, int column,
                 int row) const {
        ++kind.entries;
        const double distance = std::abs(exact - difference.value);
        const bool agrees = distance <= surely * difference.error && std::isfinite(difference.error);
        if (!agrees) ++kind.wrong;
        // What is sure to be off comes first, then what is farthest off.
        const double beyond = agrees ? 0.0 : distance / difference.error;
        const double size = std::max({1.0, std::abs(exact), std::abs(difference.value)});
        const double error = std::isfinite(distance) ? distance / size : infinity;
        if (std::pair(beyond, error) <= std::pair(kind.beyond, kind.error) && !std::isnan(beyond)) return;
        kind.beyond = !std::isnan(beyond) ? beyond : infinity;
        kind.error = error;
        kind.where = row < 0 ? problem_.variable_name(column)
                             : fmt::format("{} / {}", problem_.row_name(row), problem_.variable_name(column));
    }
    void compare_rows(const ExtrapolatedDifference& difference, int column) {
        Eigen::VectorXd exact = Eigen::VectorXd::Zero(shape_.constraints());
        for (std::size_t k = 0; k < jacobian_.size(); ++k)
            if (shape_.jacobian.columns[k] == column) exact[shape_.jacobian.rows[k]] += jacobian_[k];
        for (int row = 0; row < shape_.constraints(); ++row)
            compare(errors_[1], exact[row], {difference.derivative[row], difference.error[row]}, column, row);
    }
    void compare_hessian(const ExtrapolatedDifference& difference, int column) {
        Eigen::VectorXd exact = Eigen::VectorXd::Zero(shape_.variables());
        for (std::size_t k = 0; k < hessian_.size(); ++k) {
            const int row = shape_.hessian.rows[k], other = shape_.hessian.columns[k];
            if (other == column) exact[row] += hessian_[k];
            if (row == column && other != row) exact[other] += hessian_[k];
        }
        for (int row = 0; row < shape_.variables(); ++row)
            compare(errors_[2], exact[row], {difference.derivative[row], difference.error[row]}, column, -1);
    }

    const Nlp& problem_;
    const NlpShape& shape_;
    Eigen::VectorXd multipliers_;
    std::vector<double> jacobian_, hessian_;  // at the point
    std::array<DerivativeError, 3> errors_{DerivativeError{"gradient", {}, 0.0, 0.0, 0, 0},
                                           DerivativeError{"jacobian", {}, 0.0, 0.0, 0, 0},
                                           DerivativeError{"hessian", {}, 0.0, 0.0, 0, 0}};
};

/// A limit may be several rules (both signs, parts of a cam): the worst of them is its shape.
std::vector<LimitShape> limit_shapes(const CamModel& model) {
    std::vector<LimitShape> shapes;
    const auto add = [&](const std::string& key, Curvature curvature) {
        const auto known = std::ranges::find(shapes, key, &LimitShape::key);
        if (known == shapes.end())
            shapes.push_back({key, curvature});
        else
            known->curvature = std::max(known->curvature, curvature);
    };
    for (const ParameterRow& row : model.parameter_rows)
        if (row.limit) add(row.name, Curvature::linear);
    for (const PlacedRule& rule : model.rules)
        if (rule->limit())
            add(rule->name(), rule->curvature(model.least_displacement, model.most_displacement));
    return shapes;
}

}  // namespace

std::vector<DerivativeError> derivative_errors(const Nlp& problem, const Eigen::VectorXd& x) {
    return Checker(problem).run(x);
}

SceneCheck check_scene(const Scene& scene) {
    const Scene complete = with_written_limits(scene);
    validate(complete);
    (void)sought_number(complete);  // throws: a key that names no number of the scene
    SceneCheck check;
    const PosedScene posed(complete);
    check.plan = plan_of(posed, {.explain = true});
    (void)make_solver(check.plan.solver);
    check_native_options(check.plan.solver, complete.solver.options);
    if (complete.is_given())
        (void)given_motion(complete);  // throws: too few rows
    else if (complete.measured)
        (void)measured_report(complete, posed.reference);  // likewise
    const CamProblem problem(posed.model);
    for (const ConditionConflict& conflict : problem.model().design.redundant())
        check.redundant.push_back(conflict.condition);
    for (const ConditionConflict& conflict : problem.model().design.contradictions())
        check.contradictions.push_back(conflict.condition);
    const NlpShape& shape = problem.grid().shape();
    check.variables = shape.variables();
    check.rows = shape.constraints();
    check.limits = limit_shapes(problem.model());
    check.derivatives = derivative_errors(problem.grid(), check_point(problem));
    check.derivatives_agree =
        std::ranges::all_of(check.derivatives, [](const DerivativeError& error) { return error.wrong == 0; });
    return check;
}

}  // namespace camopt

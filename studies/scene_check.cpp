// SPDX-License-Identifier: MIT
#include "studies/scene_check.hpp"

#include "core/written_limits.hpp"
#include "objectives/cam_problem.hpp"
#include "objectives/free_knot_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

namespace camopt {

namespace {

// Central differences err by h² of truncation and 1e-16 / h of rounding; the cube root of the latter balances
// them.
constexpr double difference_step = 6e-6;
constexpr double agreement = 1e-6;  // a wrong formula is off by far more, rounding by far less
constexpr int most_columns = 400;   // of a large problem so many variables are checked, spread evenly

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
        const int stride = std::max(1, shape_.variables() / most_columns);
        for (int column = 0; column < shape_.variables(); column += stride) {
            const double step = difference_step * std::max(1.0, std::abs(x[column]));
            Eigen::VectorXd above = x, below = x;
            above[column] += step;
            below[column] -= step;
            const double width = above[column] - below[column];
            compare(errors_[0], gradient[column], (problem_.cost(above) - problem_.cost(below)) / width,
                    column, -1);
            compare_rows(x, (rows_at(above) - rows_at(below)) / width, column);
            compare_hessian(x, (lagrangian_gradient(above) - lagrangian_gradient(below)) / width, column);
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
    Eigen::VectorXd lagrangian_gradient(const Eigen::VectorXd& x) const {
        Eigen::VectorXd out = gradient_at(x);
        const std::vector<double> values = jacobian_at(x);
        for (std::size_t k = 0; k < values.size(); ++k)
            out[shape_.jacobian.columns[k]] += multipliers_[shape_.jacobian.rows[k]] * values[k];
        return out;
    }
    void compare(DerivativeError& worst, double exact, double difference, int column, int row) const {
        const double size = std::max({1.0, std::abs(exact), std::abs(difference)});
        const double error = std::abs(exact - difference) / size;
        if (error <= worst.error) return;
        worst.error = std::isfinite(error) ? error : infinity;
        worst.where = row < 0
                          ? problem_.variable_name(column)
                          : fmt::format("{} / {}", problem_.row_name(row), problem_.variable_name(column));
    }
    void compare_rows(const Eigen::VectorXd& x, const Eigen::VectorXd& difference, int column) {
        Eigen::VectorXd exact = Eigen::VectorXd::Zero(shape_.constraints());
        const std::vector<double> values = jacobian_at(x);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (shape_.jacobian.columns[k] == column) exact[shape_.jacobian.rows[k]] += values[k];
        for (int row = 0; row < shape_.constraints(); ++row)
            compare(errors_[1], exact[row], difference[row], column, row);
    }
    void compare_hessian(const Eigen::VectorXd& x, const Eigen::VectorXd& difference, int column) {
        std::vector<double> values(static_cast<std::size_t>(shape_.hessian.size()));
        problem_.hessian(x, 1.0, multipliers_, values);
        Eigen::VectorXd exact = Eigen::VectorXd::Zero(shape_.variables());
        for (std::size_t k = 0; k < values.size(); ++k) {
            const int row = shape_.hessian.rows[k], other = shape_.hessian.columns[k];
            if (other == column) exact[row] += values[k];
            if (row == column && other != row) exact[other] += values[k];
        }
        for (int row = 0; row < shape_.variables(); ++row)
            compare(errors_[2], exact[row], difference[row], column, -1);
    }

    const Nlp& problem_;
    const NlpShape& shape_;
    Eigen::VectorXd multipliers_;
    std::array<DerivativeError, 3> errors_{DerivativeError{"gradient", "", 0.0},
                                           DerivativeError{"jacobian", "", 0.0},
                                           DerivativeError{"hessian", "", 0.0}};
};

/// A limit may be several rules (both signs, parts of a cam): the worst of them is its shape.
std::vector<LimitShape> limit_shapes(const CamModel& model) {
    std::vector<LimitShape> shapes;
    const auto add = [&](const std::string& name, Curvature curvature) {
        const std::string key = name.substr(0, name.find(' '));
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

SceneCheck check_scene(const Scene& given) {
    const Scene scene = with_written_limits(given);
    validate(scene);
    SceneCheck check;
    check.choice = choose_backend(scene);
    (void)make_solver(check.choice.solver);
    check_native_options(check.choice.solver, scene.solver.options);
    CamProblem problem(scene_model(scene, check.choice.design, reference_peaks(scene)));
    for (const ConditionConflict& conflict : problem.model().design.redundant())
        check.redundant.push_back(conflict.condition);
    for (const ConditionConflict& conflict : problem.model().design.contradictions())
        check.contradictions.push_back(conflict.condition);
    std::optional<FreeKnotProblem> free;  // what the search over breakpoints sees
    if (scene.spline.free_knots) free.emplace(scene, reference_peaks(scene));
    const ContinuousProblem& solved = free ? static_cast<const ContinuousProblem&>(*free) : problem;
    const NlpShape& shape = solved.grid().shape();
    check.variables = shape.variables();
    check.rows = shape.constraints();
    // Peaks measured by a displacement that is free: convex for given ones only.
    check.convex = shape.convex && free_displacements(scene, problem.model().design).stretches.empty();
    check.limits = limit_shapes(problem.model());
    check.derivatives = Checker(solved.grid()).run(check_point(solved));
    check.derivatives_agree =
        std::all_of(check.derivatives.begin(), check.derivatives.end(),
                    [](const DerivativeError& error) { return error.error <= agreement; });
    return check;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Every term of the grid problem, both orders of derivative, against central differences.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace grid_nlp_test {

/// y' y'' − q² <= 0: a rule that is curved in the point and in its parameter, to exercise the chain rule.
class CurvedRule final : public PointRule {
 public:
    explicit CurvedRule(int parameter) : PointRule({.name = "curved", .parameters = {parameter}}) {}
    int evaluations() const { return evaluations_; }
    RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override {
        ++evaluations_;
        RuleValue result{0.0, Eigen::VectorXd::Zero(5), Eigen::MatrixXd::Zero(5, 5)};
        const double v = point.derivative[1];
        const double a = point.derivative[2];
        result.value = v * a + 0.3 * point.derivative[0] * point.derivative[3] - q[0] * q[0] * a;
        result.gradient << 0.3 * point.derivative[3], a, v - q[0] * q[0], 0.3 * point.derivative[0],
            -2.0 * q[0] * a;
        result.hessian(0, 3) = result.hessian(3, 0) = 0.3;
        result.hessian(1, 2) = result.hessian(2, 1) = 1.0;
        result.hessian(2, 4) = result.hessian(4, 2) = -2.0 * q[0];
        result.hessian(4, 4) = -2.0 * a;
        return result;
    }

 private:
    mutable int evaluations_ = 0;
};

Scene scene_with_every_term(int degree) {
    Scene scene;
    scene.spline.degree = degree;
    scene.spline.segments = 6;
    scene.objective.velocity = 0.3;
    scene.objective.acceleration = 0.25;
    scene.objective.jerk = 0.2;
    scene.objective.rms_acceleration = 0.15;
    scene.objective.rms_jerk = 0.1;
    scene.limits.jerk = PeakLimit{80.0, "limits.jerk", 80.0, ""};
    return scene;
}

CamModel model_with_every_term(int degree, DesignKind kind) {
    const Scene scene = scene_with_every_term(degree);
    CamModel model = scene_model(scene, kind, reference_peaks(scene));
    model.rules.push_back(std::make_shared<CurvedRule>(1));
    return model;
}

Eigen::MatrixXd dense(const SparsityPattern& pattern, const std::vector<double>& values, int rows,
                      int columns, bool symmetric) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, columns);
    for (int k = 0; k < pattern.size(); ++k) {
        matrix(pattern.rows[k], pattern.columns[k]) += values[k];
        if (symmetric && pattern.rows[k] != pattern.columns[k]) {
            matrix(pattern.columns[k], pattern.rows[k]) += values[k];
        }
    }
    return matrix;
}

class GridDerivatives : public testing::TestWithParam<std::tuple<int, DesignKind>> {
 protected:
    void SetUp() override {
        const auto [degree, kind] = GetParam();
        auto model = std::make_shared<const CamModel>(model_with_every_term(degree, kind));
        std::vector<RuleSample> samples;
        for (int rule = 0; rule < static_cast<int>(model->rules.size()); ++rule) {
            for (const double at : {0.11, 0.5, 0.83}) samples.push_back({rule, at, Side::right});
        }
        grid_ = std::make_unique<GridNlp>(model, samples);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(0.4, 1.6);
        x_.resize(grid_->shape().variables());
        for (double& value : x_) value = number(random);
        lambda_.resize(grid_->shape().constraints());
        for (double& value : lambda_) value = number(random) - 1.0;
    }

    Eigen::VectorXd lagrangian_gradient(const Eigen::VectorXd& x, double sigma) const {
        Eigen::VectorXd gradient(x.size());
        grid_->gradient(x, gradient);
        std::vector<double> values(grid_->shape().jacobian.size());
        grid_->jacobian(x, values);
        const Eigen::MatrixXd jacobian = dense(grid_->shape().jacobian, values, grid_->shape().constraints(),
                                               grid_->shape().variables(), false);
        return sigma * gradient + jacobian.transpose() * lambda_;
    }

    static constexpr double step = 6e-6;  // cube root of the rounding unit: the best for central differences
    std::unique_ptr<GridNlp> grid_;
    Eigen::VectorXd x_, lambda_;
};

TEST_P(GridDerivatives, GradientAndJacobianAgreeWithDifferences) {
    Eigen::VectorXd gradient(x_.size());
    grid_->gradient(x_, gradient);
    std::vector<double> values(grid_->shape().jacobian.size());
    grid_->jacobian(x_, values);
    const Eigen::MatrixXd jacobian = dense(grid_->shape().jacobian, values, grid_->shape().constraints(),
                                           grid_->shape().variables(), false);
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
        Eigen::VectorXd up = x_;
        Eigen::VectorXd down = x_;
        up[j] += step;
        down[j] -= step;
        const double slope = (grid_->cost(up) - grid_->cost(down)) / (2.0 * step);
        EXPECT_NEAR(gradient[j], slope, 1e-6 * std::max(1.0, gradient.cwiseAbs().maxCoeff()))
            << grid_->variable_name(static_cast<int>(j));
        Eigen::VectorXd g_up(grid_->shape().constraints());
        Eigen::VectorXd g_down(grid_->shape().constraints());
        grid_->constraints(up, g_up);
        grid_->constraints(down, g_down);
        const Eigen::VectorXd column = (g_up - g_down) / (2.0 * step);
        for (Eigen::Index i = 0; i < column.size(); ++i) {
            EXPECT_NEAR(jacobian(i, j), column[i],
                        1e-6 * std::max(1.0, jacobian.row(i).cwiseAbs().maxCoeff()))
                << grid_->row_name(static_cast<int>(i)) << " by "
                << grid_->variable_name(static_cast<int>(j));
        }
    }
}

TEST_P(GridDerivatives, HessianMatchesDifferencesOfGradient) {
    constexpr double sigma = 0.7;
    std::vector<double> values(grid_->shape().hessian.size());
    grid_->hessian(x_, sigma, lambda_, values);
    const int size = grid_->shape().variables();
    const Eigen::MatrixXd hessian = dense(grid_->shape().hessian, values, size, size, true);
    EXPECT_GT(hessian.cwiseAbs().maxCoeff(), 0.01);
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
        Eigen::VectorXd up = x_;
        Eigen::VectorXd down = x_;
        up[j] += step;
        down[j] -= step;
        const Eigen::VectorXd column =
            (lagrangian_gradient(up, sigma) - lagrangian_gradient(down, sigma)) / (2.0 * step);
        for (Eigen::Index i = 0; i < column.size(); ++i) {
            EXPECT_NEAR(hessian(i, j), column[i], 2e-6 * std::max(1.0, hessian.cwiseAbs().maxCoeff()))
                << grid_->variable_name(static_cast<int>(i)) << ", "
                << grid_->variable_name(static_cast<int>(j));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, GridDerivatives,
                         testing::Combine(testing::Values(3, 5),
                                          testing::Values(DesignKind::ordinates, DesignKind::coefficients,
                                                          DesignKind::states)),
                         [](const auto& form) {
                             return "degree" + std::to_string(std::get<0>(form.param)) + "_" +
                                    name_of(std::get<1>(form.param));
                         });

TEST(GridNlp, EvaluatesRuleOncePerPoint) {
    CamModel model = model_with_every_term(3, DesignKind::states);
    const auto rule = std::make_shared<CurvedRule>(1);
    model.rules.push_back(rule);
    const int index = static_cast<int>(model.rules.size()) - 1;
    const GridNlp grid(std::make_shared<const CamModel>(std::move(model)), {{index, 0.3, Side::right}});
    const auto evaluate_all = [&](const Eigen::VectorXd& x, double multiplier) {
        Eigen::VectorXd rows(grid.shape().constraints());
        std::vector<double> jacobian(grid.shape().jacobian.size()), hessian(grid.shape().hessian.size());
        grid.constraints(x, rows);
        grid.jacobian(x, jacobian);
        grid.hessian(x, 0.0, Eigen::VectorXd::Constant(rows.size(), multiplier), hessian);
        return std::ranges::any_of(hessian, [](double value) { return value != 0.0; });
    };
    const Eigen::VectorXd one = Eigen::VectorXd::Constant(grid.shape().variables(), 0.7), other = 2.0 * one;
    EXPECT_TRUE(evaluate_all(one, 1.0));
    EXPECT_EQ(rule->evaluations(), 1);
    EXPECT_FALSE(evaluate_all(other, 0.0)) << "multipliers of 0 leave no curvature";
    EXPECT_EQ(rule->evaluations(), 2);
    EXPECT_TRUE(evaluate_all(one, 1.0));
    EXPECT_EQ(rule->evaluations(), 3);
}

TEST(GridNlp, ContainsOnlyRequestedTerms) {
    Scene scene;
    scene.objective.velocity = 1.0;
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    ASSERT_EQ(model.parameters.size(), 1u);
    EXPECT_EQ(model.parameters[0].name, "peak velocity");
    EXPECT_EQ(model.rules.size(), 2u);
    EXPECT_TRUE(model.parameter_rows.empty());
    const CamProblem problem(model);
    EXPECT_EQ(problem.grid().shape().hessian.size(), 0);
    EXPECT_TRUE(problem.grid().shape().linear_cost);
    EXPECT_TRUE(problem.grid().shape().convex);
}

TEST(GridNlp, RowsAndVariablesHaveNames) {
    const Scene scene = scene_with_every_term(3);
    const CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const Nlp& grid = problem.grid();
    EXPECT_EQ(grid.variable_name(0), "y[1]");
    EXPECT_EQ(grid.variable_name(grid.shape().variables() - 1), "rms jerk");
    EXPECT_EQ(grid.row_name(0), "continuity of derivative 0 at x = 0.166667");
    EXPECT_EQ(grid.row_name(static_cast<int>(problem.model().design.equalities().size())), "limits.jerk");
    EXPECT_EQ(grid.row_name(grid.shape().constraints() - 1), "-jerk at x = 0.833333333");
}

}  // namespace grid_nlp_test
}  // namespace camopt

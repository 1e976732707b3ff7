// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "splines/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace camopt {
namespace tied_problem_test {

constexpr double weight = 0.3;

CamProblem weighted_problem(double rms_jerk) {
    Scene scene;
    scene.spline.segments = 6;
    scene.objective.velocity = 0.4;
    scene.objective.jerk = 0.2;
    scene.objective.rms_jerk = rms_jerk;
    return CamProblem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
}

TEST(TiedProblem, CostsTheMeanSquareJerkMore) {
    CamProblem problem = weighted_problem(0.0);
    const TiedProblem tied(problem, weight);
    const Eigen::VectorXd x = problem.start();
    const double jerk = peaks_of(problem.curve(x)).rms_jerk / problem.model().jerk_reference;
    EXPECT_NEAR(tied.energy(x), jerk * jerk, 1e-12 * jerk * jerk);
    EXPECT_NEAR(tied.objective(x), problem.objective(x) + weight * jerk * jerk, 1e-12);
    EXPECT_FALSE(tied.grid().shape().linear_cost);
    EXPECT_TRUE(tied.grid().shape().quadratic_cost);
}

TEST(TiedProblem, ItsDerivativesAgreeWithDifferences) {
    for (const double rms_jerk : {0.0, 0.5}) {  // with the latter the base has a Hessian of its own
        CamProblem problem = weighted_problem(rms_jerk);
        const TiedProblem tied(problem, weight);
        const Nlp& grid = tied.grid();
        const Eigen::VectorXd x = problem.start();
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(grid.shape().constraints());
        const auto gradient = [&](const Eigen::VectorXd& at) {
            Eigen::VectorXd out(at.size());
            grid.gradient(at, out);
            return out;
        };
        std::vector<double> values(static_cast<std::size_t>(grid.shape().hessian.size()));
        grid.hessian(x, 1.0, none, values);
        Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(x.size(), x.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            const int row = grid.shape().hessian.rows[k], column = grid.shape().hessian.columns[k];
            hessian(row, column) += values[k];
            if (row != column) hessian(column, row) += values[k];
        }
        constexpr double step = 1e-5;
        for (Eigen::Index j = 0; j < x.size(); ++j) {
            Eigen::VectorXd up = x, down = x;
            up[j] += step;
            down[j] -= step;
            EXPECT_NEAR((grid.cost(up) - grid.cost(down)) / (2.0 * step), gradient(x)[j],
                        1e-6 * std::max(1.0, gradient(x).cwiseAbs().maxCoeff()));
            const Eigen::VectorXd column = (gradient(up) - gradient(down)) / (2.0 * step);
            EXPECT_LE((column - hessian.col(j)).cwiseAbs().maxCoeff(),
                      1e-6 * std::max(1.0, hessian.cwiseAbs().maxCoeff()))
                << grid.variable_name(static_cast<int>(j));
        }
    }
}

TEST(TiedProblem, RefinesTheGridOfItsProblem) {
    CamProblem problem = weighted_problem(0.0);
    TiedProblem tied(problem, weight);
    const int before = tied.grid().shape().constraints();
    const std::vector<Violation> worst{{0, {0.1, 0.07, Side::right}, 0.1, false}};
    EXPECT_EQ(tied.refine(worst), 3);
    EXPECT_EQ(tied.grid().shape().constraints(), before + 3);
    EXPECT_EQ(problem.grid().shape().constraints(), before + 3);
    EXPECT_EQ(tied.grid().shape().jacobian.rows, problem.grid().shape().jacobian.rows);
}

}  // namespace tied_problem_test
}  // namespace camopt

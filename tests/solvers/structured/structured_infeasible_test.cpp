// SPDX-License-Identifier: MIT
// Infeasible problems come with a Farkas ray; barely feasible ones are solved.
#include "tests/solvers/structured/structured_problems.hpp"

#include <random>

namespace camopt::testing {
namespace structured_infeasible_test {

TEST(StructuredInfeasible, NoCurveIsSlowerThanMean) {
    for (const int n : {8, 24, 64})
        for (const double cap : {0.2, 0.9, 0.999999}) {
            CamCase cam = uniform_cam(n);
            cam.velocity_cap = cap;
            const QuadraticNlp problem(cam_problem(cam));
            const BackendResult result = solve(problem);
            expect_farkas(problem, result, 1e-8);
            EXPECT_LE(result.iterations, 100);
        }
}

TEST(StructuredInfeasible, AccelerationAndJerkCaps) {
    CamCase cam = uniform_cam(24);
    cam.acceleration_cap = 3.9;  // least 4
    const QuadraticNlp first(cam_problem(cam));
    expect_farkas(first, solve(first), 1e-8);
    cam = uniform_cam(24);
    cam.jerk_cap = 31.9;  // least 32
    const QuadraticNlp second(cam_problem(cam));
    expect_farkas(second, solve(second), 1e-8);
}

TEST(StructuredInfeasible, CapsAroundTheLeastVelocity) {
    for (const int n : {12, 24}) {
        CamCase cam = uniform_cam(n);
        cam.acceleration = cam.jerk = 0.0;
        const QuadraticNlp least(cam_problem(cam));
        const BackendResult slowest = solve(least);
        ASSERT_EQ(slowest.termination, Termination::converged);
        const double velocity = slowest.x[slowest.x.size() - 3];
        for (const double room : {1e-3, 1e-6, 1e-9}) {
            CamCase tight = uniform_cam(n);
            tight.velocity_cap = velocity + room;
            const QuadraticNlp problem(cam_problem(tight));
            expect_optimal(problem, solve(problem), 5e-9);
        }
        for (const double lack : {1e-6, 1e-4}) {
            CamCase tight = uniform_cam(n);
            tight.velocity_cap = velocity - lack;
            const QuadraticNlp problem(cam_problem(tight));
            expect_farkas(problem, solve(problem), 1e-8);
        }
    }
}

TEST(StructuredInfeasible, RejectsFixedRowsAndCrossedBounds) {
    QuadraticData data(2);
    data.x_lower << 1.0, 0.0;
    data.x_upper << 1.0, 5.0;
    RowCollector rows;
    rows.add({{0, 2.0}}, 3.0, infinity);
    rows.write(data);
    data.row_constant = Eigen::VectorXd::Constant(1, 0.5);
    const QuadraticNlp problem(data);
    expect_farkas(problem, solve(problem), 1e-12);
    data.x_lower[1] = 6.0;
    const BackendResult crossed = solve(QuadraticNlp(data));
    EXPECT_EQ(crossed.termination, Termination::infeasible);
    EXPECT_FALSE(crossed.row_multipliers);
}

TEST(StructuredInfeasible, ContradictoryEqualities) {
    QuadraticData data(3);
    data.cost << 1.0, 1.0, 1.0;
    RowCollector rows;
    rows.add({{0, 1.0}, {1, 1.0}}, 1.0, 1.0);
    rows.add({{1, 1.0}, {2, 1.0}}, 1.0, 1.0);
    rows.add({{0, 1.0}, {1, 2.0}, {2, 1.0}}, 2.5, 2.5);
    rows.write(data);
    const QuadraticNlp problem(data);
    expect_farkas(problem, solve(problem), 1e-8);
}

TEST(StructuredInfeasible, RandomSystems) {
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        // Rows whose positive combination is 0 <= −gap.
        const int size = 2 + trial % 9, count = size + 2 + trial % 13;
        Eigen::MatrixXd g = Eigen::MatrixXd::NullaryExpr(count, size, [&] { return normal(random); });
        Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(count, [&] { return uniform(random) + 0.1; });
        g.row(count - 1) = -(y.head(count - 1).transpose() * g.topRows(count - 1)) / y[count - 1];
        QuadraticData data(size);
        data.rows = g.sparseView();
        data.cost = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
        data.lower = Eigen::VectorXd::Constant(count, -infinity);
        data.upper = g * Eigen::VectorXd::Ones(size);
        data.upper -= Eigen::VectorXd::Constant(count, std::pow(10.0, -(trial % 4)));
        if (trial % 3 == 0) {
            data.x_lower.setConstant(-10.0);
            data.x_upper.setConstant(10.0);
        }
        if (trial % 5 == 0)
            data.hessian = Eigen::MatrixXd(Eigen::MatrixXd::Identity(size, size)).sparseView();
        const QuadraticNlp problem(data);
        const BackendResult result = solve(problem);
        expect_farkas(problem, result, 1e-8);
        EXPECT_LE(result.iterations, 100) << trial;
    }
}

}  // namespace structured_infeasible_test
}  // namespace camopt::testing

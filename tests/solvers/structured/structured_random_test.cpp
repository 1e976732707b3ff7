// SPDX-License-Identifier: MIT
// Random programs built around a known optimal pair of point and multipliers.
#include "tests/solvers/structured/structured_problems.hpp"

#include <random>

namespace camopt::testing {
namespace structured_random_test {

struct Known {
    QuadraticData data;
    double optimum = 0.0;
};

Known known_problem(unsigned seed, bool curved) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const int size = 2 + static_cast<int>(seed % 29), count = 1 + static_cast<int>((seed * 7) % 41);
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(count, size);
    for (int i = 0; i < count; ++i) {
        g(i, i % size) = normal(random);
        for (int j = 0; j < size; ++j)
            if (uniform(random) < 0.3) g(i, j) = normal(random);
        g.row(i) *= std::pow(10.0, static_cast<int>(seed % 3) * (uniform(random) - 0.5));
    }
    if (count > 3 && seed % 4 == 0) g.row(count - 1) = g.row(0) + g.row(1);  // a dependent row
    Known made{QuadraticData(size), 0.0};
    QuadraticData& data = made.data;
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    const Eigen::VectorXd values = g * x;
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(count), z = Eigen::VectorXd::Zero(size);
    data.lower.resize(count);
    data.upper.resize(count);
    const auto place = [&](double value, double& low, double& high, double& multiplier) {
        const double kind = uniform(random), size_of = 0.1 + uniform(random);
        const double degenerate = uniform(random) < 0.1 ? 0.0 : 1.0;
        low = uniform(random) < 0.5 ? value - 1.0 - uniform(random) : -infinity;
        high = uniform(random) < 0.5 ? value + 1.0 + uniform(random) : infinity;
        if (kind < 0.3) {
            high = value;
            multiplier = degenerate * size_of;
        } else if (kind < 0.6) {
            low = value;
            multiplier = -degenerate * size_of;
        } else if (kind < 0.75) {
            low = high = value;
            multiplier = normal(random);
        }
    };
    for (int i = 0; i < count; ++i) place(values[i], data.lower[i], data.upper[i], lambda[i]);
    for (int j = 0; j < size; ++j) place(x[j], data.x_lower[j], data.x_upper[j], z[j]);
    data.rows = g.sparseView();
    Eigen::VectorXd gradient = -(g.transpose() * lambda + z);
    if (curved) {
        const Eigen::MatrixXd half =
            Eigen::MatrixXd::NullaryExpr(1 + size / 2, size, [&] { return normal(random); });
        const Eigen::MatrixXd hessian = half.transpose() * half;
        data.hessian = hessian.sparseView();
        data.cost = gradient - hessian * x;
    } else {
        data.cost = gradient;
    }
    made.optimum = QuadraticNlp(data).cost(x);
    return made;
}

TEST(StructuredRandom, LinearPrograms) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const Known known = known_problem(seed, false);
        const QuadraticNlp problem(known.data);
        const BackendResult result = solve(problem);
        SCOPED_TRACE(seed);
        expect_optimal(problem, result, 1e-8);
        EXPECT_NEAR(problem.cost(result.x), known.optimum, 2e-9 * (1.0 + std::abs(known.optimum)));
    }
}

TEST(StructuredRandom, QuadraticPrograms) {
    for (unsigned seed = 1001; seed <= 1150; ++seed) {
        const Known known = known_problem(seed, true);
        const QuadraticNlp problem(known.data);
        const BackendResult result = solve(problem);
        SCOPED_TRACE(seed);
        expect_optimal(problem, result, 1e-8);
        EXPECT_NEAR(problem.cost(result.x), known.optimum, 2e-9 * (1.0 + std::abs(known.optimum)));
    }
}

}  // namespace structured_random_test
}  // namespace camopt::testing

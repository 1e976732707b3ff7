// SPDX-License-Identifier: MIT
// Corner to corner through random programs: bounds that are proved and met, whatever was asked before.
#include "solvers/vertex/vertex_program.hpp"

#include "core/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace vertex_program_test {

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}
Eigen::VectorXd random_vector(std::mt19937& random, int size) {
    return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random, -1.0, 1.0); });
}

TEST(VertexProgram, ReachesBoundForEveryCost) {
    std::mt19937 random(5);
    for (int problem = 0; problem < 40; ++problem) {
        const int variables = 2 + problem % 23;
        const Eigen::VectorXd inside = 0.5 * random_vector(random, variables);
        VertexProgram program(Eigen::VectorXd::Constant(variables, -2.0),
                              Eigen::VectorXd::Constant(variables, 2.0));
        std::vector<Eigen::VectorXd> rows;
        std::vector<double> sides;
        const auto add = [&] {
            const Eigen::VectorXd a =
                std::exp2(uniform(random, -6.0, 6.0)) * random_vector(random, variables);
            const double room = random() % 4 == 0 ? 0.0 : uniform(random, 0.0, 0.3) * a.norm();
            rows.push_back(a);
            sides.push_back(a.dot(inside) + room);
            program.add_row(a, sides.back());
        };
        for (int k = 0; k < 3 * variables; ++k) add();
        for (int ask = 0; ask < 30; ++ask) {
            if (ask % 5 == 4) add();
            if (ask == 17) {  // those the corner does not lie on go, and come back
                const auto stay = program.drop_rows(std::vector<char>(rows.size(), 0));
                std::vector<Eigen::VectorXd> kept;
                std::vector<double> kept_sides;
                for (const int row : stay) {
                    kept.push_back(rows[static_cast<std::size_t>(row)]);
                    kept_sides.push_back(sides[static_cast<std::size_t>(row)]);
                }
                rows = kept;
                sides = kept_sides;
            }
            const Eigen::VectorXd cost = random_vector(random, variables);
            const VertexBound found = program.minimize(cost, {});
            ASSERT_EQ(found.status, VertexBound::Status::optimal) << problem << ", " << ask;
            // The corner lies outside the sides by the hair that they were moved.
            EXPECT_NEAR(found.bound, cost.dot(found.x), 1e-5);
            EXPECT_LE(found.bound, cost.dot(inside));
            EXPECT_LE(found.x.cwiseAbs().maxCoeff(), 2.0 + 1e-8);
            for (std::size_t i = 0; i < rows.size(); ++i)
                EXPECT_LE(rows[i].dot(found.x), sides[i] + 1e-7 * (1.0 + rows[i].norm()));
            // The bound by hand, from what is handed out.
            Eigen::VectorXd rest = cost;
            double bound = 0.0;
            for (const auto& [row, multiplier] : found.multipliers) {
                EXPECT_GT(multiplier, 0.0);
                rest += multiplier * rows[static_cast<std::size_t>(row)];
                bound -= multiplier * sides[static_cast<std::size_t>(row)];
            }
            bound -= 2.0 * rest.cwiseAbs().sum();
            EXPECT_NEAR(bound, found.bound, 1e-9);
        }
    }
}

TEST(VertexProgram, ProvesThatThereIsNothing) {
    VertexProgram program(Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 1.0));
    program.add_row(Eigen::Vector2d(1.0, 1.0), 1.0);
    EXPECT_EQ(program.minimize(Eigen::Vector2d(-1.0, -2.0), {}).status, VertexBound::Status::optimal);
    program.add_row(Eigen::Vector2d(-1.0, -1.0), -1.0 - 1e-6);
    const VertexBound nothing = program.minimize(Eigen::Vector2d(1.0, 0.0), {});
    EXPECT_EQ(nothing.status, VertexBound::Status::infeasible);
    EXPECT_EQ(nothing.bound, infinity);
    EXPECT_GT(program.bound_of(Eigen::Vector2d::Zero(), nothing.multipliers), 0.0);
}

TEST(VertexProgram, ContradictionWithinRoundingProvesNothing) {
    VertexProgram program(Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 1.0));
    program.add_row(Eigen::Vector2d(1.0, 1.0), 1.0);
    program.add_row(Eigen::Vector2d(-1.0, -1.0), -1.0 - 1e-12);
    EXPECT_NE(program.minimize(Eigen::Vector2d(1.0, 0.0), {}).status, VertexBound::Status::infeasible);
}

TEST(VertexProgram, BoundsOfVariablesMayShrink) {
    VertexProgram program(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(4.0, 4.0));
    program.add_row(Eigen::Vector2d(1.0, 1.0), 5.0);
    EXPECT_NEAR(program.minimize(Eigen::Vector2d(-1.0, -2.0), {}).bound, -9.0, 1e-7);
    program.set_bounds(1, 0.0, 3.0);
    EXPECT_NEAR(program.minimize(Eigen::Vector2d(-1.0, -2.0), {}).bound, -8.0, 1e-7);
}

// Tangent planes of a ball, many of them nearly parallel: most rest while steps are taken.
TEST(VertexProgram, RestingRowsAreSatisfiedAtOptimum) {
    std::mt19937 random(7);
    constexpr int variables = 6;
    VertexProgram program(Eigen::VectorXd::Constant(variables, -2.0),
                          Eigen::VectorXd::Constant(variables, 2.0));
    for (int row = 0; row < 1000; ++row) program.add_row(random_vector(random, variables).normalized(), 1.0);
    for (int ask = 0; ask < 60; ++ask) {
        Eigen::VectorXd cost = Eigen::VectorXd::Zero(variables);
        cost.head(3) = random_vector(random, 3);
        const VertexBound found = program.minimize(cost, {});
        ASSERT_EQ(found.status, VertexBound::Status::optimal) << ask;
        EXPECT_LE(found.bound, -cost.norm());
        EXPECT_NEAR(found.bound, cost.dot(found.x), 1e-7);
        for (int row = 0; row < program.rows(); ++row) ASSERT_GE(program.slack(row, found.x), -1e-8) << row;
    }
}

TEST(VertexProgram, RefusesAnInfiniteBound) {
    EXPECT_THROW(VertexProgram(Eigen::Vector2d(0.0, -infinity), Eigen::Vector2d(1.0, 1.0)), ModelError);
}

TEST(SparseRowList, GrowsAndIsThinnedOut) {
    const Eigen::MatrixXd dense{{1.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, {0.0, -3.0, 0.0}, {4.0, 5.0, 6.0}};
    SparseRowList rows;
    for (Eigen::Index i = 0; i < dense.rows(); ++i) rows.add(dense.row(i).transpose());
    const Eigen::Vector3d x(1.0, 10.0, 100.0);
    EXPECT_EQ(rows.times(x), dense * x);
    rows.keep({0, 2, 3});
    ASSERT_EQ(rows.size(), 3);
    EXPECT_EQ(rows.dot(1, x), -30.0);
    rows.add(Eigen::Vector3d(0.0, 7.0, 0.0));
    EXPECT_EQ(rows.times(x), Eigen::Vector4d(201.0, -30.0, 654.0, 70.0));
}

}  // namespace vertex_program_test
}  // namespace camopt

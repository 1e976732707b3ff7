// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/path_reduction.hpp"

#include "solvers/structured/interior_point.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

namespace camopt::structured {
namespace path_reduction_test {

/// From rest to rest over 1 with the least |v|-peak: y_{k+1} = y_k + h v_k (mixed units: row k times 2^(k %
/// 3)), y_0 = 0, y_n = 1 as rows, |v_k| <= V.
struct Travel {
    explicit Travel(int steps, bool limited = false) : knots(steps + 1) {
        const double h = 1.0 / steps;
        std::vector<Eigen::Triplet<double>> entries;
        std::vector<double> lower, upper;
        const auto row = [&](double low, double high) {
            lower.push_back(low);
            upper.push_back(high);
            return static_cast<int>(lower.size()) - 1;
        };
        for (int k = 0; k < steps; ++k) {
            const double unit = 1 << (k % 3);
            const int i = row(0.0, 0.0);
            entries.emplace_back(i, k, -unit);
            entries.emplace_back(i, k + 1, unit);
            entries.emplace_back(i, velocity(k), -unit * h);
        }
        entries.emplace_back(row(0.0, 0.0), 0, 1.0);
        entries.emplace_back(row(1.0, 1.0), steps, 1.0);
        for (int k = 0; k < steps; ++k)
            for (const double sign : {1.0, -1.0}) {
                const int i = row(-infinity, 0.0);
                entries.emplace_back(i, velocity(k), sign);
                entries.emplace_back(i, peak(), -1.0);
            }
        if (limited) entries.emplace_back(row(0.0, 0.25), knots / 2, 1.0);
        const auto rows = static_cast<Eigen::Index>(lower.size());
        model.rows.resize(rows, peak() + 1);
        model.rows.setFromTriplets(entries.begin(), entries.end());
        model.row_lower = Eigen::Map<const Eigen::VectorXd>(lower.data(), rows);
        model.row_upper = Eigen::Map<const Eigen::VectorXd>(upper.data(), rows);
        model.x_lower = Eigen::VectorXd::Constant(peak() + 1, -infinity);
        model.x_upper = Eigen::VectorXd::Constant(peak() + 1, infinity);
        model.cost = std::make_unique<LinearCost>(Eigen::VectorXd::Unit(peak() + 1, peak()));
    }
    [[nodiscard]] int velocity(int k) const { return knots + k; }
    [[nodiscard]] int peak() const { return 2 * knots - 1; }
    int knots;
    ConvexModel model;
};

TEST(PathReduction, UnlimitedDisplacementLeavesOneRow) {
    const Travel travel(20);
    const PathReduction reduction(travel.model, Eigen::VectorXd::Zero(travel.model.variables()));
    EXPECT_EQ(reduction.model().variables(), travel.model.variables() - travel.knots);
    EXPECT_EQ(reduction.model().constraints(), travel.model.constraints() - travel.knots);
}

TEST(PathReduction, RestoredPointsSatisfyJoinedRows) {
    const Travel travel(20);
    const PathReduction reduction(travel.model, Eigen::VectorXd::Zero(travel.model.variables()));
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(reduction.model().variables());
    for (double& entry : x) entry = normal(random);
    // Make the sum hold: all velocities moved by the same amount.
    const ConvexModel& small = reduction.model();
    Eigen::VectorXd along = Eigen::VectorXd::Ones(x.size());
    along[x.size() - 1] = 0.0;
    const Eigen::VectorXd now = small.rows * x, change = small.rows * along;
    for (Eigen::Index i = 0; i < small.constraints(); ++i)
        if (small.is_equality(i)) x += (small.row_lower[i] - now[i]) / change[i] * along;
    const Eigen::VectorXd image = travel.model.rows * reduction.restored(x);
    for (Eigen::Index i = 0; i < travel.model.constraints(); ++i)
        if (travel.model.is_equality(i)) {
            EXPECT_NEAR(image[i], travel.model.row_lower[i], 1e-13) << "row " << i;
        }
    EXPECT_LT((reduction.reduced(reduction.restored(x)) - x).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(PathReduction, OptimumAndMultipliersMatchFullProblem) {
    const Travel travel(20);
    const InteriorPointResult solved =
        interior_point(travel.model, Eigen::VectorXd::Zero(travel.model.variables()), {}, {});
    ASSERT_EQ(solved.stop, Stop::converged);
    EXPECT_NEAR(solved.best.x[travel.peak()], 1.0, 1e-9);
    EXPECT_NEAR(solved.best.x[travel.knots - 1], 1.0, 1e-12);
    Eigen::VectorXd stationary = travel.model.rows.transpose() * solved.best.lambda;
    stationary[travel.peak()] += 1.0;
    EXPECT_LT(stationary.cwiseAbs().maxCoeff(), 1e-9);
}

TEST(PathReduction, ALimitedDisplacementStays) {
    const Travel free(40), limited(40, true);
    const PathReduction of_free(free.model, Eigen::VectorXd::Zero(free.model.variables()));
    const PathReduction of_limited(limited.model, Eigen::VectorXd::Zero(limited.model.variables()));
    EXPECT_EQ(of_limited.model().variables(), of_free.model().variables() + 1);
    const InteriorPointResult solved =
        interior_point(limited.model, Eigen::VectorXd::Zero(limited.model.variables()), {}, {});
    ASSERT_EQ(solved.stop, Stop::converged);
    EXPECT_NEAR(solved.best.x[limited.peak()], 1.5, 1e-9);  // 1/4 in one half, 3/4 in the other
}

TEST(PathReduction, ShortPathsStay) {
    const Travel travel(4);
    const PathReduction reduction(travel.model, Eigen::VectorXd::Zero(travel.model.variables()));
    EXPECT_EQ(&reduction.model(), &travel.model);
}

}  // namespace path_reduction_test
}  // namespace camopt::structured

// SPDX-License-Identifier: MIT
// The iteration of the interior point allocates nothing: however many iterations, as many allocations.
#include "solvers/structured/interior_point.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Eigen and operator new both end here. The sanitizers bring an allocator of their own.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define CAMOPT_COUNTS_ALLOCATIONS 1
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
#else
#define CAMOPT_COUNTS_ALLOCATIONS 0
#endif

namespace camopt::structured {
namespace {

/// From rest to rest over 1 with the least |a|: v_{k+1} = v_k + h (a_k + a_{k+1}) / 2, Σ h v = 1.
ConvexModel least_acceleration(int knots) {
    const double h = 1.0 / (knots - 1);
    const int peak = 2 * knots, variables = 2 * knots + 1;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> lower, upper;
    const auto row = [&](double low, double high) {
        lower.push_back(low);
        upper.push_back(high);
        return static_cast<int>(lower.size()) - 1;
    };
    for (int k = 0; k + 1 < knots; ++k) {
        const int i = row(0.0, 0.0);
        entries.insert(entries.end(), {{i, 2 * k, 1.0}, {i, 2 * k + 1, h / 2}});
        entries.insert(entries.end(), {{i, 2 * k + 2, -1.0}, {i, 2 * k + 3, h / 2}});
    }
    const int travel = row(1.0, 1.0);
    for (int k = 0; k < knots; ++k) {
        entries.emplace_back(travel, 2 * k, h);
        for (const double sign : {1.0, -1.0}) {
            const int i = row(-infinity, 0.0);
            entries.insert(entries.end(), {{i, 2 * k + 1, sign}, {i, peak, -1.0}});
        }
    }
    for (const int end : {0, 2 * knots - 2}) entries.emplace_back(row(0.0, 0.0), end, 1.0);
    ConvexModel model;
    const auto rows = static_cast<Eigen::Index>(lower.size());
    model.rows.resize(rows, variables);
    model.rows.setFromTriplets(entries.begin(), entries.end());
    model.row_lower = Eigen::Map<const Eigen::VectorXd>(lower.data(), rows);
    model.row_upper = Eigen::Map<const Eigen::VectorXd>(upper.data(), rows);
    model.x_lower = Eigen::VectorXd::Constant(variables, -infinity);
    model.x_upper = Eigen::VectorXd::Constant(variables, infinity);
    model.cost = std::make_unique<LinearCost>(Eigen::VectorXd::Unit(variables, peak));
    return model;
}

struct Attempt {
    InteriorPointResult result;
    long allocations = 0;
};

Attempt run(const ConvexModel& model, int iterations) {
    InteriorPointLimits limits;
    limits.max_iterations = iterations;
    const long before = allocations;
    Attempt done{interior_point(model, Eigen::VectorXd::Zero(model.variables()), limits, {}), 0};
    done.allocations = allocations - before;
    return done;
}

TEST(StructuredAllocation, NoneInsideTheIteration) {
    const ConvexModel model = least_acceleration(200);
    const Attempt whole = run(model, 100);
    ASSERT_EQ(whole.result.stop, Stop::converged);
    EXPECT_NEAR(whole.result.best.x[400], 4.0, 1e-3);  // constant acceleration, then deceleration
    ASSERT_GE(whole.result.iterations, 4);
    if (CAMOPT_COUNTS_ALLOCATIONS == 0) GTEST_SKIP() << "allocations cannot be counted in this build";
    const Attempt few = run(model, 2), more = run(model, 4);
    EXPECT_GT(few.allocations, 0);
    EXPECT_EQ(few.result.iterations, 2);
    EXPECT_EQ(more.result.iterations, 4);
    EXPECT_EQ(few.allocations, more.allocations);
}

}  // namespace
}  // namespace camopt::structured

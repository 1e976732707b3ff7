// SPDX-License-Identifier: MIT
// The path that a solve leaves behind, and a neighbouring problem taken up from it.
#include "solvers/solver.hpp"
#include "tests/solvers/structured/structured_problems.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace camopt::testing {
namespace structured_path_test {

constexpr double tolerance = 2e-9;

BackendOptions keeping_path() {
    BackendOptions options;
    options.keep_path = true;
    return options;
}

BackendOptions from(const PathPoint& place) {
    BackendOptions options;
    options.near = place;
    return options;
}

/// The rows of cam_problem(), then those of the velocity in the middle between its samples.
QuadraticData with_rows_between(const CamCase& cam) {
    RowCollector rows;
    for (int i = 0; i < static_cast<int>(cam.steps.size()); ++i)
        for (int k = 0; k < cam.samples; ++k) add_velocity_rows(rows, cam, i, (k + 0.5) / cam.samples);
    QuadraticData data = cam_problem(cam);
    rows.append(data);
    return data;
}

CamCase coarse_cam(int segments) {
    CamCase cam = uniform_cam(segments);
    cam.samples = 2;
    return cam;
}

TEST(PathPoints, FindsLastSufficientlyDistantPoint) {
    EXPECT_EQ(point_before({}, 1e-3), nullptr);
    std::vector<PathPoint> path(3);
    path[0].gap = 1e-1;
    path[1].gap = 1e-3;
    path[2].gap = 1e-6;
    EXPECT_EQ(point_before(path, 1e-4), &path[1]);
    EXPECT_EQ(point_before(path, 1e-3), &path[1]);
    EXPECT_EQ(point_before(path, 1e-9), &path[2]);
    EXPECT_EQ(point_before(path, 10.0), &path[0]) << "the first where none is that far off";
}

TEST(StructuredPath, IsReturnedOnRequest) {
    const QuadraticNlp problem(cam_problem(uniform_cam(10)));
    EXPECT_TRUE(solve(problem).path.empty());
    const BackendResult result = solve(problem, keeping_path());
    ASSERT_GE(result.path.size(), 5u);
    const double optimum = problem.cost(result.x);
    double last_gap = infinity;
    for (const PathPoint& place : result.path) {
        EXPECT_GT(place.mu, 0.0);
        EXPECT_LE(place.gap, 0.5 * last_gap);
        last_gap = place.gap;
        // On the path the cost is above the optimum by the gap; equations may be violated by as much.
        EXPECT_LE(std::abs(problem.cost(place.x) - optimum), 3.0 * place.gap) << "gap " << place.gap;
        ASSERT_EQ(place.row_multipliers.size(), problem.shape().constraints());
    }
}

TEST(StructuredPath, NeighbourNeedsFewerIterations) {
    for (const int segments : {6, 10, 32, 64}) {
        const BackendResult before = solve(QuadraticNlp(cam_problem(coarse_cam(segments))), keeping_path());
        const QuadraticNlp neighbour(with_rows_between(coarse_cam(segments)));
        const BackendResult cold = solve(neighbour);
        const double moved = std::abs(neighbour.cost(cold.x) - neighbour.cost(before.x));
        const PathPoint* place = point_before(before.path, 10.0 * moved);
        ASSERT_NE(place, nullptr);
        const BackendResult warm = solve(neighbour, from(*place));
        expect_optimal(neighbour, warm, tolerance);
        EXPECT_NEAR(neighbour.cost(warm.x), neighbour.cost(cold.x), tolerance) << segments;
        EXPECT_LT(warm.iterations, cold.iterations) << segments;
    }
}

TEST(StructuredPath, UselessWarmStartCostsOnlyIterations) {
    const QuadraticNlp problem(cam_problem(uniform_cam(8)));
    const BackendResult cold = solve(problem, keeping_path());
    const PathPoint good = cold.path[cold.path.size() / 2];
    std::vector<PathPoint> bad(5, good);
    bad[0].x.conservativeResize(3);  // of another problem
    bad[1].mu = 1e30;
    bad[2].row_multipliers.setConstant(-1e6);
    bad[3].x.setConstant(std::numeric_limits<double>::quiet_NaN());
    bad[4].row_multipliers.resize(0);
    for (std::size_t k = 0; k < bad.size(); ++k) {
        SCOPED_TRACE(k);
        const BackendResult result = solve(problem, from(bad[k]));
        expect_optimal(problem, result, tolerance);
        EXPECT_NEAR(problem.cost(result.x), problem.cost(cold.x), tolerance);
    }
    EXPECT_EQ(solve(problem, from(bad[0])).iterations, cold.iterations);
}

TEST(StructuredPath, InfeasibleNeighbourIsProved) {
    CamCase cam = uniform_cam(8);
    const BackendResult before = solve(QuadraticNlp(cam_problem(cam)), keeping_path());
    cam.velocity_cap = 0.9;  // the mean velocity is 1
    const QuadraticNlp neighbour(cam_problem(cam));
    for (const PathPoint& place : before.path) expect_farkas(neighbour, solve(neighbour, from(place)), 1e-7);
}

}  // namespace structured_path_test
}  // namespace camopt::testing

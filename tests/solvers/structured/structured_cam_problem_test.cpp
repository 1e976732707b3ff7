// SPDX-License-Identifier: MIT
// The least-peak motion curve, against the exact optima of independent linear programs.
#include "tests/solvers/structured/structured_problems.hpp"

#include <map>

namespace camopt::testing {
namespace structured_cam_problem_test {

constexpr double tolerance = 2e-9;

/// min ∫ y'''² over the curves of `data` whose cost is at most `limit`.
QuadraticData tie_break(const CamCase& cam, double limit) {
    QuadraticData data = cam_problem(cam);
    const int V = static_cast<int>(data.cost.size()) - 3, A = V + 1, J = V + 2;
    RowCollector row;
    row.add({{V, data.cost[V]}, {A, data.cost[A]}, {J, data.cost[J]}}, -infinity, limit);
    row.append(data);
    data.cost.setZero();
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < static_cast<int>(cam.steps.size()); ++i) {
        const double weight = 1.0 / cam.steps[static_cast<std::size_t>(i)];
        const int a = 3 * i + 2, b = 3 * i + 5;
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
    }
    data.hessian.setFromTriplets(entries.begin(), entries.end());
    return data;
}

TEST(StructuredCam, ReachesTheExactOptima) {
    // Segments whose velocity peak lies on a sample: the sampled problem is the exact one.
    const std::map<int, double> exact = {{4, 1.125961},     {6, 0.992889664},  {8, 0.963991515},
                                         {10, 0.941666978}, {12, 0.940489277}, {16, 0.947449535},
                                         {64, 0.937411870}};
    for (const auto& [segments, objective] : exact) {
        const QuadraticNlp problem(cam_problem(uniform_cam(segments)));
        const BackendResult result = solve(problem);
        expect_optimal(problem, result, tolerance);
        EXPECT_NEAR(problem.cost(result.x), objective, segments == 4 ? 1e-6 : 1.5e-9) << segments;
    }
}

TEST(StructuredCam, ApproachesTheOptimaOfLongCurves) {
    // Sampling relaxes the problem: below the exact optimum by no more than the peaks between samples.
    const std::map<int, std::pair<double, double>> exact = {{32, {0.938020776, 2e-5}},
                                                            {128, {0.9373927539, 1e-6}},
                                                            {256, {0.9372204408, 1e-7}},
                                                            {1024, {0.9371969944, 1e-8}}};
    for (const auto& [segments, expected] : exact) {
        const QuadraticNlp problem(cam_problem(uniform_cam(segments)));
        const BackendResult result = solve(problem);
        expect_optimal(problem, result, tolerance);
        EXPECT_LE(problem.cost(result.x), expected.first + 1e-9) << segments;
        EXPECT_GE(problem.cost(result.x), expected.first - expected.second) << segments;
    }
}

TEST(StructuredCam, PeaksOfTwelveSegments) {
    const QuadraticNlp problem(cam_problem(uniform_cam(12)));
    const BackendResult result = solve(problem);
    const Eigen::VectorXd peaks = result.x.tail(3);
    EXPECT_NEAR(peaks[0], 12.0 / 7.0, 1e-7);
    EXPECT_NEAR(peaks[1], 36.0 / 7.0, 1e-7);
    EXPECT_NEAR(peaks[2], 432.0 / 7.0, 1e-5);
}

TEST(StructuredCam, DenseFormOfTheSameProblem) {
    // The states eliminated: the unknowns are the values of y'' alone, every row dense.
    for (const int n : {8, 12, 24}) {
        const CamCase cam = uniform_cam(n);
        const QuadraticData states = cam_problem(cam);
        const Eigen::MatrixXd rows = states.rows;
        Eigen::MatrixXd expand = Eigen::MatrixXd::Zero(states.cost.size(), n + 1 + 3);
        const double h = 1.0 / n;
        for (int i = 0; i <= n; ++i) {
            expand(3 * i + 2, i) = 1.0;
            if (i == n) break;
            expand.row(3 * i + 4) = expand.row(3 * i + 1) + h / 2 * expand.row(3 * i + 2);
            expand(3 * i + 4, i + 1) += h / 2;
            expand.row(3 * i + 3) =
                expand.row(3 * i) + h * expand.row(3 * i + 1) + h * h / 3 * expand.row(3 * i + 2);
            expand(3 * i + 3, i + 1) += h * h / 6;
        }
        for (int k = 0; k < 3; ++k) expand(states.cost.size() - 3 + k, n + 1 + k) = 1.0;
        Eigen::MatrixXd dense(rows.rows() + 2, expand.cols());
        dense << rows * expand, expand.row(3 * n), expand.row(3 * n + 1);
        QuadraticData data(expand.cols());
        data.rows = dense.sparseView(1.0, 1e-15);
        data.cost = expand.transpose() * states.cost;
        data.lower.resize(dense.rows());
        data.upper.resize(dense.rows());
        data.lower << states.lower, 1.0, 0.0;
        data.upper << states.upper, 1.0, 0.0;
        for (const int j : {0, n}) data.x_lower[j] = data.x_upper[j] = 0.0;
        const QuadraticNlp problem(data), reference(states);
        const BackendResult result = solve(problem);
        expect_optimal(problem, result, tolerance);
        EXPECT_NEAR(problem.cost(result.x), reference.cost(solve(reference).x), 1e-9) << n;
    }
}

TEST(StructuredCam, RedundantContinuityRows) {
    CamCase cam = uniform_cam(12);
    cam.copies = 3;
    const QuadraticNlp problem(cam_problem(cam));
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_NEAR(problem.cost(result.x), 0.940489277, 1.5e-9);
}

TEST(StructuredCam, OneWeightAlone) {
    // Least acceleration: 4, reached by every refinement of two parabolas; least jerk 32; the rest is not
    // unique.
    CamCase cam = uniform_cam(64);
    cam.velocity = cam.jerk = 0.0;
    const QuadraticNlp acceleration(cam_problem(cam));
    const BackendResult least = solve(acceleration);
    expect_optimal(acceleration, least, tolerance);
    EXPECT_GE(least.x[least.x.size() - 2], 4.0);
    EXPECT_LE(least.x[least.x.size() - 2], 4.2);
    cam = uniform_cam(16);
    cam.velocity = cam.acceleration = 0.0;
    const QuadraticNlp jerk(cam_problem(cam));
    const BackendResult smooth = solve(jerk);
    expect_optimal(jerk, smooth, tolerance);
    EXPECT_NEAR(smooth.x[smooth.x.size() - 1], 32.0, 1e-7);
}

TEST(StructuredCam, VeryUnequalSteps) {
    CamCase cam;
    double sum = 0.0;
    for (int i = 0; i < 40; ++i) cam.steps.push_back(std::pow(10.0, 6.0 * i / 39.0));
    for (const double h : cam.steps) sum += h;
    for (double& h : cam.steps) h /= sum;
    const QuadraticNlp problem(cam_problem(cam));
    expect_optimal(problem, solve(problem), tolerance);
    cam = uniform_cam(12);
    cam.steps[3] *= 1e-6;
    cam.steps[8] *= 1e-6;
    for (double& h : cam.steps) h /= (10.0 + 2e-6) / 12.0;
    const QuadraticNlp slivers(cam_problem(cam));
    expect_optimal(slivers, solve(slivers), tolerance);
}

TEST(StructuredCam, TieBreakOnAThinSet) {
    for (const int n : {12, 16, 64}) {
        const CamCase cam = uniform_cam(n);
        const QuadraticNlp first(cam_problem(cam));
        const double least = first.cost(solve(first).x);
        double before = infinity;
        for (const double room : {1e-9, 1e-6, 1e-3}) {
            const QuadraticNlp second(tie_break(cam, least + room));
            const BackendResult result = solve(second);
            ASSERT_EQ(result.termination, Termination::converged)
                << n << " " << room << " " << result.native_status;
            EXPECT_LE(first.cost(result.x), least + room + 1e-9);
            EXPECT_LE(second.cost(result.x), before * (1.0 + 1e-6));
            EXPECT_LE(result.iterations, 100);
            before = second.cost(result.x);
        }
    }
}

}  // namespace structured_cam_problem_test
}  // namespace camopt::testing

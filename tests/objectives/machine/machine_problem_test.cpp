// SPDX-License-Identifier: MIT
// Machines as one problem: clearances between samples, derivatives, and the fill-in of their factor.
#include "objectives/machine/machine_problem.hpp"

#include "objectives/scene_model.hpp"
#include "tests/support/derivative_check.hpp"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {
namespace machine_problem_test {

/// Rise (a spline, or a law), dwell, return, dwell.
Scene stroke(double rise_degrees, const char* law = nullptr, int degree = 5, int segments = 6) {
    Scene scene;
    scene.motion.type = MotionType::program;
    scene.motion.lift = 0.05;
    scene.motion.speed = 10.0;
    const auto segment = [](SegmentKind kind, double degrees, std::optional<double> to, const char* name) {
        return ProgramSegment{kind, degrees * units::degree, name == nullptr ? "" : name, to};
    };
    scene.motion.segments = {
        segment(law == nullptr ? SegmentKind::spline : SegmentKind::law, rise_degrees, 1.0, law),
        segment(SegmentKind::dwell, 40.0, {}, nullptr), segment(SegmentKind::spline, 110.0, 0.0, nullptr),
        segment(SegmentKind::dwell, 210.0 - rise_degrees, {}, nullptr)};
    scene.spline.degree = degree;
    scene.spline.segments = segments;
    scene.objective.acceleration = 1.0;
    return scene;
}

MachineBlock block(const char* name, const Scene& scene, double phase_degrees) {
    return {{name, phase_degrees * units::degree, scene.motion.unit_angle(), scene.motion.lift, 1.0},
            scene_model(scene, DesignKind::coefficients, reference_peaks(scene))};
}

MachineProblem machine(std::vector<Scene> scenes, const std::vector<double>& phases,
                       std::vector<ClearanceRule> clearances) {
    std::vector<MachineBlock> blocks;
    const std::array<const char*, 3> names = {"a", "b", "c"};
    for (std::size_t b = 0; b < scenes.size(); ++b) blocks.push_back(block(names[b], scenes[b], phases[b]));
    return {std::move(blocks), std::move(clearances)};
}

Eigen::VectorXd random_point(const MachineProblem& problem, unsigned seed) {
    std::mt19937 random(seed);
    Eigen::VectorXd x = problem.start();
    for (double& value : x) value += 0.2 * (static_cast<double>(random()) / 4294967295.0 - 0.5);
    return problem.completed(x);
}

/// g_k at one master angle, from the motions.
double clearance_at(const MachineProblem& problem, const ClearanceRule& rule, const Eigen::VectorXd& x,
                    double angle) {
    double sum = -rule.bound;
    for (std::size_t k = 0; k < rule.axes.size(); ++k) {
        const MotionChain motion = problem.axis(rule.axes[k]).motion(problem.axis_x(rule.axes[k], x));
        sum -= rule.factors[k] * problem.displacement(rule.axes[k], motion, angle);
    }
    return sum / rule.scale;
}

TEST(Clearance, MaximumIsExactBetweenSamples) {
    for (const char* const law : {static_cast<const char*>(nullptr), "modified_sine", "cycloidal"}) {
        const std::vector<ClearanceRule> rules = {
            {"pair", {0, 1}, {1.0, -1.0}, -0.02, 0.1},
            ClearanceRule("three", {0, 1, 2}, {1.0, 0.5, -2.0}, 0.0, 0.2).between(5.0, 1.0)};
        const MachineProblem problem =
            machine({stroke(100.0, law), stroke(120.0), stroke(90.0)}, {0.0, 37.0, -301.0}, rules);
        const Eigen::VectorXd x = random_point(problem, 7);
        for (int k = 0; k < 2; ++k) {
            const ClearanceRule& rule = rules[static_cast<std::size_t>(k)];
            const double length = rule.until - rule.from + (rule.until > rule.from ? 0.0 : units::turn);
            double sampled = -infinity;
            constexpr int samples = 3000;
            for (int i = 0; i <= samples; ++i)
                sampled = std::max(sampled, clearance_at(problem, rule, x, rule.from + length * i / samples));
            const Extremum worst = problem.worst_of_clearance(k, x);
            EXPECT_GE(worst.value, sampled - 1e-12);
            EXPECT_LE(worst.value, sampled + 1e-5);
            EXPECT_NEAR(worst.value, clearance_at(problem, rule, x, worst.at), 1e-9);
        }
    }
}

TEST(Clearance, ViolationsLeadToRowsThatHoldThem) {
    const std::vector<ClearanceRule> rules = {{"pair", {0, 1}, {1.0, -1.0}, -0.03, 0.1}};
    MachineProblem problem = machine({stroke(100.0), stroke(120.0)}, {0.0, 37.0}, rules);
    const Eigen::VectorXd x = random_point(problem, 5);
    const std::vector<Violation> found = problem.violations(x, 0.0);
    const auto worst = std::ranges::find_if(found, &Violation::limit);
    ASSERT_NE(worst, found.end());
    EXPECT_NEAR(worst->amount, problem.worst_of_clearance(0, x).value, 1e-12);
    EXPECT_NEAR(worst->amount, problem.worst_of_limits(x), 1e-12);
    const int before = problem.grid().shape().constraints();
    EXPECT_GT(problem.refine(std::vector<Violation>{*worst}), 0);
    Eigen::VectorXd g(problem.grid().shape().constraints());
    problem.grid().constraints(x, g);
    EXPECT_NEAR(g.tail(g.size() - before).maxCoeff(), worst->amount, 1e-9);
    const MachineOrigin place = problem.place(problem.grid().row_origin(before));
    EXPECT_EQ(place.clearance, 0);
    EXPECT_NEAR(place.angle, worst->where.at, 1e-12);
    EXPECT_EQ(problem.refine(std::vector<Violation>{*worst}), 0);
}

TEST(MachineProblem, DerivativesAgreeWithDifferences) {
    const std::vector<ClearanceRule> rules = {
        ClearanceRule("pair", {1, 0}, {1.0, -0.5}, -0.03, 0.1).between(1.0, 4.0)};
    Scene with_mean = stroke(100.0);
    with_mean.objective.rms_jerk = 0.5;
    const MachineProblem problem = machine({with_mean, stroke(130.0)}, {10.0, 200.0}, rules);
    const std::vector<Eigen::VectorXd> points = {random_point(problem, 3)};
    const DerivativeReport report = check_derivatives(problem.grid(), points);
    EXPECT_TRUE(report.passed()) << describe(report.faults.front());
    EXPECT_NEAR(problem.grid().cost(points[0]),
                problem.axis(0).objective(problem.axis_x(0, points[0])) +
                    problem.axis(1).objective(problem.axis_x(1, points[0])),
                1e-12);
}

/// Entries of the factor of JᵀJ + 1, which has the pattern of the interior point's matrix.
double factor_entries(int axes, int segments) {
    std::vector<MachineBlock> blocks;
    std::vector<ClearanceRule> rules;
    const Scene scene = stroke(100.0, nullptr, 3, segments);
    for (int b = 0; b < axes; ++b) {
        blocks.push_back(block("axis", scene, 5.0 * b));
        if (b > 0) rules.push_back({"pair", {b - 1, b}, {1.0, -1.0}, -0.03, 0.1});
    }
    const MachineProblem problem(std::move(blocks), std::move(rules));
    const NlpShape& shape = problem.grid().shape();
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < shape.jacobian.size(); ++k)
        entries.emplace_back(shape.jacobian.rows[static_cast<std::size_t>(k)],
                             shape.jacobian.columns[static_cast<std::size_t>(k)], 1.0);
    Eigen::SparseMatrix<double> jacobian(shape.constraints(), shape.variables()),
        one(shape.variables(), shape.variables());
    jacobian.setFromTriplets(entries.begin(), entries.end());
    one.setIdentity();
    const Eigen::SparseMatrix<double> matrix =
        Eigen::SparseMatrix<double>(jacobian.transpose()) * jacobian + one;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    return static_cast<double>(factor.matrixL().nestedExpression().nonZeros());
}

TEST(MachineProblem, FactorGrowsInProportion) {
    EXPECT_LT(factor_entries(16, 16), 2.6 * factor_entries(8, 16));
    EXPECT_LT(factor_entries(8, 32), 2.6 * factor_entries(8, 16));
}

}  // namespace machine_problem_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Free breakpoints: the form is the spline it says, its derivatives are those of the rows.
#include "core/derivative_check.hpp"
#include "objectives/free_knot_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace camopt {
namespace {

struct Case {
    std::string name;
    MotionType type = MotionType::drd;
    int degree = 3, segments = 5;
    bool symmetric = false, rms = false, via = false, cam = false;
};

Scene scene_of(const Case& source) {
    Scene scene;
    scene.motion.type = source.type;
    scene.motion.symmetric = source.symmetric;
    scene.spline.degree = source.degree;
    scene.spline.segments = source.segments;
    scene.objective.velocity = scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    if (source.rms) scene.objective.rms_acceleration = scene.objective.rms_jerk = 0.3;
    if (source.via) scene.motion.via.push_back({0.45, 0.4, {}, {}});
    if (source.cam) {
        scene.motion.lift = 0.02;
        scene.cam.emplace();
        (*scene.cam)[DimensionIndex::base_radius] = {0.03, 0.06};
        (*scene.cam)[DimensionIndex::roller_radius] = {0.01, 0.01};
        scene.limits.pressure_angle = WrittenLimit{0.5, "limits.pressure_angle_rad", 1.0, "rad"};
    }
    return scene;
}

class FreeKnots : public testing::TestWithParam<Case> {};

std::vector<Eigen::VectorXd> points_near(const Eigen::VectorXd& x) {
    std::mt19937 engine(7);
    std::vector<Eigen::VectorXd> points{x};
    for (int k = 0; k < 3; ++k) {
        points.push_back(x);
        for (double& value : points.back())
            value += 0.1 * (static_cast<double>(engine()) / 4294967295.0 - 0.5);
    }
    return points;
}

TEST_P(FreeKnots, DerivativesAreThoseOfTheRows) {
    const Scene scene = scene_of(GetParam());
    const FreeKnotProblem problem(scene, reference_peaks(scene));
    const DerivativeReport report = check_derivatives(problem.grid(), points_near(problem.start()));
    for (const DerivativeFault& fault : report.faults) ADD_FAILURE() << describe(fault);
    EXPECT_GT(report.entries, 500);
}

TEST_P(FreeKnots, APointOfFixedBreakpointsKeepsRowsAndValue) {
    const Scene scene = scene_of(GetParam());
    const Peaks reference = reference_peaks(scene);
    const FreeKnotProblem problem(scene, reference);
    const CamProblem fixed(scene_model(scene, DesignKind::states, reference));
    const Eigen::VectorXd there = fixed.random_start(3);
    const Eigen::VectorXd x = problem.free_point(fixed, there);
    const NlpShape& shape = problem.grid().shape();
    Eigen::VectorXd rows(shape.constraints());
    problem.grid().constraints(x, rows);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        if (shape.rows[static_cast<std::size_t>(i)].limit) continue;
        EXPECT_GE(rows[i], shape.g_lower[i] - 1e-9) << problem.grid().row_name(static_cast<int>(i));
        EXPECT_LE(rows[i], shape.g_upper[i] + 1e-9) << problem.grid().row_name(static_cast<int>(i));
    }
    EXPECT_NEAR(problem.grid().cost(x), fixed.objective(there), 1e-10);
    const Eigen::VectorXd again = problem.completed(x);
    EXPECT_LT((again - x).lpNorm<Eigen::Infinity>(), 1e-8);
}

TEST_P(FreeKnots, MovedBreakpointsGiveACurveThatStillKeepsTheEnds) {
    const Scene scene = scene_of(GetParam());
    const FreeKnotProblem problem(scene, reference_peaks(scene));
    Eigen::VectorXd x = problem.start();
    // Far out: breakpoints are put in order and kept apart, whatever is asked.
    x.segment(problem.form().breakpoint(1), problem.form().segments() - 1).setConstant(1.7);
    const Eigen::VectorXd moved = problem.completed(x);
    const std::vector<double> points = problem.breakpoints(moved);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(scene.spline.segments) + 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_GT(points[i + 1], points[i]);
    const SplineCurve curve =
        problem.fixed_problem(moved).curve(problem.fixed_point(problem.fixed_problem(moved), moved));
    EXPECT_NEAR(curve.at(curve.end(), Side::left).derivative[0],
                scene.motion.type == MotionType::drd ? 1.0 : 0.0, 1e-8);
    EXPECT_TRUE(std::isfinite(problem.objective(moved)));
}

INSTANTIATE_TEST_SUITE_P(
    All, FreeKnots,
    testing::Values(Case{"cubic"}, Case{.name = "quintic", .degree = 5, .segments = 4},
                    Case{.name = "return", .type = MotionType::rr, .segments = 7},
                    Case{.name = "even", .segments = 6, .symmetric = true},
                    Case{.name = "odd", .segments = 7, .symmetric = true},
                    Case{.name = "quintic_odd", .degree = 5, .segments = 5, .symmetric = true},
                    Case{
                        .name = "symmetric_return", .type = MotionType::rr, .segments = 7, .symmetric = true},
                    Case{.name = "rms", .degree = 5, .segments = 4, .rms = true},
                    Case{.name = "via", .segments = 6, .via = true},
                    Case{.name = "cam", .segments = 5, .cam = true}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace camopt

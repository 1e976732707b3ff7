// SPDX-License-Identifier: MIT
// Free breakpoints: the form is the spline it says, its derivatives are those of the rows.
#include "core/nlp.hpp"
#include "objectives/free_knots/free_knot_problem.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "solvers/exchange/exchange.hpp"
#include "tests/support/derivative_check.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace camopt {
namespace free_knot_test {

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
        scene.cam = disk_spec({});
        scene.cam->set(DimensionIndex::base_radius, {0.03, 0.06});
        scene.cam->set(DimensionIndex::roller_radius, {0.01, 0.01});
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

TEST_P(FreeKnots, FixedBreakpointsKeepRowsAndValue) {
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

/// A row that calls itself linear has the same slopes everywhere; one that does not has others somewhere.
TEST_P(FreeKnots, LinearRowsHaveConstantSlopes) {
    const Scene scene = scene_of(GetParam());
    const FreeKnotProblem problem(scene, reference_peaks(scene));
    const NlpShape& shape = problem.grid().shape();
    const auto slopes = [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd values(shape.jacobian.size());
        problem.grid().jacobian(x, std::span<double>(values.data(), static_cast<std::size_t>(values.size())));
        return values;
    };
    std::vector<double> change(shape.rows.size(), 0.0);
    const std::vector<Eigen::VectorXd> points = points_near(problem.start());
    const Eigen::VectorXd first = slopes(points.front());
    for (const Eigen::VectorXd& point : points) {
        const Eigen::VectorXd moved = (slopes(point) - first).cwiseAbs();
        for (int k = 0; k < shape.jacobian.size(); ++k) {
            double& worst = change[static_cast<std::size_t>(shape.jacobian.rows[k])];
            worst = std::max(worst, moved[k]);
        }
    }
    int linear = 0;
    for (std::size_t i = 0; i < change.size(); ++i) {
        linear += shape.rows[i].linear ? 1 : 0;
        EXPECT_EQ(shape.rows[i].linear, change[i] == 0.0) << problem.grid().row_name(static_cast<int>(i));
    }
    EXPECT_GT(linear, 0);
    EXPECT_LT(linear, static_cast<int>(change.size()));
}

TEST(FreeKnotForm, ExactPointKeepsNeighbouringBreakpoints) {
    Scene scene = scene_of({.name = "via", .segments = 6, .via = true});
    const FreeKnotProblem problem(scene, reference_peaks(scene));
    const FreeKnotForm& form = problem.form();
    // 0.45 lies between the breakpoints 2/6 and 3/6 of the start.
    EXPECT_EQ(form.upper()[form.breakpoint(2)], 0.45);
    EXPECT_EQ(form.lower()[form.breakpoint(3)], 0.45);
    // The others are held only by the least lengths before and behind them.
    const double least = form.least_length(0);
    for (int k = 1; k < 6; ++k) {
        if (k != 3) {
            EXPECT_NEAR(form.lower()[form.breakpoint(k)], k * least, 1e-15) << k;
        }
        if (k != 2) {
            EXPECT_NEAR(form.upper()[form.breakpoint(k)], 1.0 - (6 - k) * least, 1e-15) << k;
        }
    }
    // An exact point nearer to an end than the least lengths say does not loosen them.
    scene.motion.via.front().at = 0.34;
    const FreeKnotProblem other(scene, reference_peaks(scene));
    EXPECT_EQ(other.form().upper()[form.breakpoint(2)], 0.34);
    EXPECT_EQ(other.form().lower()[form.breakpoint(3)], 0.34);
}

TEST(FreeKnotForm, PositionIsMeasuredWithinSegment) {
    const Scene scene = scene_of({.name = "cubic", .segments = 5});
    const FreeKnotProblem problem(scene, reference_peaks(scene));
    const FreeKnotForm& form = problem.form();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(form.size());
    for (int k = 1; k < 5; ++k) x[form.breakpoint(k)] = 0.2 * k + 0.01 * k * k;
    x[form.coefficient(2, 0)] = 0.3;
    x[form.coefficient(2, 1)] = 1.1;
    x[form.coefficient(2, 2)] = -2.0;
    x[form.coefficient(2, 3)] = 5.0;
    const double left = 0.44, right = 0.69;
    const FreePoint moving = form.point(x, {2, true, 0.25});
    EXPECT_NEAR(moving.x, left + 0.25 * (right - left), 1e-15);
    EXPECT_NEAR(moving.tau, 0.25 * (right - left), 1e-15);
    EXPECT_EQ(moving.by_left, -0.25);
    EXPECT_EQ(moving.by_right, 0.25);
    const FreePoint fixed = form.point(x, {2, false, 0.6});
    EXPECT_EQ(fixed.x, 0.6);
    EXPECT_NEAR(fixed.tau, 0.16, 1e-15);
    EXPECT_EQ(fixed.by_left, -1.0);
    EXPECT_EQ(fixed.by_right, 0.0);
    const double t = fixed.tau;
    EXPECT_NEAR(fixed.derivative[0], 0.3 + 1.1 * t - t * t + 5.0 / 6.0 * t * t * t, 1e-15);
    EXPECT_NEAR(fixed.derivative[1], 1.1 - 2.0 * t + 2.5 * t * t, 1e-15);
    EXPECT_NEAR(fixed.derivative[2], -2.0 + 5.0 * t, 1e-15);
    EXPECT_EQ(fixed.derivative[3], 5.0);
}

TEST_P(FreeKnots, MovedBreakpointsSatisfyEndConditions) {
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

}  // namespace free_knot_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"

#include "objectives/scene_model.hpp"
#include "splines/curve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace camopt {
namespace cam_problem_test {

Scene weighted_scene(int degree, int segments) {
    Scene scene;
    scene.spline.degree = degree;
    scene.spline.segments = segments;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    return scene;
}

CamProblem problem_of(const Scene& scene, DesignKind kind = DesignKind::states) {
    return CamProblem(scene_model(scene, kind, reference_peaks(scene)));
}

TEST(CamProblem, CompletedPointsAreContinuouslyFeasible) {
    for (const int degree : {3, 5}) {
        const CamProblem problem = problem_of(weighted_scene(degree, 9));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(0.0, 1.0);
        Eigen::VectorXd x(problem.grid().shape().variables());
        for (double& value : x) value = number(random);
        const Eigen::VectorXd completed = problem.completed(x);
        const NlpShape& shape = problem.grid().shape();
        Eigen::VectorXd g(shape.constraints());
        problem.grid().constraints(completed, g);
        for (int i = 0; i < shape.constraints(); ++i) {
            EXPECT_LE(g[i], shape.g_upper[i] + 1e-11) << problem.grid().row_name(i);
            EXPECT_GE(g[i], shape.g_lower[i] - 1e-11) << problem.grid().row_name(i);
        }
        for (const Violation& violation : problem.violations(completed, 1.0)) {
            EXPECT_LE(violation.amount, 1e-11);
        }
        const Peaks peaks = peaks_of(problem.curve(completed));
        const Peaks reference = reference_peaks(weighted_scene(degree, 9));
        const double objective = 0.4 * peaks.velocity.value / reference.velocity.value +
                                 0.4 * peaks.acceleration.value / reference.acceleration.value +
                                 0.2 * peaks.jerk.value / reference.jerk.value;
        EXPECT_NEAR(problem.objective(x), objective, 1e-12 * objective);
    }
}

TEST(CamProblem, StartsFromLeastJerkEnergy) {
    // Least ∫ y'''² between rests is the 3-4-5 polynomial: 720 exactly. A quintic holds it, a cubic comes
    // close.
    const CamProblem quintic = problem_of(weighted_scene(5, 4));
    EXPECT_NEAR(std::pow(peaks_of(quintic.curve(quintic.start())).rms_jerk, 2), 720.0, 1e-6);
    const CamProblem cubic = problem_of(weighted_scene(3, 48));
    const double energy = std::pow(peaks_of(cubic.curve(cubic.start())).rms_jerk, 2);
    EXPECT_GT(energy, 720.0);
    EXPECT_LT(energy, 722.0);
}

Scene free_program() {
    using namespace testing_support;
    Scene scene = program({law(120, "cycloidal", 0.5), spline(60), law(180, "cycloidal", 0.0)}, 4);
    scene.objective = {};
    scene.objective.jerk = 1.0;
    return scene;
}

/// Limits on acceleration or jerk alone bound a motion with free displacements as well: without a bound on
/// the velocity at its joints nothing that is infeasible could be proved so.
TEST(CamProblem, PeaksBoundTheFreeDisplacementBox) {
    for (const bool jerk : {false, true}) {
        Scene scene = free_program();
        (jerk ? scene.limits.jerk : scene.limits.acceleration) = PeakLimit{20.0, "limits", 20.0, ""};
        const CamProblem problem = problem_of(scene);
        const Box box = problem.box(infinity, 0.0);
        const auto entries = problem.model().design.size();
        EXPECT_TRUE(box.upper.head(entries).allFinite()) << box.upper.transpose();
        EXPECT_TRUE(box.lower.head(entries).allFinite()) << box.lower.transpose();
    }
}

TEST(CamProblem, RefinementKeepsRowsAndAddsBracket) {
    CamProblem problem = problem_of(weighted_scene(5, 6));
    const NlpShape before = problem.grid().shape();
    std::vector<std::string> names;
    for (int i = 0; i < before.constraints(); ++i) names.push_back(problem.grid().row_name(i));
    const Violation violation{0, {0.1, 0.07, Side::right}, 0.1, false};
    EXPECT_EQ(problem.refine(std::vector{violation}), 3);
    EXPECT_EQ(problem.grid().shape().constraints(), before.constraints() + 3);
    for (int i = 0; i < before.constraints(); ++i) EXPECT_EQ(problem.grid().row_name(i), names[i]);
    EXPECT_EQ(problem.refine(std::vector{violation}), 0);  // it is there already
}

/// The row of the first rule at x; -1: there is none.
int row_at(const CamProblem& problem, double x) {
    const auto& samples = problem.samples();
    const int first = problem.grid().shape().constraints() - static_cast<int>(samples.size());
    for (int k = 0; k < static_cast<int>(samples.size()); ++k)
        if (samples[static_cast<std::size_t>(k)].rule == 0 &&
            std::abs(samples[static_cast<std::size_t>(k)].at - x) < 1e-12)
            return first + k;
    return -1;
}

TEST(CamProblem, RowsAppearNearActiveConstraints) {
    // +velocity, ten segments: rows at 0.3, 0.35 and 0.4. The two around the maximum at 0.36 press as 3 to 1.
    CamProblem problem = problem_of(weighted_scene(3, 10));
    const std::vector<Violation> worst{{0, {0.1, 0.36, Side::right}, 0.1, false}};
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(problem.grid().shape().constraints());
    multipliers[row_at(problem, 0.35)] = 0.3;
    multipliers[row_at(problem, 0.4)] = 0.1;
    const int before = problem.grid().shape().constraints();
    const int added = problem.refine_pressed(worst, multipliers);
    EXPECT_EQ(problem.grid().shape().constraints(), before + added);
    const double mean = 0.75 * 0.35 + 0.25 * 0.4, reach = 0.35 * 0.5 * 0.5 * 0.1;
    for (const double x : {mean, mean - reach, mean + reach, 0.36})
        EXPECT_GE(row_at(problem, x), before) << x;

    CamProblem one_sided = problem_of(weighted_scene(3, 10));
    multipliers.setZero();
    multipliers[row_at(one_sided, 0.35)] = 0.3;
    static_cast<void>(one_sided.refine_pressed(worst, multipliers));
    for (const double x : {0.35 - 1e-4, 0.35 + 1e-4, 0.36}) EXPECT_GE(row_at(one_sided, x), before) << x;

    CamProblem idle = problem_of(weighted_scene(3, 10));
    EXPECT_EQ(idle.refine_pressed(worst, Eigen::VectorXd::Zero(before)), 3);  // as refine() does
}

TEST(CamProblem, AppendedRowsEqualFreshGrid) {
    const Scene scene = weighted_scene(5, 6);
    CamProblem grown = problem_of(scene, DesignKind::coefficients);
    EXPECT_GT(grown.refine(std::vector<Violation>{{0, {0.1, 0.07, Side::right}, 0.1, false},
                                                  {3, {0.1, 0.51, Side::right}, 0.1, false}}),
              0);
    const CamProblem made(scene_model(scene, DesignKind::coefficients, reference_peaks(scene)),
                          grown.samples());
    const Nlp &left = grown.grid(), &right = made.grid();
    ASSERT_EQ(left.shape().jacobian.rows, right.shape().jacobian.rows);
    EXPECT_EQ(left.shape().jacobian.columns, right.shape().jacobian.columns);
    EXPECT_EQ(left.shape().g_upper, right.shape().g_upper);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(left.shape().variables(), -1.0, 1.0);
    Eigen::VectorXd of_left(left.shape().constraints()), of_right(of_left.size());
    left.constraints(x, of_left);
    right.constraints(x, of_right);
    EXPECT_EQ(of_left, of_right);
    for (int i = 0; i < left.shape().constraints(); ++i) EXPECT_EQ(left.row_name(i), right.row_name(i));
}

TEST(CamProblem, WorstLimitIsLargestViolation) {
    Scene scene = weighted_scene(3, 12);
    EXPECT_EQ(problem_of(scene).worst_of_limits(problem_of(scene).start()), -1.0);  // it has none
    scene.limits.velocity = PeakLimit{1.6, "limits.velocity", 1.6, ""};
    const CamProblem limited = problem_of(scene);
    const Eigen::VectorXd start = limited.start();
    double worst = -1.0;
    for (const Violation& violation : limited.violations(start, 1.0))
        if (violation.limit) worst = std::max(worst, violation.amount);
    EXPECT_EQ(limited.worst_of_limits(start), worst);
    EXPECT_GT(worst, 0.0);
}

TEST(CamProblem, LimitIsInactiveActiveOrInfeasible) {
    Scene scene = weighted_scene(3, 12);
    const int rows_without = problem_of(scene).grid().shape().constraints();
    scene.limits.velocity = PeakLimit{1.6, "limits.velocity", 1.6, ""};
    const CamProblem limited = problem_of(scene);
    EXPECT_EQ(limited.grid().shape().constraints(), rows_without + 1);
    const Eigen::VectorXd start = limited.start();  // the 3-4-5's neighbour: V near 1.875
    double worst = -1.0;
    for (const Violation& violation : limited.violations(start, 1.0)) {
        if (violation.limit) worst = std::max(worst, violation.amount);
    }
    EXPECT_NEAR(worst, 1.875 / 1.6 - 1.0, 0.02);
}

TEST(CamProblem, BoxContainsPromisedCurves) {
    for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
        for (const int degree : {3, 5}) {
            for (const double only : {0.0, 1.0, 2.0, 3.0}) {  // 0: all weights, else only one of them
                Scene scene = weighted_scene(degree, 8);
                scene.motion.within_lift = false;  // these curves may leave it
                if (only == 1.0) scene.objective.acceleration = scene.objective.jerk = 0.0;
                if (only == 2.0) scene.objective.velocity = scene.objective.jerk = 0.0;
                if (only == 3.0) scene.objective.velocity = scene.objective.acceleration = 0.0;
                const CamProblem problem = problem_of(scene, kind);
                std::mt19937 random(17);
                std::uniform_real_distribution<double> number(-0.05, 0.05);
                const Eigen::VectorXd start = problem.start();
                for (int trial = 0; trial < 20; ++trial) {
                    Eigen::VectorXd x = start;
                    for (double& value : x) value += number(random);
                    x = problem.completed(x);
                    const Box box = problem.box(problem.objective(x), 0.0);
                    for (Eigen::Index j = 0; j < x.size(); ++j) {
                        ASSERT_LE(x[j], box.upper[j] + 1e-9)
                            << name_of(kind) << degree << ' '
                            << problem.grid().variable_name(static_cast<int>(j));
                        ASSERT_GE(x[j], box.lower[j] - 1e-9)
                            << name_of(kind) << degree << ' '
                            << problem.grid().variable_name(static_cast<int>(j));
                        ASSERT_TRUE(std::isfinite(box.upper[j]));
                    }
                }
            }
        }
    }
}

/// The weights of the cost and the end states say how large everything can be: no number in the box is looser
/// than that. x in [0, 1]; peaks in units of their references.
TEST(CamProblem, BoxSizeFollowsWeights) {
    const Scene scene = weighted_scene(3, 8);
    const Peaks reference = reference_peaks(scene);
    const CamProblem problem = problem_of(scene);
    const MotionFamily& family = problem.model().design;
    constexpr double incumbent = 1.25;
    const Box box = problem.box(incumbent, 0.0);
    const std::array<double, 3> units = {reference.velocity.value, reference.acceleration.value,
                                         reference.jerk.value};
    // y'' is linear on a segment of length 1/8: y''' is at most 16 max |y''|, less than the cost allows.
    const std::array<double, 3> peak = {incumbent / 0.4, incumbent / 0.4,
                                        incumbent / 0.4 * units[1] * 16.0 / units[2]};
    for (Eigen::Index p = 0; p < 3; ++p) {
        EXPECT_NEAR(box.upper[family.size() + p], peak[static_cast<std::size_t>(p)], 1e-14);
        EXPECT_EQ(box.lower[family.size() + p], 0.0);
    }
    // States: y, y', y'' at the breakpoints. From rest at both ends, with the peaks above.
    const std::array<double, 3> entry = {1.0, units[0], units[1]};
    for (int j = 0; j < family.size(); ++j) {
        const auto order = static_cast<std::size_t>(family.order(j));
        ASSERT_LT(order, 3U);
        const double most = order == 0 ? 1.0 + 0.5 * peak[0] * units[0] : peak[order - 1] * units[order - 1];
        EXPECT_LE(box.upper[j], most / entry[order] * (1.0 + 1e-12)) << family.name(j);
        EXPECT_EQ(box.lower[j], -box.upper[j]);
    }
    // A cap bounds its peak where it says less than the cost; a relaxation loosens it by its part.
    Scene capped = scene;
    capped.limits.velocity = PeakLimit{2.0, "limits.velocity", 2.0, ""};
    const CamProblem with_cap = problem_of(capped);
    EXPECT_NEAR(with_cap.box(incumbent, 0.0).upper[family.size()], 2.0 / units[0], 1e-14);
    EXPECT_NEAR(with_cap.box(incumbent, 0.25).upper[family.size()], 2.5 / units[0], 1e-14);
    EXPECT_NEAR(with_cap.box(0.4, 0.0).upper[family.size()], 1.0, 1e-14);
}

/// A dwell that nothing fixes lies within what the velocity allows from the known beginning.
TEST(CamProblem, FreeJointBoxIsItsReach) {
    Scene scene = weighted_scene(3, 6);
    scene.motion.type = MotionType::program;
    scene.motion.segments = {{SegmentKind::spline, 2.0, "", {}},
                             {SegmentKind::dwell, 1.0, "", {}},
                             {SegmentKind::spline, 2.0, "", 1.0},
                             {SegmentKind::dwell, 2.0 * std::numbers::pi - 5.0, "", {}}};
    scene.motion.closed = false;
    const CamProblem problem = problem_of(scene);
    const MotionFamily& family = problem.model().design;
    ASSERT_LT(family.first_joint_entry(), family.size());
    constexpr double incumbent = 3.0;
    const Box box = problem.box(incumbent, 0.0);
    double largest = 0.0;  // |dy/dx| over the normalised |y'|, of the stretches
    for (const StretchScale& scale : problem.model().stretch_scales)
        largest = std::max(largest, scale.displacement / scale.angle);
    const double velocity = incumbent / 0.4 * reference_peaks(scene).velocity.value * largest;
    for (int j = family.first_joint_entry(); j < family.size(); ++j) {
        ASSERT_EQ(family.order(j), 0) << family.name(j);
        EXPECT_NEAR(box.upper[j] / (velocity * (family.end() - family.begin())), 1.0, 1e-12);
    }
}

TEST(CurveBounds, MarkovAndIntegrationBoundRandomPolynomials) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (const int degree : {3, 5}) {
        const SplineSpace space(degree, 2, {0.0, 0.2, 0.7, 1.0});
        for (int trial = 0; trial < 50; ++trial) {
            Eigen::VectorXd c(space.dimension());
            for (double& value : c) value = number(random);
            c[0] = c[1] = c[2] = 0.0;
            const SplineCurve curve = SplineCurve::from_coefficients(space, c);
            const Peaks peaks = peaks_of(curve);
            const MotionPoint end = curve.at(1.0, Side::left);
            constexpr double none = std::numeric_limits<double>::infinity();
            KnownBounds known{{none, peaks.velocity.value, none, none}, {none, none, none, none}, {}, {}};
            known.end_state = {end.derivative[0], end.derivative[1], end.derivative[2]};
            const Eigen::MatrixXd bounds = derivative_bounds(space, known);
            for (int k = 0; k <= 300; ++k) {
                const double x = k / 300.0;
                for (int r = 0; r <= degree; ++r) {
                    EXPECT_LE(std::abs(curve.derivative(x, r)),
                              bounds(r, space.segment_of(x)) * (1.0 + 1e-9));
                }
            }
        }
    }
}

// T_d on one segment reaches the bound of each of its derivatives at the segment's end.
TEST(CurveBounds, ChebyshevPolynomialsReachThem) {
    constexpr double none = std::numeric_limits<double>::infinity(), width = 0.4;
    const std::map<int, std::vector<double>> chebyshev = {
        {3, {0, -3, 0, 4}}, {5, {0, 5, 0, -20, 0, 16}}, {7, {0, -7, 0, 56, 0, -112, 0, 64}}};
    for (const auto& [degree, c] : chebyshev) {
        SCOPED_TRACE(degree);
        const SplineSpace space(degree, degree - 1, {0.0, width});
        const Eigen::MatrixXd bounds = derivative_bounds(
            space,
            {{1.0, none, none, none}, {none, none, none, none}, {none, none, none}, {none, none, none}});
        double scale = 1.0;  // d/dx of a polynomial of u = 2 x / width − 1, whose end is u = 1
        for (int r = 0; r <= degree; ++r, scale *= 2.0 / width) {
            double at_end = 0.0;
            for (int k = r; k <= degree; ++k) {
                double factor = c[static_cast<std::size_t>(k)];
                for (int i = 0; i < r; ++i) factor *= k - i;
                at_end += factor;
            }
            EXPECT_NEAR(bounds(r, 0) / (at_end * scale), 1.0, 1e-12) << r;
        }
    }
}

}  // namespace cam_problem_test
}  // namespace camopt

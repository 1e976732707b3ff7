// SPDX-License-Identifier: MIT
#include "objectives/rules/torque_rule.hpp"

#include "core/nlp.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/scene_model.hpp"
#include "tests/objectives/rules/plane_check.hpp"
#include "tests/support/derivative_check.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace torque_rule_test {

Scene torque_scene(MotionType type, int degree) {
    Scene scene;
    scene.motion.type = type;
    scene.spline.degree = degree;
    scene.spline.segments = 8;
    scene.objective.jerk = 0.3;
    scene.objective.torque = 0.7;
    return scene;
}

CamProblem problem_of(const Scene& scene, DesignKind kind) {
    return CamProblem(scene_model(scene, kind, reference_peaks(scene)));
}

TEST(TorqueRule, ValueAndPartialsMatchFormula) {
    const MotionPoint point{0.3, {0.4, 1.5, -3.0, 20.0}};
    const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.8);
    const double step = 1e-5;
    for (const int sign : {1, -1}) {
        const TorqueRule rule(sign, 0, 5.0);
        const RuleValue value = rule.evaluate(point, q);
        EXPECT_NEAR(value.value, sign * 1.5 * -3.0 / 5.0 - 0.8, 1e-15);
        for (int i = 0; i < 5; ++i) {
            const auto moved = [&](double by) {
                MotionPoint at = point;
                Eigen::VectorXd own = q;
                (i < 4 ? at.derivative[i] : own[0]) += by;
                return rule.evaluate(at, own);
            };
            const RuleValue up = moved(step), down = moved(-step);
            EXPECT_NEAR(value.gradient[i], (up.value - down.value) / (2.0 * step), 1e-9) << i;
            for (int j = 0; j < 5; ++j)
                EXPECT_NEAR(value.hessian(i, j), (up.gradient[j] - down.gradient[j]) / (2.0 * step), 1e-9);
        }
        EXPECT_EQ(rule.curvature(0.0, 1.0), Curvature::general);
    }
}

TEST(TorqueRule, GridProblemHasRightDerivatives) {
    for (const DesignKind kind : {DesignKind::coefficients, DesignKind::states}) {
        const CamProblem problem = problem_of(torque_scene(MotionType::drd, 5), kind);
        const Eigen::VectorXd point = problem.random_start(3);
        const DerivativeReport report = check_derivatives(problem.grid(), {&point, 1});
        EXPECT_TRUE(report.passed()) << describe(report.faults.front());
        EXPECT_FALSE(problem.grid().shape().convex);
    }
}

/// The largest |y' y''| of a dense grid, from the curve itself.
double dense_torque(const Motion& motion, double end) {
    double largest = 0.0;
    for (int k = 0; k <= 20000; ++k) {
        const MotionPoint point = motion.at(end * k / 20000);
        largest = std::max(largest, std::abs(point.derivative[1] * point.derivative[2]));
    }
    return largest;
}

TEST(TorqueRule, CompletedPeakMatchesCurve) {
    for (const MotionType type : {MotionType::drd, MotionType::rr}) {
        for (const int degree : {3, 5}) {
            const CamProblem problem = problem_of(torque_scene(type, degree), DesignKind::coefficients);
            const Eigen::VectorXd x = problem.completed(problem.random_start(7));
            const double end = type == MotionType::rr ? 2.0 : 1.0;
            const double reference = problem.model().parameters[1].reference;
            ASSERT_EQ(problem.model().parameters[1].kind, Parameter::Kind::torque);
            EXPECT_NEAR(reference, 5.4578, 5e-5) << "of the modified sine";
            const double dense = dense_torque(problem.curve(x), end);
            EXPECT_GE(x[x.size() - 1] * reference, dense * (1.0 - 1e-12));
            EXPECT_NEAR(x[x.size() - 1] * reference, dense, 1e-6 * dense);
        }
    }
}

// The exact roots of y' y'' on each piece find what a sampled slope would find, and never less.
TEST(TorqueRule, MaximaMatchSampledRule) {
    const CamProblem problem = problem_of(torque_scene(MotionType::drd, 5), DesignKind::coefficients);
    const Eigen::VectorXd x = problem.random_start(11), none = Eigen::VectorXd::Zero(1);
    const MotionChain motion = problem.motion(x);
    for (const int sign : {1, -1}) {
        const TorqueRule rule(sign, 0, 1.0);
        const double exact =
            largest_of(rule_maxima(std::make_shared<TorqueRule>(rule), problem.model().design, motion, none))
                .value;
        EXPECT_NEAR(exact, largest_of(rule_maxima(rule, motion, none)).value, 1e-10 * exact);
    }
}

TEST(TorqueRule, BoxPlanesAreLowerBounds) {
    for (const int sign : {1, -1}) {
        const TorqueRule rule(sign, 0, 5.5);
        const auto place = [](std::mt19937& random) -> Eigen::VectorXd {
            const auto between = [&](double low, double high) {
                return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
            };
            Eigen::VectorXd z(5);
            z << between(0.0, 1.0), between(-2.0, 2.0), between(-6.0, 6.0), between(-60.0, 60.0),
                between(0.1, 2.0);
            return z;
        };
        EXPECT_GE(testing_support::check_planes(rule, place, 7), 1000);
    }
}

TEST(TorqueRule, StaysAwayWithoutAWeight) {
    Scene scene = torque_scene(MotionType::drd, 3);
    scene.objective.torque = 0.0;
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    EXPECT_EQ(model.parameters.size(), 1u);
    for (const PlacedRule& rule : model.rules) EXPECT_TRUE(rule->linear()) << rule->name();
}

TEST(TorqueRule, ProgramIsNormalisedBySegment) {
    Scene scene = torque_scene(MotionType::program, 3);
    scene.motion.closed = false;
    scene.motion.segments = {{SegmentKind::dwell, 1.0, "", {}},
                             {SegmentKind::spline, 2.0, "", 1.0},
                             {SegmentKind::dwell, 1.0, "", {}},
                             {SegmentKind::spline, 0.5, "", 0.25},
                             {SegmentKind::dwell, 1.0, "", {}}};
    const CamProblem problem = problem_of(scene, DesignKind::states);
    const Eigen::VectorXd x = problem.completed(problem.random_start(5));
    const MotionChain motion = problem.motion(x);
    double largest = 0.0;
    for (int s : {1, 3}) {
        const MotionFamily::Stretch& stretch = problem.model().design.stretches()[s];
        const double angle = stretch.end - stretch.begin, size = s == 1 ? 1.0 : 0.75;
        for (int k = 1; k < 20000; ++k) {
            const MotionPoint point = motion.at(stretch.begin + angle * k / 20000);
            const double torque = std::abs(point.derivative[1] * point.derivative[2]);
            largest = std::max(largest, torque * std::pow(angle, 3) / (size * size));
        }
    }
    const Parameter& torque = problem.model().parameters[1];
    EXPECT_NEAR(x[x.size() - 1] * torque.reference, largest, 1e-5 * largest);
}

}  // namespace torque_rule_test
}  // namespace camopt

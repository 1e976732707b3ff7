// SPDX-License-Identifier: MIT
// Terms and limits that a program brings: proved, reported and explained like the built-in ones.
#include "core/errors.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace camopt {
namespace own_rules_test {

using namespace testing_support;

MotionFormula derivative_of_motion(int order, double sign = 1.0) {
    return [order, sign](const MotionPoint& point) {
        FormulaValue found;
        found.value = sign * point.derivative[static_cast<std::size_t>(order)];
        found.gradient[order] = sign;
        return found;
    };
}

MotionFormula squared_derivative(int order) {
    return [order](const MotionPoint& point) {
        const double value = point.derivative[static_cast<std::size_t>(order)];
        FormulaValue found;
        found.value = value * value;
        found.gradient[order] = 2.0 * value;
        found.hessian(order, order) = 2.0;
        return found;
    };
}

Scene without_objective(int segments = 12) {
    Scene scene = paper_objective(MotionType::drd, 3, segments);
    scene.objective.velocity = scene.objective.acceleration = scene.objective.jerk = 0.0;
    return scene;
}

OwnTerm term(const char* name, MotionFormula formula, Curvature shape, double reference = 1.0) {
    return {name, 1.0, reference, std::move(formula), shape, 3};
}

std::string told(const Solution& solution) {
    std::string text = name_of(solution.certificate.reason);
    for (const std::string& note : solution.notes) text += "\n" + note;
    for (const Relaxation& row : solution.relaxation) text += "\n" + row.key;
    return text;
}

TEST(OwnTerm, LinearTermMatchesBuiltIn) {
    Scene built_in = without_objective();
    built_in.objective.velocity = 0.5;
    built_in.objective.acceleration = 0.5;
    Scene own = without_objective();
    own.objective.acceleration = 0.5;
    own.own_terms = {term("speed", derivative_of_motion(1), Curvature::linear, 1.76)};
    own.own_terms.front().weight = 0.5;
    const Solution expected = solve(built_in), found = solve(own);
    ASSERT_EQ(found.certificate.verdict, Verdict::optimal) << found.certificate.reason;
    EXPECT_NEAR(found.certificate.objective, expected.certificate.objective, 1e-7);
    ASSERT_EQ(found.own_terms.size(), 1U);
    EXPECT_EQ(found.own_terms.front().name, "speed");
    EXPECT_NEAR(found.own_terms.front().value, found.peaks.velocity.value, 1e-9);
    EXPECT_NEAR(found.own_terms.front().at, found.peaks.velocity.at, 1e-3);
    EXPECT_FALSE(found.any_curve_limit);
}

TEST(OwnTerm, AConvexOneIsProved) {
    Scene built_in = without_objective();
    built_in.objective.jerk = 1.0;
    Scene own = built_in;  // j + j^2 is least where j is
    own.own_terms = {term("squared_jerk", squared_derivative(3), Curvature::convex, 69.0 * 69.0)};
    const Solution expected = solve(built_in), found = solve(own);
    ASSERT_EQ(found.certificate.verdict, Verdict::optimal) << found.certificate.reason;
    const double least = expected.certificate.objective;
    EXPECT_NEAR(found.certificate.objective, least + least * least, 1e-6);
    EXPECT_LE(*found.certificate.lower_bound, found.certificate.objective + 1e-9);
    EXPECT_GE(*found.certificate.lower_bound, found.certificate.objective - 1e-4);
}

TEST(OwnTerm, SteepTermIsProvedByRefinement) {
    Scene own = without_objective();
    own.own_terms = {term("squared_jerk", squared_derivative(3), Curvature::convex, 69.0 * 69.0)};
    const Solution found = solve(own);
    EXPECT_EQ(found.certificate.verdict, Verdict::optimal) << found.certificate.reason;
    ASSERT_TRUE(found.certificate.proof && found.certificate.gap);
    EXPECT_LE(*found.certificate.gap, 1e-7);
    EXPECT_EQ(recomputed_bound(*found.certificate.proof), *found.certificate.lower_bound);
    Scene built_in = without_objective();
    built_in.objective.jerk = 1.0;
    EXPECT_NEAR(std::sqrt(found.certificate.objective), solve(built_in).certificate.objective, 1e-6);
}

TEST(OwnTerm, GeneralTermIsNeverCalledProved) {
    Scene own = without_objective();
    own.objective.velocity = 0.2;
    own.own_terms = {term(
        "power", motion_formula([](const auto&, const auto& v, const auto& a, const auto&) { return v * a; }),
        Curvature::general, 5.0)};
    const Solution found = solve(own);
    ASSERT_TRUE(found.motion) << found.certificate.reason;
    EXPECT_NE(found.certificate.verdict, Verdict::failed) << told(found);
    double largest = 0.0;
    for (int k = 0; k <= 20000; ++k) {
        const auto at = found.motion->at(k / 20000.0).derivative;
        largest = std::max(largest, at[1] * at[2]);
    }
    EXPECT_NEAR(found.own_terms.front().value, largest, 1e-6 * largest);
    EXPECT_NEAR(found.certificate.objective, 0.2 * found.peaks.velocity.value / 1.76 + largest / 5.0, 1e-6);
}

TEST(OwnTerm, AutomaticPartialsMatchManualOnes) {
    const MotionFormula automatic =
        motion_formula([](const auto& y, const auto& v, const auto& a, const auto& j) {
            return y * y * v + v * a - 0.5 * j * j + 3.0 * y;
        });
    const FormulaValue found = automatic({0.3, {0.2, 1.5, -3.0, 7.0}});
    EXPECT_NEAR(found.value, 0.04 * 1.5 - 4.5 - 24.5 + 0.6, 1e-13);
    const Eigen::Vector4d gradient(2 * 0.2 * 1.5 + 3.0, 0.04 - 3.0, 1.5, -7.0);
    EXPECT_LT((found.gradient - gradient).norm(), 1e-13);
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
    hessian(0, 0) = 3.0;
    hessian(0, 1) = hessian(1, 0) = 0.4;
    hessian(1, 2) = hessian(2, 1) = 1.0;
    hessian(3, 3) = -1.0;
    EXPECT_LT((found.hessian - hessian).norm(), 1e-13);
}

TEST(OwnTerm, CommonScaleChangesNoMotion) {
    Scene scene = paper_objective(MotionType::rr, 5, 10);
    scene.own_terms = {term("squared_acceleration", squared_derivative(2), Curvature::convex, 40.0)};
    const Solution one = solve(scene);
    scene.own_terms.front().weight *= 1e6;
    scene.objective.velocity *= 1e6;
    scene.objective.acceleration *= 1e6;
    scene.objective.jerk *= 1e6;
    const Solution other = solve(scene);
    ASSERT_EQ(one.certificate.verdict, Verdict::optimal);
    ASSERT_EQ(other.certificate.verdict, Verdict::optimal) << other.certificate.reason;
    EXPECT_NEAR(other.certificate.objective / one.certificate.objective, 1e6, 1.0);
    EXPECT_EQ(other.own_terms.front().weight, 1e6);
}

TEST(OwnLimit, MatchesBuiltInLimit) {
    Scene built_in = paper_objective(MotionType::drd, 3, 12);
    built_in.limits.velocity = 1.6;
    Scene own = paper_objective(MotionType::drd, 3, 12);
    own.own_limits = {{"speed", 1.6 * 1.6, squared_derivative(1), Curvature::convex, 1, "1", 0.0}};
    const Solution expected = solve(built_in), found = solve(own);
    ASSERT_EQ(found.certificate.verdict, Verdict::optimal) << found.certificate.reason;
    EXPECT_NEAR(found.certificate.objective, expected.certificate.objective, 1e-7);
    ASSERT_EQ(found.constraints.size(), 1U);
    const ConstraintReport& report = found.constraints.front();
    EXPECT_EQ(report.key, "own.speed");
    EXPECT_NEAR(report.worst, 2.56, 1e-8);
    EXPECT_LE(report.worst, 2.56 * (1.0 + 1e-9));
    EXPECT_EQ(report.unit, "1");
    EXPECT_TRUE(report.active);
}

TEST(OwnLimit, InfeasibleLimitIsProvedAndExplained) {
    Scene scene = paper_objective(MotionType::drd, 3, 8);
    scene.own_limits = {{"slow", 0.5, derivative_of_motion(1), Curvature::linear, 1, {}, 0.0}};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible) << solution.certificate.reason;
    ASSERT_FALSE(solution.conflict.empty());
    EXPECT_EQ(solution.conflict.front().key, "own.slow");
    const auto row = std::ranges::find(solution.relaxation, std::string("own.slow"), &Relaxation::key);
    ASSERT_NE(row, solution.relaxation.end()) << told(solution);
    ASSERT_TRUE(row->solved);
    EXPECT_GE(*row->needed, 1.0);
    EXPECT_EQ(row->given, 0.5);
    scene.own_limits.front().limit = *row->solved;
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
    scene.own_limits.front().limit = *row->needed * (1.0 - 1e-4);
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::infeasible);
}

TEST(OwnLimit, ZeroLimitScalesWithSize) {
    // Acceleration above -20 wherever: g = -y'' - 20 <= 0 written with a limit of 0.
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    const MotionFormula formula =
        motion_formula([](const auto&, const auto&, const auto& a, const auto&) { return -1.0 * a - 5.0; });
    scene.own_limits = {{"drop", 0.0, formula, Curvature::linear, 2, {}, 5.0}};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_LE(solution.constraints.front().worst, 5e-8);
    double least = 0.0;
    for (int k = 0; k <= 5000; ++k) least = std::min(least, solution.motion->at(k / 5000.0).derivative[2]);
    EXPECT_GE(least, -5.0 * (1.0 + 1e-8));
}

TEST(OwnRule, AppearsInComparisons) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.own_terms = {term("squared_acceleration", squared_derivative(2), Curvature::convex, 30.0)};
    scene.own_limits = {{"speed", 1.8, derivative_of_motion(1), Curvature::linear, 1, {}, 0.0}};
    const Comparison comparison = compare(scene);
    int seen = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!std::isfinite(row.objective) || !row.misfit.empty()) continue;
        ++seen;
        const double acceleration = row.peaks.acceleration.value;
        const double expected = 0.4 * row.peaks.velocity.value / 1.76 + 0.4 * acceleration / 5.53 +
                                0.2 * row.peaks.jerk.value / 69.0 + acceleration * acceleration / 30.0;
        EXPECT_NEAR(row.objective, expected, 1e-6 * expected) << row.title;
        ASSERT_FALSE(row.limits.empty());
        EXPECT_EQ(row.limits.back().kept, row.peaks.velocity.value <= 1.8 * (1.0 + 1e-8)) << row.title;
    }
    EXPECT_GT(seen, 8);
    EXPECT_EQ(comparison.rows.front().title, "optimum");
}

TEST(OwnRule, HoldsOverWholeProgram) {
    Scene scene = program({spline(120, 1.0), dwell(60), spline(180, 0.0)}, 8);
    scene.spline.degree = 5;
    scene.own_limits = {
        {"fall",
         1.3,
         motion_formula([](const auto&, const auto& v, const auto&, const auto&) { return -1.0 * v; }),
         Curvature::linear,
         1,
         {},
         0.0}};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << told(solution);
    double steepest = 0.0;
    for (int k = 0; k <= 30000; ++k)
        steepest = std::max(steepest, -solution.motion->at(3.0 * k / 30000.0).derivative[1]);
    EXPECT_NEAR(solution.constraints.front().worst, steepest, 1e-6);
    EXPECT_LE(steepest, 1.3 * (1.0 + 1e-8));
}

TEST(OwnRule, IsSatisfiedWhileBreakpointsMove) {
    Scene scene = paper_objective(MotionType::drd, 3, 5);
    scene.spline.free_knots = true;
    Scene built_in = scene;
    built_in.limits.velocity = 1.6;
    scene.own_limits = {{"speed", 1.6, derivative_of_motion(1), Curvature::linear, 1, {}, 0.0}};
    const Solution found = solve(scene), expected = solve(built_in);
    ASSERT_TRUE(found.motion) << told(found);
    EXPECT_LE(found.constraints.front().worst, 1.6 * (1.0 + 1e-8));
    EXPECT_NEAR(found.certificate.objective, expected.certificate.objective, 1e-4);
}

TEST(OwnRule, WrongShapeIsDetected) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    const MotionFormula bent =
        motion_formula([](const auto&, const auto& v, const auto& a, const auto&) { return v * a; });
    for (const Curvature shape : {Curvature::linear, Curvature::convex}) {
        scene.own_terms = {term("power", bent, shape)};
        const std::string words = refusal<ModelError>([&] { (void)solve(scene); });
        EXPECT_NE(words.find("power: declared "), std::string::npos) << words;
        EXPECT_NE(words.find("Hessian"), std::string::npos) << words;
    }
}

TEST(OwnRule, ItsExceptionsPropagate) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.own_limits = {{"broken",
                         1.0,
                         [](const MotionPoint&) -> FormulaValue { throw std::out_of_range("no paper left"); },
                         Curvature::general,
                         2,
                         {},
                         0.0}};
    EXPECT_THROW((void)solve(scene), std::out_of_range);
}

void expect_refused(const Scene& scene, const std::string& words) {
    EXPECT_EQ(refusal([&] { (void)solve(scene); }), words);
}

TEST(OwnRule, FaultsAreReported) {
    const Scene good = paper_objective(MotionType::drd, 3, 12);
    Scene scene = good;
    scene.own_terms = {term("Speed", derivative_of_motion(1), Curvature::linear)};
    expect_refused(scene,
                   "own_terms[0].name: found \"Speed\"; allowed: a name of lower case letters, digits and _");
    scene.own_terms = {term("speed", derivative_of_motion(1), Curvature::linear)};
    scene.own_terms.push_back(scene.own_terms.front());
    expect_refused(scene, "own_terms[1].name: found \"speed\" twice; allowed: each name once");
    scene.own_terms = {term("speed", {}, Curvature::linear)};
    expect_refused(scene, "own_terms[0].formula: found none; allowed: a function");
    scene.own_terms = {term("speed", derivative_of_motion(1), Curvature::linear)};
    scene.own_terms.front().weight = 0.0;
    expect_refused(scene, "own_terms[0].weight: found 0; allowed: a number > 0");
    scene.own_terms.front().weight = 1.0;
    scene.own_terms.front().reference = -1.0;
    expect_refused(scene, "own_terms[0].reference: found -1; allowed: a number > 0");
    scene.own_terms.front().reference = 1.0;
    scene.own_terms.front().highest_order = 4;
    expect_refused(scene, "own_terms[0].highest_order: found 4; allowed: an integer from 0 to 3");
    scene = good;
    scene.own_limits = {{"speed", infinity, derivative_of_motion(1), Curvature::linear, 1, {}, 0.0}};
    expect_refused(scene, "own_limits[0].limit: found inf; allowed: a finite number");
    scene.own_limits.front().limit = 1.0;
    scene.own_limits.front().size = -2.0;
    expect_refused(scene, "own_limits[0].size: found -2; allowed: a number >= 0");
}

}  // namespace own_rules_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Cam Design Handbook, chapter 5, example 4 (scenes/handbook_nine_points.toml): twenty conditions at nine
// angles. With fourteen inner breakpoints one quintic spline keeps them all; with one breakpoint every 5° the
// optimum lies under it.
#include "tests/support/solved_scene.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace camopt {
namespace handbook_test {

using namespace testing_support;

constexpr double degree = std::numbers::pi / 180.0;

struct Condition {
    double angle;  ///< deg
    int order;     ///< of the derivative by the angle in rad
    double value;  ///< mm
};

constexpr std::array<Condition, 20> conditions = {
    {{0, 0, 0},     {0, 1, 0},      {0, 2, 0},       {45, 0, 10.2},  {45, 2, 0},   {90, 0, 20},   {90, 1, 0},
     {90, 2, 0},    {135, 0, 18.1}, {135, 2, -11.7}, {150, 0, 16.1}, {180, 0, 10}, {180, 1, -12}, {180, 2, 0},
     {210, 0, 3.9}, {225, 0, 2},    {225, 2, 12},    {270, 0, 0},    {270, 1, 0},  {270, 2, 0}}};

/// s, s', s'' … in mm and rad.
double delivered(const Motion& motion, double angle, int order) {
    const double x_per_rad = (motion.end() - motion.begin()) / (2.0 * std::numbers::pi);
    const MotionPoint point = motion.at(motion.begin() + x_per_rad * angle * degree, Side::left);
    return 20.0 * point.derivative[static_cast<std::size_t>(order)] * std::pow(x_per_rad, order);
}

double peak(const Motion& motion, int order) {
    double worst = 0.0;
    for (int k = 0; k <= 360'000; ++k)
        worst = std::max(worst, std::abs(delivered(motion, k / 1000.0, order)));
    return worst;
}

/// The breakpoints of an interpolating spline: means of five neighbouring conditions, as parts of the 270°.
std::vector<double> breakpoints_of_interpolation() {
    std::vector<double> breakpoints = {0.0};
    for (std::size_t j = 1; j + 5 < conditions.size(); ++j) {
        double sum = 0.0;
        for (std::size_t k = j; k < j + 5; ++k) sum += conditions[k].angle;
        breakpoints.push_back(sum / 5.0 / 270.0);
    }
    breakpoints.push_back(1.0);
    return breakpoints;
}

void expect_conditions(const Solution& solution) {
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    ASSERT_TRUE(solution.motion);
    for (const Condition& one : conditions)
        EXPECT_NEAR(delivered(*solution.motion, one.angle, one.order), one.value, 1e-7)
            << "derivative " << one.order << " at " << one.angle << " deg";
}

TEST(Handbook, OptimumIsBelowInterpolatingSpline) {
    const std::vector<double> breakpoints = breakpoints_of_interpolation();
    ASSERT_EQ(breakpoints.size(), 16U);
    const TestScene scene = scene_named("handbook_nine_points");
    const Solution through = solve(scene.set("spline.breakpoints", breakpoints));
    expect_conditions(through);
    // As many conditions as coefficients: there is one such spline. Its peaks by SciPy's BSpline and a linear
    // solve.
    EXPECT_NEAR(peak(*through.motion, 1), 27.0371578, 1e-5);
    EXPECT_NEAR(peak(*through.motion, 2), 57.5835535, 1e-5);
    EXPECT_NEAR(peak(*through.motion, 3), 265.326592, 1e-4);
    const Solution best = solve(scene);
    expect_conditions(best);
    EXPECT_LE(best.certificate.gap.value(), 1e-7);
    EXPECT_NEAR(peak(*best.motion, 2), 49.9888, 1e-3);
    EXPECT_NEAR(peak(*best.motion, 3), 197.816, 1e-2);
    EXPECT_LT(best.certificate.objective, 0.81 * through.certificate.objective);
}

}  // namespace handbook_test
}  // namespace camopt

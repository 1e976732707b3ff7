// SPDX-License-Identifier: MIT
// Smoothing splines through rows with and without errors.
#include "splines/fitted_curve.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace fitted_curve_test {

constexpr double turn = 2.0 * std::numbers::pi;

double wave(double x) {
    return std::sin(turn * x) + 0.2 * std::cos(2.0 * turn * x);
}

CurveRows rows_of(int count, bool periodic, const std::function<double(double)>& value) {
    CurveRows rows;
    rows.joints = {0.0, 0.3, 1.0};
    rows.periodic = periodic;
    for (int i = 0; i < count; ++i) {
        rows.x.push_back((i + 0.5) / count);
        rows.y.push_back(value(rows.x.back()));
    }
    return rows;
}

TEST(FittedCurve, FollowsRowsWithoutErrors) {
    for (const bool periodic : {false, true}) {
        const FittedCurve fit = fitted_curve(rows_of(400, periodic, wave));
        EXPECT_LT(fit.noise, 1e-9);
        double largest = 0.0, jerk = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const double x = i / 1000.0;
            const MotionPoint at = fit.curve.at(x);
            largest = std::max(largest, std::abs(at.derivative[0] - wave(x)));
            jerk = std::max(jerk, std::abs(at.derivative[3] + std::pow(turn, 3) * std::cos(turn * x) -
                                           0.2 * std::pow(2.0 * turn, 3) * std::sin(2.0 * turn * x)));
        }
        EXPECT_LT(largest, 1e-9) << periodic;
        EXPECT_LT(jerk, periodic ? 0.02 : 0.6);
        const auto& breakpoints = fit.curve.space().breakpoints();
        EXPECT_EQ(breakpoints[static_cast<std::size_t>(fit.curve.space().breakpoint_at(0.3))], 0.3);
    }
}

TEST(FittedCurve, PeriodicCurveIsSmoothAtEnd) {
    CurveRows rows = rows_of(300, true, [](double x) { return 3.0 * x + wave(x); });
    rows.advance = 3.0;
    const FittedCurve fit = fitted_curve(rows);
    const MotionPoint end = fit.curve.at(1.0, Side::left), begin = fit.curve.at(0.0);
    EXPECT_NEAR(end.derivative[0], begin.derivative[0] + 3.0, 1e-12);
    for (const std::size_t order : {1U, 2U, 3U})
        EXPECT_NEAR(end.derivative[order], begin.derivative[order], 1e-7 * std::pow(2.0 * turn, order));
}

TEST(FittedCurve, NoiseAndItsErrorsAreEstimated) {
    constexpr double noise = 1e-3;
    std::mt19937 random(5);
    std::normal_distribution<double> scatter(0.0, noise);
    std::array<double, 4> squares{}, errors{};
    constexpr int trials = 12, places = 200;
    for (int trial = 0; trial < trials; ++trial) {
        const FittedCurve fit =
            fitted_curve(rows_of(360, true, [&](double x) { return wave(x) + scatter(random); }));
        EXPECT_NEAR(fit.noise, noise, 0.15 * noise);
        for (std::size_t order = 0; order < 4; ++order) errors[order] += fit.error[order] / trials;
        for (int i = 0; i < places; ++i) {
            const double x = (i + 0.5) / places, phase = turn * x;
            const std::array<double, 4> exact = {
                wave(x), turn * (std::cos(phase) - 0.4 * std::sin(2.0 * phase)),
                turn * turn * (-std::sin(phase) - 0.8 * std::cos(2.0 * phase)),
                std::pow(turn, 3) * (-std::cos(phase) + 1.6 * std::sin(2.0 * phase))};
            for (std::size_t order = 0; order < 4; ++order)
                squares[order] +=
                    std::pow(fit.curve.at(x).derivative[order] - exact[order], 2) / places / trials;
        }
    }
    for (std::size_t order = 0; order < 4; ++order) {
        EXPECT_LT(std::sqrt(squares[order]), 2.0 * errors[order]) << order;
        EXPECT_GT(std::sqrt(squares[order]), 0.4 * errors[order]) << order;
    }
    EXPECT_LT(errors[0], 0.5 * noise);
}

TEST(FittedCurve, AccelerationMayJumpAtBreaks) {
    const auto parabola = [](double x) {
        return x < 0.4 ? x * x : 0.16 + 0.8 * (x - 0.4) - 2.0 * std::pow(x - 0.4, 2);
    };
    CurveRows rows = rows_of(500, false, parabola);
    rows.breaks = {0.4};
    rows.x.insert(rows.x.begin() + 200, 0.4);
    rows.y.insert(rows.y.begin() + 200, parabola(0.4));
    const FittedCurve fit = fitted_curve(rows);
    EXPECT_NEAR(fit.curve.at(0.4, Side::left).derivative[2], 2.0, 1e-6);
    EXPECT_NEAR(fit.curve.at(0.4, Side::right).derivative[2], -4.0, 1e-6);
    EXPECT_EQ(fit.curve.continuity(), 0);
    EXPECT_NEAR(fit.curve.at(0.4, Side::left).derivative[1], 0.8, 1e-9);
    EXPECT_NEAR(fit.curve.at(0.4, Side::right).derivative[1], 0.8, 1e-9);
}

TEST(FittedCurve, RefusesStretchesWithoutRows) {
    CurveRows rows = rows_of(30, false, wave);
    rows.x.resize(15);
    rows.y.resize(15);
    EXPECT_TRUE(testing_support::says(testing_support::refusal([&] { (void)fitted_curve(rows); }),
                                      "found no row on 51.7 % of a stretch"));
    rows.x.resize(5);
    rows.y.resize(5);
    EXPECT_TRUE(
        testing_support::says(testing_support::refusal([&] { (void)fitted_curve(rows); }), "found 5 rows"));
}

}  // namespace fitted_curve_test
}  // namespace camopt

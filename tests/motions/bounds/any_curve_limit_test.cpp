// SPDX-License-Identifier: MIT
// The any-curve limit against golden values, integrated double-S curves and the quickest motions of random
// peaks.
#include "motions/bounds/any_curve_limit.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {
namespace any_curve_limit_test {

using testing_support::refusal;

using Caps = std::optional<double>;

AnyCurveLimitInput drd(double v, double a, double j, Caps vc = {}, Caps ac = {}, Caps jc = {}) {
    return {MotionType::drd, 1.0, v, a, j, vc, ac, jc};
}
AnyCurveLimitInput rr(double length, double v, double a, double j) {
    return {MotionType::rr, length, v, a, j, {}, {}, {}};
}

/// Distance of the half (DRD: the whole) with peak velocity v <= V, without cruise, and its time.
struct Travel {
    double time, distance;
};
Travel travel(MotionType type, double v, double acceleration, double jerk) {
    const double a = std::min(acceleration, std::sqrt(v * jerk));
    const double up = v / a + a / jerk;
    if (type == MotionType::drd) return {2.0 * up, v * up};
    const double d = std::min(acceleration, std::sqrt(2.0 * v * jerk));
    const double down = v / d + d / (2.0 * jerk);
    const double lost = v * v / (2.0 * d) + d * d * d / (24.0 * jerk * jerk);
    return {up + down, 0.5 * v * up + v * down - lost};
}

/// Least time of a unit rise under the peaks, by bisection on the velocity really used.
double least_time(MotionType type, double velocity, double acceleration, double jerk) {
    const Travel full = travel(type, velocity, acceleration, jerk);
    if (full.distance <= 1.0) return full.time + (1.0 - full.distance) / velocity;
    double low = 0.0, high = velocity;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (travel(type, middle, acceleration, jerk).distance < 1.0 ? low : high) = middle;
    }
    return travel(type, high, acceleration, jerk).time;
}

void expect_double_s(const AnyCurveLimit& limit) {
    ASSERT_EQ(limit.breakpoints.size(), 8u);
    const double sign[] = {1, 0, -1, 0, -1, 0, 1};
    double y = 0, v = 0, a = 0, v_peak = 0, a_peak = 0;
    for (std::size_t i = 0; i < 7; ++i) {
        const double t = limit.breakpoints[i + 1] - limit.breakpoints[i], j = sign[i] * *limit.jerk;
        ASSERT_GE(t, 0.0);
        y += t * (v + t * (a / 2 + t * j / 6));
        v += t * (a + t * j / 2);
        a += t * j;
        v_peak = std::max(v_peak, v);
        a_peak = std::max(a_peak, std::abs(a));
    }
    EXPECT_NEAR(y, 1.0, 1e-9);
    EXPECT_NEAR(v, 0.0, 1e-9 * *limit.velocity);
    EXPECT_NEAR(a, 0.0, 1e-9 * *limit.acceleration);
    EXPECT_NEAR(v_peak / *limit.velocity, 1.0, 1e-9);
    EXPECT_NEAR(a_peak / *limit.acceleration, 1.0, 1e-9);
}

/// The jerk of an RR limit, integrated over its breakpoints: from rest over 1 back to rest, within the peaks.
void expect_rise_and_return(const AnyCurveLimit& limit, double length) {
    std::vector<double> sign = {1, 0, -1, 0, -1, 0, 1, 0, 1, 0, -1};
    if (length < 2.0) sign.insert(sign.begin(), 0.0);
    if (length > 2.0) sign.push_back(0.0);
    ASSERT_EQ(limit.breakpoints.size(), sign.size() + 1);
    EXPECT_EQ(limit.breakpoints.front(), 0.0);
    EXPECT_NEAR(limit.breakpoints.back(), length, 1e-12);
    double y = 0, v = 0, a = 0, top = 0, v_peak = 0, a_peak = 0;
    for (std::size_t i = 0; i < sign.size(); ++i) {
        const double t = limit.breakpoints[i + 1] - limit.breakpoints[i], j = sign[i] * *limit.jerk;
        ASSERT_GE(t, 0.0);
        if (const double half = 1.0 - limit.breakpoints[i]; half >= 0.0 && half <= t)
            top = y + half * (v + half * (a / 2 + half * j / 6));
        y += t * (v + t * (a / 2 + t * j / 6));
        v += t * (a + t * j / 2);
        a += t * j;
        v_peak = std::max(v_peak, std::abs(v));
        a_peak = std::max(a_peak, std::abs(a));
    }
    EXPECT_NEAR(top, 1.0, 1e-9);
    EXPECT_NEAR(y, 0.0, 1e-9);
    EXPECT_NEAR(v, 0.0, 1e-9 * *limit.velocity);
    EXPECT_NEAR(a, 0.0, 1e-9 * *limit.acceleration);
    EXPECT_NEAR(v_peak / *limit.velocity, 1.0, 1e-9);
    EXPECT_NEAR(a_peak / *limit.acceleration, 1.0, 1e-9);
}

void expect_peaks(const AnyCurveLimit& limit, double objective, double v, double a, double j,
                  double tolerance) {
    ASSERT_EQ(limit.status, AnyCurveStatus::reached);
    EXPECT_NEAR(limit.objective, objective, tolerance * objective);
    EXPECT_NEAR(*limit.velocity, v, tolerance * v);
    EXPECT_NEAR(*limit.acceleration, a, tolerance * a);
    EXPECT_NEAR(*limit.jerk, j, tolerance * j);
}

TEST(AnyCurveLimit, GoldenValues) {
    const AnyCurveLimit paper = any_curve_limit(drd(.4 / 1.76, .4 / 5.53, .2 / 69));
    EXPECT_NEAR(paper.objective, 0.9371963699, 5.1e-11);
    expect_peaks(paper, 0.9371963699, 1.7455851, 5.2837114, 54.609086, 3e-8);
    expect_double_s(paper);
    const double w = 2.0 * std::acos(-1.0);
    expect_peaks(any_curve_limit(drd(0.5, 1 / w, 1 / (w * w))), 2.86624, 1.9781, 5.9745, 36.569, 2e-5);
    expect_peaks(any_curve_limit(rr(2, .4 / 1.76, .4 / 5.53, .2 / 69)), 0.8521595, 1.676881, 5.050131,
                 36.48734, 2e-7);
    EXPECT_NEAR(any_curve_limit(rr(2, 0, 0, 1)).objective, 12 + 6 * std::sqrt(2.0), 1e-10);
}

TEST(AnyCurveLimit, ZeroWeightsAreExact) {
    expect_peaks(any_curve_limit(drd(0, 0, 1)), 32, 2, 8, 32, 1e-12);
    const AnyCurveLimit a = any_curve_limit(drd(0, 1, 0));
    EXPECT_EQ(a.status, AnyCurveStatus::approached);
    EXPECT_NEAR(*a.acceleration, 4, 1e-11);
    EXPECT_FALSE(a.jerk);
    EXPECT_TRUE(a.breakpoints.empty());
    const AnyCurveLimit v = any_curve_limit(rr(1.5, 1, 0, 0));
    EXPECT_EQ(*v.velocity, 2.0);
    EXPECT_FALSE(v.acceleration);
    EXPECT_NEAR(any_curve_limit(drd(1, 1, 0)).objective, 3 + 2 * std::sqrt(2.0), 1e-11);
}

TEST(AnyCurveLimit, Caps) {
    const AnyCurveLimit jerk = any_curve_limit(drd(0, 1, 0, {}, {}, 50.0));
    EXPECT_EQ(jerk.status, AnyCurveStatus::reached);
    EXPECT_EQ(*jerk.jerk, 50.0);
    expect_double_s(jerk);
    const AnyCurveLimit both = any_curve_limit(drd(1, 0, 0, {}, 6.0, 50.0));
    EXPECT_EQ(*both.acceleration, 6.0);
    expect_double_s(both);
    EXPECT_FALSE(any_curve_limit(drd(1, 1, 1, 1.0)).feasible());
    EXPECT_FALSE(any_curve_limit(drd(1, 1, 1, {}, 4.0)).feasible());
    EXPECT_FALSE(any_curve_limit(drd(1, 1, 1, {}, {}, 31.999)).feasible());
    EXPECT_TRUE(any_curve_limit(drd(1, 1, 1, {}, {}, 32.0)).feasible());
    EXPECT_TRUE(std::isinf(any_curve_limit(drd(1, 1, 1, 1.5, 5.0, 40.0)).objective));
}

TEST(AnyCurveLimit, IsBelowQuickestRandomMotions) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto power = [&](double decades) { return std::pow(10.0, decades * (2.0 * unit(random) - 1.0)); };
    for (int k = 0; k < 500; ++k) {
        const bool half = k % 2 == 1;
        const double v = power(2), a = power(2), j = power(2);
        const MotionType type = half ? MotionType::rr : MotionType::drd;
        const AnyCurveLimit limit = any_curve_limit(half ? rr(2, v, a, j) : drd(v, a, j));
        ASSERT_EQ(limit.status, AnyCurveStatus::reached);
        EXPECT_NEAR(least_time(type, *limit.velocity, *limit.acceleration, *limit.jerk), 1.0, 1e-9);
        if (!half) expect_double_s(limit);
        for (const double length : {1.6, 2.0, 3.5})
            if (half && k % 10 == 1) expect_rise_and_return(any_curve_limit(rr(length, v, a, j)), length);
        for (int trial = 0; trial < 60; ++trial) {
            const double spread = trial % 2 == 0 ? 0.01 : 0.5;
            const double vt = *limit.velocity * power(spread), at = *limit.acceleration * power(spread),
                         jt = *limit.jerk * power(spread), t = least_time(type, vt, at, jt);
            EXPECT_GE(v * vt * t + a * at * t * t + j * jt * t * t * t, limit.objective * (1.0 - 1e-11));
        }
    }
}

TEST(AnyCurveLimit, ShorterHalfDecides) {
    const AnyCurveLimit equal = any_curve_limit(rr(2, 2 * 1., 4 * 1., 8 * 1.)),
                        half = any_curve_limit(rr(1.5, 1, 1, 1));
    EXPECT_NEAR(half.objective, equal.objective, 1e-10 * equal.objective);
    EXPECT_NEAR(any_curve_limit(rr(3, 1, 1, 1)).objective, any_curve_limit(rr(2, 1, 1, 1)).objective, 1e-12);
}

TEST(AnyCurveLimit, Refusals) {
    EXPECT_EQ(refusal([&] { (void)any_curve_limit(drd(0, 0, 0)); }),
              "any-curve limit: all weights are 0, at least one must be > 0");
    EXPECT_EQ(refusal([&] { (void)any_curve_limit(drd(-1, 0, 1)); }),
              "any-curve limit: velocity_weight = -1 found, allowed >= 0 and finite");
    EXPECT_EQ(refusal([&] { (void)any_curve_limit(drd(1, 0, 1, 0.0)); }),
              "any-curve limit: velocity_cap = 0 found, allowed > 0 and finite");
    EXPECT_EQ(refusal([&] { (void)any_curve_limit(rr(1, 1, 1, 1)); }),
              "any-curve limit: length = 1 found, allowed > 1 for RR");
}

}  // namespace any_curve_limit_test
}  // namespace camopt

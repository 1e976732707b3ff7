// SPDX-License-Identifier: MIT
// The one-dwell laws against closed forms of their peaks, their conditions at the top, and their limits.
#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace one_dwell_laws_test {

using testing_support::refusal;

using std::numbers::pi;
using std::numbers::sqrt2;

struct ClosedForm {
    double velocity, velocity_at, acceleration, deceleration, jerk_up, jerk_down;
};

void expect_peaks(const Law& law, const ClosedForm& expected) {
    const Peaks peaks = law.peaks();
    const double jerk = std::max(expected.jerk_up, -expected.jerk_down);
    const double larger = std::max(expected.acceleration, expected.deceleration);
    EXPECT_NEAR(peaks.velocity.value, expected.velocity, 1e-12 * expected.velocity);
    EXPECT_NEAR(law.at(expected.velocity_at).derivative[1], expected.velocity, 1e-12 * expected.velocity);
    EXPECT_NEAR(peaks.acceleration.value, larger, 1e-12 * larger);
    EXPECT_NEAR(law.derivatives(1.0)[2], -expected.deceleration, 1e-12 * larger);
    EXPECT_NEAR(peaks.jerk.value, jerk, 1e-11 * jerk);
}

/// Quarter waves of width a, b - a, 1 - b: areas 2/π of height times width, lifts of the parts added up by
/// hand.
TEST(OneDwellLaws, ModifiedSineMatchesClosedPeaks) {
    for (const double a : {0.01, 0.125, 0.25}) {
        const double b = 1.0 / (2.0 - a), p = b - a, q = 1.0 - b;
        const double lift =
            2 * a * a / pi * (1 - 2 / pi) + 2 * a * p / pi + 4 * p * p / (pi * pi) + 4 * b * q / (pi * pi);
        expect_peaks(
            *make_law("one_dwell_modified_sine", std::array<double, 1>{a}),
            {2 * b / pi / lift, b, 1 / lift, 1 / (1 - a) / lift, pi / (2 * a) / lift, -pi / (2 * p) / lift});
    }
}

/// Half sine of area 2b/π and mean velocity half of that; quarter sine: velocity a quarter cosine.
TEST(OneDwellLaws, CycloidalHasItsClosedPeaks) {
    const double b = 2.0 - sqrt2, q = 1.0 - b;
    const double top = 2 * b / pi, lift = 0.5 * top * b + 2 * q / pi * top;
    expect_peaks(*make_law("one_dwell_cycloidal"),
                 {top / lift, b, 1 / lift, sqrt2 / lift, pi / b / lift, -pi / b / lift});
}

TEST(OneDwellLaws, ModifiedTrapezoidMatchesClosedPeaks) {
    for (const double a : {0.01, 0.125, 0.25}) {
        const double b = 0.5 + a * (0.5 - 1.0 / pi), flat = b - 2 * a, last = 1 - b - a;
        const double start = 2 * a / pi, top = start + flat + start;
        // Quarter sine, constant, two quarters of the half cosine, constant down to rest.
        const double lift = start * (a - start) + flat * (start + 0.5 * flat) +
                            2 * (a * (start + flat) + start * start) + 0.5 * last * last;
        expect_peaks(*make_law("one_dwell_modified_trapezoid", std::array<double, 1>{a}),
                     {top / lift, b, 1 / lift, 1 / lift, pi / (2 * a) / lift, -pi / (2 * a) / lift});
    }
}

TEST(OneDwellLaws, PolynomialsHaveTheirClosedPeaks) {
    // y'' = 20/3 x (6 - 15 x + 8 x²), zero at x = (15 - √33)/16; y''' = 40 - 200 x + 160 x².
    const double z = (15.0 - std::sqrt(33.0)) / 16.0;
    expect_peaks(*make_law("one_dwell_polynomial_345"),
                 {20.0 / 3.0 * z * z * (1 - z) * (3 - 2 * z), z, 55.0 / 12.0, 20.0 / 3.0, 40.0, -22.5});
    // In s = 1 - x: y' = 6 s (1 - s²)², largest at s = √⅕; y'' = 6 (1 - s²)(5 s² - 1), largest at s = √⅗;
    // y''' = 24 s (5 s² - 3), least at s = √⅕.
    const double s = std::sqrt(0.2);
    expect_peaks(*make_law("one_dwell_polynomial_3456"), {6 * s * 0.64, 1 - s, 4.8, 6.0, 48.0, -48.0 * s});
}

TEST(OneDwellLaws, PolynomialsAreThoseWritten) {
    const auto five = make_law("one_dwell_polynomial_345"), six = make_law("one_dwell_polynomial_3456");
    for (int i = 0; i <= 100; ++i) {
        const double x = i / 100.0, t = 0.5 * x;
        EXPECT_NEAR(five->at(x).derivative[0], (20 * x * x * x - 25 * x * x * x * x + 8 * std::pow(x, 5)) / 3,
                    1e-14);
        EXPECT_NEAR(six->at(x).derivative[0],
                    64 * std::pow(t, 3) - 192 * std::pow(t, 4) + 192 * std::pow(t, 5) - 64 * std::pow(t, 6),
                    1e-14);
    }
}

TEST(OneDwellLaws, EndConditionsHold) {
    int laws = 0;
    for (const LawInfo& info : law_catalogue()) {
        if (info.top != TopEnd::turning_point) continue;
        ++laws;
        const auto law = make_law(info.key);
        const LawDerivatives bottom = law->derivatives(0.0), top = law->derivatives(1.0);
        for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(bottom[r], 0.0, 1e-13) << info.key;
        EXPECT_NEAR(top[0], 1.0, 1e-14) << info.key;
        EXPECT_NEAR(top[1], 0.0, 1e-14) << info.key;
        EXPECT_LT(top[2], -4.0) << info.key;
        EXPECT_NEAR(top[3], 0.0, 1e-13) << info.key;
    }
    EXPECT_EQ(laws, 6);
}

void expect_same(const Law& found, const Law& expected, double tolerance) {
    for (int i = 1; i < 100; ++i) {
        const double x = i / 100.0 + 1e-3;
        for (std::size_t r = 0; r < 4; ++r)
            EXPECT_NEAR(found.at(x).derivative[r], expected.at(x).derivative[r], tolerance) << x;
    }
}

TEST(OneDwellLaws, LimitsAreTheNeighbouringLaws) {
    expect_same(*make_law("one_dwell_modified_sine", std::array<double, 1>{1e-7}),
                *make_law("simple_harmonic"), 1e-5);
    expect_same(*make_law("one_dwell_modified_sine", std::array<double, 1>{1.0 - 0.5 * sqrt2}),
                *make_law("one_dwell_cycloidal"), 1e-12);
    expect_same(*make_law("one_dwell_modified_trapezoid", std::array<double, 1>{1e-7}),
                *make_law("parabolic"), 1e-5);
    const auto widest = make_law("one_dwell_modified_trapezoid", std::array<double, 1>{pi / (3 * pi + 2)});
    EXPECT_EQ(widest->breakpoints().size(), 4u);
    EXPECT_NEAR(widest->derivatives(1.0)[0], 1.0, 1e-14);
    for (const double below : {1e-3, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-15})
        expect_same(
            *make_law("one_dwell_modified_trapezoid", std::array<double, 1>{pi / (3 * pi + 2) - below}),
            *widest, 1e3 * below + 1e-6);
    EXPECT_TRUE(std::isfinite(
        make_law("one_dwell_modified_sine", std::array<double, 1>{kNarrowestPiece})->peaks().jerk.value));
    EXPECT_TRUE(std::isfinite(make_law("one_dwell_modified_trapezoid", std::array<double, 1>{kNarrowestPiece})
                                  ->peaks()
                                  .jerk.value));
}

TEST(OneDwellLaws, RefusalsNameFoundAndAllowed) {
    EXPECT_TRUE(refusal([] {
                    (void)make_law("one_dwell_modified_sine", std::array<double, 1>{0.3});
                }).starts_with("one_dwell_modified_sine: Ta = 0.3 found, allowed 1e-09 <= Ta <= 0.2928"));
    EXPECT_TRUE(
        refusal([] {
            (void)make_law("one_dwell_modified_trapezoid", std::array<double, 1>{0.28});
        }).starts_with("one_dwell_modified_trapezoid: Ta = 0.28 found, allowed 1e-09 <= Ta <= 0.2749"));
    EXPECT_NE(refusal([] { (void)make_law("one_dwell_modified_sine", std::array<double, 1>{0.0}); }),
              "no refusal");
    EXPECT_NE(
        refusal([] { (void)make_law("one_dwell_modified_trapezoid", std::array<double, 1>{std::nan("")}); }),
        "no refusal");
}

}  // namespace one_dwell_laws_test
}  // namespace camopt

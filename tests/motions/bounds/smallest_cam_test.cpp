// SPDX-License-Identifier: MIT
// The smallest cam against the printed figure, its inverses, a numerical integration and real motions.
#include "motions/bounds/smallest_cam.hpp"

#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace camopt {
namespace smallest_cam_test {

using testing_support::refusal;

using std::numbers::pi;
constexpr double degree = pi / 180.0;

TEST(SmallestCam, HasThePrintedFigure) {
    const SmallestCam cam = smallest_cam({20.0}, 60 * degree, 30 * degree);
    EXPECT_NEAR(cam.prime_coordinate, 24.0813, 5e-5);
    EXPECT_NEAR(cam.prime_coordinate, 20.0 / (std::exp(pi / 3.0 / std::sqrt(3.0)) - 1.0), 1e-12);
    EXPECT_EQ(cam.prime_radius, cam.prime_coordinate);
    EXPECT_EQ(cam.limit, SmallestCamLimit::stroke);
    // A logarithmic spiral: r = s0 exp(θ tan φ).
    EXPECT_NEAR(cam.prime_coordinate + cam.motion.displacement(0.5),
                cam.prime_coordinate * std::exp(0.5 * std::tan(30 * degree)), 1e-12);
    EXPECT_NEAR(smallest_cam({20.0, 0.0, Stroke::return_stroke}, 60 * degree, 30 * degree).prime_coordinate,
                cam.prime_coordinate, 0.0);
}

TEST(SmallestCam, OffsetShiftsBoundUntilRestLimits) {
    const double tangent = std::tan(30 * degree), centred = 24.08131393108153;
    const SmallestCam helped = smallest_cam({20.0, 4.0}, 60 * degree, 30 * degree);
    EXPECT_NEAR(helped.prime_coordinate, centred - 4.0 / tangent, 1e-12);
    EXPECT_NEAR(helped.prime_radius, std::hypot(helped.prime_coordinate, 4.0), 1e-12);
    const SmallestCam hindered = smallest_cam({20.0, 4.0, Stroke::return_stroke}, 60 * degree, 30 * degree);
    EXPECT_NEAR(hindered.prime_coordinate, centred + 4.0 / tangent, 1e-12);
    EXPECT_EQ(smallest_cam({20.0, -4.0}, 60 * degree, 30 * degree).prime_coordinate,
              hindered.prime_coordinate);
    // Half of the centred bound is the most that an offset can take away.
    EXPECT_EQ(helped.limit, SmallestCamLimit::stroke);
    EXPECT_EQ(smallest_cam({20.0, 0.49 * centred * tangent}, 60 * degree, 30 * degree).limit,
              SmallestCamLimit::stroke);
    const SmallestCam rest = smallest_cam({20.0, 0.51 * centred * tangent}, 60 * degree, 30 * degree);
    EXPECT_EQ(rest.limit, SmallestCamLimit::rest);
    EXPECT_NEAR(rest.prime_coordinate, 0.51 * centred, 1e-12);
    EXPECT_LT(rest.motion.angle, 60 * degree);
    EXPECT_NEAR(rest.motion.displacement(rest.motion.angle), 20.0, 1e-12);
}

struct Case {
    CamStroke stroke;
    double angle = 0.0, pressure_angle = 0.0;
};

std::vector<Case> random_cases() {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Case> cases;
    for (int i = 0; i < 300; ++i) {
        Case one;
        one.stroke.lift = 1.0 + 50.0 * unit(random);
        one.stroke.offset = i % 3 == 0 ? 0.0 : 40.0 * (unit(random) - 0.5);
        one.stroke.stroke = i % 2 == 0 ? Stroke::rise : Stroke::return_stroke;
        one.angle = (20.0 + 200.0 * unit(random)) * degree;
        one.pressure_angle = (5.0 + 60.0 * unit(random)) * degree;
        cases.push_back(one);
    }
    return cases;
}

TEST(SmallestCam, StrokeOrRestDecides) {
    int by_stroke = 0, by_rest = 0;
    for (const Case& one : random_cases()) {
        const SmallestCam cam = smallest_cam(one.stroke, one.angle, one.pressure_angle);
        if (cam.limit == SmallestCamLimit::stroke) {
            ++by_stroke;
            EXPECT_NEAR(cam.motion.angle, one.angle, 1e-9 * one.angle);
        } else {
            ++by_rest;
            EXPECT_LE(cam.motion.angle, one.angle);
        }
    }
    EXPECT_GT(by_stroke, 150);
    EXPECT_GT(by_rest, 20);
}

/// s' = t (s0 + s) + σe from the lower end by the classical Runge-Kutta rule: the follower is at the lift
/// when the cam angle is used up, and not yet there on a smaller cam.
double integrated(const Case& one, double prime_coordinate, double angle) {
    const double tangent = std::tan(one.pressure_angle);
    const double helping = one.stroke.stroke == Stroke::rise ? one.stroke.offset : -one.stroke.offset;
    const auto slope = [&](double s) { return tangent * (prime_coordinate + s) + helping; };
    constexpr int kSteps = 4000;
    const double step = angle / kSteps;
    double s = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double first = slope(s), second = slope(s + 0.5 * step * first),
                     third = slope(s + 0.5 * step * second), fourth = slope(s + step * third);
        s += step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
    }
    return s;
}

TEST(SmallestCam, SteepestMotionJustReachesTheLift) {
    for (const Case& one : random_cases()) {
        const SmallestCam cam = smallest_cam(one.stroke, one.angle, one.pressure_angle);
        const double lift = one.stroke.lift;
        EXPECT_NEAR(integrated(one, cam.prime_coordinate, cam.motion.angle), lift, 1e-8 * lift);
        EXPECT_NEAR(cam.motion.displacement(cam.motion.angle), lift, 1e-11 * lift);
        if (cam.limit == SmallestCamLimit::stroke) {
            EXPECT_LT(integrated(one, 0.999 * cam.prime_coordinate, one.angle), lift * (1.0 - 1e-8));
        }
        // Its pressure angle is the limit throughout.
        const double sign = one.stroke.stroke == Stroke::rise ? 1.0 : -1.0;
        for (const double part : {0.0, 0.3, 1.0}) {
            const double theta = part * cam.motion.angle;
            const double tangent = (sign * cam.motion.slope(theta) - one.stroke.offset) /
                                   (cam.prime_coordinate + cam.motion.displacement(theta));
            EXPECT_NEAR(tangent, sign * std::tan(one.pressure_angle), 1e-11);
        }
    }
}

/// Every law needs a larger cam: its largest pressure angle at the bound exceeds the limit.
TEST(SmallestCam, NoLawOfTheCatalogueFits) {
    for (const double offset : {0.0, 3.0, -3.0}) {
        for (const LawInfo& info : law_catalogue()) {
            if (!info.rests) continue;  // no rise by itself
            const auto law = make_law(info.key);
            const double angle = 60 * degree;
            const double bound = smallest_cam({20.0, offset}, angle, 30 * degree).prime_coordinate;
            double steepest = 0.0;
            for (int i = 0; i <= 2000; ++i) {
                const auto y = law->at(i / 2000.0).derivative;
                steepest = std::max(steepest, (20.0 * y[1] / angle - offset) / (bound + 20.0 * y[0]));
            }
            EXPECT_GT(std::atan(steepest), 30.5 * degree) << info.key;
        }
    }
}

TEST(SmallestCam, RefusalsNameFoundAndAllowed) {
    EXPECT_EQ(refusal([] { (void)smallest_cam({0.0}, 1.0, 0.5); }),
              "smallest cam: lift = 0 found, allowed a number above 0");
    EXPECT_EQ(refusal([] { (void)smallest_cam({1.0}, 1.0, 1.6); }),
              "smallest cam: pressure angle = 1.6 found, allowed 0 < pressure angle < π/2");
    EXPECT_NE(refusal([] { (void)smallest_cam({1.0}, -1.0, 0.5); }), "no refusal");
    EXPECT_NE(refusal([] { (void)smallest_cam({1.0, std::nan("")}, 1.0, 0.5); }), "no refusal");
}

}  // namespace smallest_cam_test
}  // namespace camopt

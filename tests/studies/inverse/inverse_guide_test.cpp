// SPDX-License-Identifier: MIT
// Guides made for a wished motion of the feeder: the feeder follows, both strokes are one motion, the figures
// agree with the motion's own peaks.
#include "benchmarks/papers/wished_guide.hpp"
#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/inverse/reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {

namespace inverse_guide_test {

using testing_support::refusal;

using test::inch;

FeederWish reference_wish() {
    FeederWish wish;
    wish.linkage = test::reference_linkage();
    wish.stroke = test::forward_stroke();
    wish.from = 5.25 * inch;
    wish.to = 12.898 * inch;
    wish.lower = feeder_motion(wish.linkage, {0.0, 0.0, 0.0}).feeder.s;
    wish.upper = feeder_motion(wish.linkage, {-9.0 * units::degree, 0.0, 0.0}).feeder.s;
    wish.guide_begin = 1.5 * inch;
    wish.guide_end = 14.0 * inch;
    return wish;
}

TEST(WishedGuide, FeederFollowsToTheSixthOrder) {
    const auto law = make_law("polynomial_4567");
    const FeederWish wish = reference_wish();
    double last = 1.0;
    for (const int nodes : {8, 16, 32}) {
        const double found = feeder_deviation(wished_guide(wish, *law, nodes), wish, *law);
        EXPECT_LT(found, last / 30.0);
        last = found;
    }
    EXPECT_LT(last, 1e-8);
}

TEST(WishedGuide, PeaksAreThoseOfTheMotion) {
    const auto law = make_law("modified_sine");
    const FeederWish wish = reference_wish();
    const Guide guide = wished_guide(wish, *law, 64);
    const GuideFigures figures = guide_figures(guide, wish.linkage, test::reference_roller());
    const double lift = wish.upper - wish.lower, duration = wish.rise_time();
    const Peaks peaks = law->peaks();
    const double velocity = peaks.velocity.value * lift / duration;
    const double acceleration = peaks.acceleration.value * lift / (duration * duration);
    EXPECT_NEAR(figures.forward.velocity, velocity, 1e-5 * velocity);
    EXPECT_NEAR(figures.forward.acceleration, acceleration, 1e-4 * acceleration);
    EXPECT_LT(figures.forward.acceleration_step, 1e-6 * acceleration);
    EXPECT_LT(guide.largest_kink(), 1e-12);
}

TEST(WishedGuide, ReturnIsFasterForwardMotion) {
    const auto law = make_law("cycloidal");
    const FeederWish wish = reference_wish();
    const double ratio = 2496.4 / 1000.0;
    for (const Guide& guide : {wished_guide(wish, *law, 64), make_g1_guide(test::forward_dimensions())}) {
        const GuideFigures figures = guide_figures(guide, wish.linkage, test::reference_roller());
        EXPECT_NEAR(figures.back.velocity / figures.forward.velocity, std::sqrt(ratio), 1e-9);
        EXPECT_NEAR(figures.back.acceleration / figures.forward.acceleration, ratio, 1e-9);
    }
}

TEST(WishedGuide, ArcsStepAndSplinesDoNot) {
    const GuideFigures arcs = guide_figures(make_g1_guide(test::forward_dimensions()),
                                            test::reference_linkage(), test::reference_roller());
    EXPECT_GT(arcs.forward.acceleration_step, 2000.0 * inch);
    EXPECT_NEAR(arcs.least_radius, 9.92 * inch, 1e-12);
    EXPECT_NEAR(arcs.pressure_angle / units::degree, 20.295024957442, 1e-9);
}

TEST(WishedGuide, RefusesUnreachableMotions) {
    const auto law = make_law("cycloidal");
    FeederWish wish = reference_wish();
    EXPECT_EQ(refusal([&] { (void)wished_guide(wish, *law, 1); }),
              "1 nodes of the guide were requested; it needs at least 2");
    wish.upper = 40.0 * inch;
    EXPECT_EQ(refusal([&] { (void)wished_guide(wish, *law, 16); }),
              "the machine cannot produce the required feeder motion at 0.110815 s: rocker_misses_pin");
    wish = reference_wish();
    wish.to = 20.0 * inch;
    EXPECT_EQ(
        refusal([&] { (void)wished_guide(wish, *law, 16); }),
        "the required feeder motion: guide from 0.038099999999999995 to 0.35559999999999997 m, rise from "
        "0.13335 to 0.508 m; must be 0 < begin <= from < to <= end");
}

}  // namespace inverse_guide_test

}  // namespace camopt

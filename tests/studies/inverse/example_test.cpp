// SPDX-License-Identifier: MIT
// The example of docs/papers/000.md: from the weights of a motion to the points of a slot's walls.
#include "benchmarks/papers/guide.hpp"
#include "benchmarks/papers/wished_guide.hpp"
#include "core/units.hpp"
#include "studies/solve/solve.hpp"

#include <gtest/gtest.h>

namespace camopt {

namespace example_test {

TEST(InverseExample, FromWeightsToWalls) {
    constexpr double inch = units::inch;
    // The machine: roller, pin, rocker, feeder.
    const RollerStroke forward{0.0, 0.158, 0.0, 1.5 * inch, 0.0, 1000.0 * inch};
    const RollerStroke back{0.158, 0.258, 0.258, 1.5 * inch, 0.0, 2496.4 * inch};
    const FeederLinkage linkage{
        15.0 * inch, 9.0 * units::degree, {18.3756 * inch, 0.93306 * inch}, 4.0 * inch};

    // The best motion of the feeder: weights of velocity, acceleration and jerk, proved.
    Scene scene;
    scene.spline.segments = 24;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);

    // When it shall happen, and the guide that does it.
    FeederWish wish;
    wish.linkage = linkage;
    wish.stroke = forward;
    wish.from = 3.0 * inch;
    wish.to = 13.9 * inch;
    wish.lower = -0.655 * inch;
    wish.upper = 2.039 * inch;
    wish.guide_begin = 1.5 * inch;
    wish.guide_end = 14.0 * inch;
    const Guide guide = wished_guide(wish, *solution.curve, 64);

    // What it is worth, and the walls of its slot for a roller of 1 in diameter.
    const GuideFigures figures = guide_figures(guide, linkage, RollerLaw({forward, back}));
    ASSERT_EQ(wall_fault(guide, 0.5 * inch), "");
    const GuidePoints left = guide_points(guide, 400, 0.5 * inch),
                      right = guide_points(guide, 400, -0.5 * inch);

    EXPECT_LT(figures.pressure_angle, 11.0 * units::degree);
    EXPECT_LT(figures.forward.acceleration, 1320.0 * inch);
    EXPECT_EQ(left.points.size(), right.points.size());
    EXPECT_LT(feeder_deviation(guide, wish, *solution.curve), 1e-8);
}

}  // namespace example_test

}  // namespace camopt

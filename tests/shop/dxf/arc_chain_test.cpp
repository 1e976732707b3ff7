// SPDX-License-Identifier: MIT
#include "shop/dxf/arc_chain.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace camopt {
namespace arc_chain_test {

using testing_support::refusal;

using Eigen::Vector2d;
using std::numbers::pi;

CurvePoint ellipse(double t) {
    const Vector2d normal = Vector2d(std::cos(t) / 0.08, std::sin(t) / 0.03).normalized();
    return {{0.08 * std::cos(t), 0.03 * std::sin(t)}, normal};
}

/// Center and radius of the arc with this bulge: the formula of the DXF reference, not of arc_chain.cpp.
double distance_to_arc(const Vector2d& point, const Vector2d& from, const Vector2d& to, double bulge) {
    const Vector2d chord = to - from, left(-chord.y(), chord.x());
    if (std::abs(bulge) < 1e-12) return std::abs(left.normalized().dot(point - from));
    const Vector2d center = 0.5 * (from + to) + left * (1.0 - bulge * bulge) / (4.0 * bulge);
    return std::abs((point - center).norm() - (from - center).norm());
}

double least_distance(const ArcChain& chain, const Vector2d& point) {
    double least = 1e9;
    const std::size_t count = chain.vertices.size();
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
        const Vector2d from = chain.vertices[i].position, to = chain.vertices[(i + 1) % count].position;
        const Vector2d chord = to - from;
        const double along = chord.dot(point - from) / chord.squaredNorm();
        if (along > -0.1 && along < 1.1)
            least = std::min(least, distance_to_arc(point, from, to, chain.vertices[i].bulge));
    }
    return least;
}

TEST(Biarc, KeepsPointsAndDirections) {
    const DirectedPoint start{{0.0, 0.0}, Vector2d(2.0, 1.0).normalized()};
    const DirectedPoint end{{3.0, 1.0}, Vector2d(1.0, -1.0).normalized()};
    const auto [first, second] = biarc(start, end);
    EXPECT_EQ(first.end, second.start.position);
    EXPECT_EQ(second.end, end.position);
    // The direction at the end of an arc is that at its start, turned by the arc's angle.
    const auto last_direction = [](const Arc& arc) -> Vector2d {
        return Eigen::Rotation2Dd(4.0 * std::atan(arc.bulge)) * arc.start.direction;
    };
    EXPECT_NEAR((last_direction(first) - second.start.direction).norm(), 0.0, 1e-14);
    EXPECT_NEAR((last_direction(second) - end.direction).norm(), 0.0, 1e-14);
}

TEST(Biarc, AStraightLineHasNoBulge) {
    const Vector2d along = Vector2d(3.0, 4.0).normalized();
    const auto pair = biarc({{1.0, 1.0}, along}, {Vector2d(1.0, 1.0) + 7.0 * along, along});
    EXPECT_NEAR(pair[0].bulge, 0.0, 1e-15);
    EXPECT_NEAR(pair[1].bulge, 0.0, 1e-15);
    EXPECT_NEAR(distance_along_normal(pair, Vector2d(1.0, 1.0) + 2.0 * along + Vector2d(-0.8, 0.6) * 0.25,
                                      Vector2d(-0.8, 0.6)),
                0.25, 1e-14);
}

TEST(ArcChain, ACircleIsExact) {
    const PlaneCurve circle = [](double t) {
        const Vector2d out(std::cos(t), std::sin(t));
        return CurvePoint{0.04 * out, out};
    };
    const ArcChain chain = arc_chain(circle, std::vector<double>{0.0, 2 * pi}, true);
    EXPECT_LT(chain.deviation, 1e-16);
    EXPECT_EQ(chain.arcs, 24);  // pairs of at most 30°
    for (const ArcVertex& vertex : chain.vertices) EXPECT_GT(vertex.bulge, 0.0);
}

TEST(ArcChain, NumberOfArcsIsThirdOrder) {
    int arcs_before = 0;
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        ArcChainOptions options;
        options.tolerance = tolerance;
        const ArcChain chain = arc_chain(ellipse, std::vector<double>{0.0, 2 * pi}, true, options);
        EXPECT_LE(chain.deviation, tolerance);
        EXPECT_GT(chain.deviation, 0.5 * tolerance);
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i)
            worst = std::max(worst, least_distance(chain, ellipse(2 * pi * i / 5000).position));
        EXPECT_LE(worst, tolerance);
        EXPECT_NEAR(worst, chain.deviation, 0.1 * tolerance);
        if (arcs_before > 50) {
            EXPECT_NEAR(chain.arcs / static_cast<double>(arcs_before), std::cbrt(10.0), 0.4);
        }
        arcs_before = chain.arcs;
        std::printf("[ ellipse  ] tolerance %g: %d arcs, deviation %.3g\n", tolerance, chain.arcs,
                    chain.deviation);
    }
}

TEST(ArcChain, GoesThroughACuspBetweenKnots) {
    // A semicubical parabola: its normal is smooth, its direction of travel reverses at t = 0.
    const PlaneCurve curve = [](double t) {
        return CurvePoint{{0.01 * t * t, 0.01 * t * t * t}, Vector2d(-3.0 * t, 2.0).normalized()};
    };
    ArcChainOptions options;
    options.longest_step = 0.3;
    const ArcChain chain = arc_chain(curve, std::vector<double>{-1.0, 0.0, 1.0}, false, options);
    EXPECT_LE(chain.deviation, options.tolerance);
    EXPECT_EQ(static_cast<int>(chain.vertices.size()), chain.arcs + 1);
    EXPECT_EQ(chain.vertices.back().bulge, 0.0);
}

TEST(ArcChain, SkipsStretchesAtRest) {
    const PlaneCurve curve = [](double t) {
        const double turn = t < 1.0 ? t : t < 2.0 ? 1.0 : t - 1.0;
        const Vector2d out(std::cos(turn), std::sin(turn));
        return CurvePoint{0.05 * out, out};
    };
    const ArcChain chain = arc_chain(curve, std::vector<double>{0.0, 1.0, 2.0, 3.0}, false);
    EXPECT_LT(chain.deviation, 1e-15);
    EXPECT_EQ(chain.arcs, 8);
}

TEST(ArcChain, SaysWhatIsWrong) {
    const std::vector<double> knots{0.0, 1.0};
    EXPECT_EQ(refusal([&] { (void)arc_chain(ellipse, knots, true); }),
              "a closed curve ends 0.04460635251153326 m from where it begins");  // not closed
    EXPECT_EQ(refusal([&] { (void)arc_chain(ellipse, std::vector<double>{0.0}, false); }),
              "an arc chain needs at least two knots");
    EXPECT_EQ(refusal([&] {
                  (void)arc_chain(ellipse, std::vector<double>{0.0, 0.0}, false);
              }),
              "the knots of an arc chain ascend, but 0 follows 0");
    EXPECT_EQ(refusal([&] {
                  (void)arc_chain(ellipse, knots, false, {0.0, 1.0});
              }),
              "the tolerance of an arc chain is 0, it must be > 0");
    const PlaneCurve broken = [](double t) { return CurvePoint{{1.0 / t, 0.0}, {0.0, 1.0}}; };
    EXPECT_EQ(refusal([&] { (void)arc_chain(broken, knots, false); }), "the curve is not finite at 0");
}

}  // namespace arc_chain_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Guides: the reference shapes, psi and its derivatives against differences and against the paper's own
// formulas of lines and circles, pieces that do not make a guide.
#include "benchmarks/papers/guide.hpp"

#include "core/errors.hpp"
#include "reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace camopt {

namespace guide_test {

using testing_support::refusal;

using Eigen::Vector2d;
using test::inch;

constexpr double printed_digits = 1e-13;  // relative; the reference has 16 to 17 digits

void expect_digits(double found, double expected) {
    EXPECT_NEAR(found, expected, printed_digits * std::abs(expected));
}

TEST(G1Guide, ReferenceShapes) {
    const auto forward = g1_guide_shape(test::forward_dimensions());
    expect_digits(forward.middle_angle, 0.46096515727136733);
    expect_digits(forward.second_center.x() / inch, 14.408694144459574);
    expect_digits(forward.second_center.y() / inch, -8.5208899342803388);
    const auto back = g1_guide_shape(test::return_dimensions());
    expect_digits(back.middle_angle, 0.44611253503068948);
    expect_digits(back.second_center.x() / inch, 14.428303246648705);
    expect_digits(back.second_center.y() / inch, -9.621371144713768);
    const Guide forward_guide = make_g1_guide(test::forward_dimensions());
    ASSERT_EQ(forward_guide.joints().size(), 5U);
    expect_digits(forward_guide.joints()[2] / inch, 9.7178601331381351);
    expect_digits(forward_guide.joints()[3] / inch, 12.89833835114832);
    const Guide return_guide = make_g1_guide(test::return_dimensions());
    expect_digits(return_guide.joints()[2] / inch, 9.4063115628767626);
    expect_digits(return_guide.joints()[3] / inch, 12.745552843309087);
    EXPECT_LT(forward_guide.largest_kink(), 1e-14);
}

TEST(G1Guide, LargestPressureAngleAtTheInflection) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    const double joint = guide.joints()[2];
    expect_digits(guide.at(joint, Side::left).pressure_angle / units::degree, 20.295024957442);
    double largest = 0.0;
    for (int i = 0; i <= 4000; ++i)
        largest = std::max(largest,
                           guide.at(guide.begin() + (guide.end() - guide.begin()) * i / 4000).pressure_angle);
    EXPECT_LE(largest, guide.at(joint).pressure_angle + 1e-14);
}

/// Angle and derivatives by distance against central differences inside every piece.
void expect_derivatives(const Guide& guide) {
    const double step = 1e-4 * guide.end();
    for (std::size_t piece = 0; piece + 1 < guide.joints().size(); ++piece) {
        const double begin = guide.joints()[piece], length = guide.joints()[piece + 1] - begin;
        for (const double part : {0.1, 0.37, 0.5, 0.83}) {
            const double distance = begin + part * length, h = std::min(step, 0.05 * length);
            const GuidePoint point = guide.at(distance), before = guide.at(distance - h),
                             after = guide.at(distance + h);
            EXPECT_NEAR(point.slope, (after.angle - before.angle) / (2 * h),
                        1e-5 * (1.0 + std::abs(point.slope)));
            EXPECT_NEAR(point.bend, (after.slope - before.slope) / (2 * h),
                        1e-5 * (10.0 + std::abs(point.bend)));
            EXPECT_NEAR(std::tan(point.pressure_angle), distance * point.slope, 1e-13);
            EXPECT_NEAR(point.position.norm(), distance, 1e-14);
            const Vector2d chord = after.position - before.position;
            EXPECT_NEAR(chord.normalized().dot(point.tangent), 1.0, 1e-6);
            const double turn =
                std::atan2(before.tangent.x() * after.tangent.y() - before.tangent.y() * after.tangent.x(),
                           before.tangent.dot(after.tangent));
            EXPECT_NEAR(point.curvature, turn / chord.norm(), 1e-4 * (1.0 + std::abs(point.curvature)));
        }
    }
}

TEST(Guide, DerivativesOfLinesAndArcs) {
    expect_derivatives(make_g1_guide(test::forward_dimensions()));
    expect_derivatives(make_g1_guide(test::return_dimensions()));
    // A chain that is no G1 guide: a line past the pivot, an arc bending right, a line.
    const Vector2d a(0.05, 0.02), b(0.09, 0.03), c(0.15, 0.02), d(0.20, -0.01);
    const Vector2d center(0.10, -0.10);
    const double radius = (b - center).norm();
    const Vector2d c_on = center + radius * (c - center).normalized();
    const Guide chain({GuideLine{a, b}, GuideArc{b, c_on, center}, GuideLine{c_on, d}});
    expect_derivatives(chain);
    EXPECT_GT(chain.largest_kink(), 0.01);
}

TEST(Guide, MatchesPaperForLineAndCircle) {
    // Eqs. 3 to 5 and 9 to 12 as corrected, in their own symbols, at unit roller speed and an acceleration
    // of 7.
    const double L_dot = 1.0, L_acc = 7.0;
    const Guide guide({GuideLine{Vector2d(0.05, 0.02), Vector2d(0.09, 0.05)}});
    const double a = 0.03, b = -0.04, c = -(a * 0.05 + b * 0.02);
    const double distance = 0.08;
    const GuidePoint point = guide.at(distance);
    const double psi = point.angle, sine = std::sin(psi), cosine = std::cos(psi);
    EXPECT_NEAR(a * distance * cosine + b * distance * sine + c, 0.0, 1e-16);
    const double rate = -c * L_dot / (distance * distance * (a * sine - b * cosine));
    const double second =
        (-c * L_acc + c * distance * rate * rate) / (distance * distance * (a * sine - b * cosine)) -
        2.0 * L_dot * rate / distance;
    EXPECT_NEAR(point.slope * L_dot, rate, 1e-12 * std::abs(rate));
    EXPECT_NEAR(point.bend * L_dot * L_dot + point.slope * L_acc, second, 1e-12 * std::abs(second));

    const Guide g1 = make_g1_guide(test::forward_dimensions());
    const auto shape = g1_guide_shape(test::forward_dimensions());
    const double u = shape.second_center.x(), v = shape.second_center.y(), L = 11.0 * inch;
    const GuidePoint arc = g1.at(L);
    const double s = std::sin(arc.angle), k = std::cos(arc.angle), bottom = L * (v * k - u * s);
    const double speed = L_dot * (L - v * s - u * k) / bottom;
    const double acceleration = (L_acc * (L - u * k - v * s) + 2 * L_dot * speed * (u * s - v * k) +
                                 L * speed * speed * (u * k + v * s) + L_dot * L_dot) /
                                bottom;
    EXPECT_NEAR(arc.slope * L_dot, speed, 1e-12 * std::abs(speed));
    EXPECT_NEAR(arc.bend * L_dot * L_dot + arc.slope * L_acc, acceleration, 1e-12 * std::abs(acceleration));
}

TEST(Guide, PolarSplineTakesOverItsNodes) {
    const Guide arcs = make_g1_guide(test::forward_dimensions());
    GuidePolarSpline spline;
    for (int i = 0; i <= 20; ++i) {
        const GuidePoint point = arcs.at((6.0 + 3.0 * i / 20.0) * inch);
        spline.nodes.push_back({point.distance, point.angle, point.slope, point.bend});
    }
    const Guide guide({spline});
    expect_derivatives(guide);
    for (const PolarNode& node : spline.nodes) {
        EXPECT_NEAR(guide.at(node.distance).angle, node.angle, 1e-15);
        EXPECT_NEAR(guide.at(node.distance).bend, node.bend, 1e-10 * std::abs(node.bend));
    }
    const GuidePoint found = guide.at(7.3 * inch), expected = arcs.at(7.3 * inch);
    EXPECT_NEAR(found.angle, expected.angle, 1e-9);
    EXPECT_NEAR(found.curvature, expected.curvature, 1e-4 * expected.curvature);
}

std::string refusal(const std::vector<GuidePiece>& pieces) {
    return refusal([&] { const Guide guide(pieces); });
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(Guide, RefusesWhatIsNoGuide) {
    const Vector2d a(0.1, 0.0), b(0.2, 0.0);
    EXPECT_TRUE(holds(refusal({}), "no piece"));
    EXPECT_TRUE(holds(refusal({GuideLine{a, a}}), "length 0"));
    EXPECT_TRUE(holds(refusal({GuideLine{b, a}}), "L must grow"));
    EXPECT_TRUE(
        holds(refusal({GuideLine{a, b}, GuideLine{Vector2d(0.21, 0.0), Vector2d(0.3, 0.0)}}), "apart"));
    EXPECT_TRUE(holds(refusal({GuideArc{a, Vector2d(0.0, 0.1), Vector2d(0.0, 0.0)}}), "about the pivot"));
    EXPECT_TRUE(holds(refusal({GuideArc{a, b, Vector2d(0.12, 0.0)}}), "radius"));
    // A line whose nearest point to the pivot lies inside: the roller would have two places.
    EXPECT_TRUE(holds(refusal({GuideLine{Vector2d(-0.1, 0.05), Vector2d(0.2, 0.05)}}), "branch"));
    EXPECT_TRUE(holds(refusal({GuidePolarSpline{{{0.1, 0, 0, 0}}}}), "fewer than 2"));
    EXPECT_TRUE(holds(refusal({GuidePolarSpline{{{0.1, 0, 0, 0}, {0.1, 0, 0, 0}}}}), "further"));
    EXPECT_EQ(refusal({GuideLine{a, b}}), "no refusal");
    G1GuideDimensions none = test::forward_dimensions();
    none.line_end = 100.0;
    EXPECT_EQ(refusal([&] { (void)make_g1_guide(none); }),
              "no arcs of radius 0.25196799999999997 and 0.271018 m join the line that ends at 100 m to one "
              "at 0.15707963267948966 rad through the pivot");
}

TEST(Guide, NamesWhatItDoesNotReach) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    EXPECT_EQ(guide.reach(1.0 * inch), Reach::before_guide);
    EXPECT_EQ(guide.reach(2.0 * inch), Reach::within);
    EXPECT_EQ(guide.reach(15.0 * inch), Reach::beyond_guide);
    EXPECT_EQ(
        refusal([&] { (void)guide.at(15.0 * inch); }),
        "the roller at L = 0.381 m is not on the guide, which goes from 0.038099999999999995 to 0.3556 m");
    EXPECT_EQ(
        refusal([&] { (void)guide.at(std::nan("")); }),
        "the roller at L = nan m is not on the guide, which goes from 0.038099999999999995 to 0.3556 m");
}

TEST(GuidePoints, WallsLieARollerAside) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    const double radius = 0.5 * inch;
    const GuidePoints middle = guide_points(guide, 200), wall = guide_points(guide, 200, radius);
    ASSERT_EQ(middle.points.size(), wall.points.size());
    ASSERT_EQ(wall.breaks.size(), 3U);
    for (std::size_t i = 0; i < wall.points.size(); ++i)
        EXPECT_NEAR((wall.points[i] - middle.points[i]).norm(), radius, 1e-15);
    EXPECT_EQ(wall_fault(guide, radius), "");
    EXPECT_TRUE(holds(wall_fault(guide, 10.0 * inch), "less than the roller's"));
}

}  // namespace guide_test

}  // namespace camopt

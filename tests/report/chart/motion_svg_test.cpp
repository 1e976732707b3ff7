// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/chart/svg_canvas.hpp"
#include "report/view/number_text.hpp"
#include "report/view/peak_comparison.hpp"
#include "report/view/view.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace camopt {
namespace motion_svg_test {

using testing_support::refusal;

TEST(ReferenceMotion, ProgramSceneHasNoCurve) {
    const ReferenceMotion reference = reference_motion(test::program_solution().scene);
    EXPECT_EQ(reference.motion, nullptr);
    EXPECT_EQ(reference.title, "modified sine");
    EXPECT_NEAR(reference.peaks.acceleration.value, 5.527957070544091, 1e-12);
}

TEST(ReferenceMotion, FollowsSplineSegmentsOfAProgram) {
    const Solution solution = test::program_solution();
    const View view(solution);
    const auto law = make_law("modified_sine");
    const double up = 2.0 / 3.0;  // where the spline begins; its unit angle is that of x
    const std::vector<double> joints = {up, up + 1.0, 3.5};
    for (std::size_t order = 0; order < view.curves.size(); ++order) {
        const Curve& curve = view.curves[order];
        ASSERT_TRUE(curve.reference.has_value()) << curve.key;
        EXPECT_EQ(curve.reference->title, "modified sine");
        const double per = view.units.motion[order].first.per_normalised;
        int compared = 0;
        for (std::size_t i = 0; i < view.delivered.rows.size(); ++i) {
            const DeliveredRow& row = view.delivered.rows[i];
            const bool inside = row.x > up && row.x < up + 1.0;
            if (std::ranges::any_of(joints, [&](double x) { return std::abs(x - row.x) < 1e-9; })) continue;
            const double law_there =
                inside ? per * law->at(row.x - up, row.side).derivative[order] : curve.values[i];
            EXPECT_NEAR(curve.reference->values[i], law_there, 1e-9 * per) << curve.key << " at " << row.x;
            compared += inside ? 1 : 0;
        }
        EXPECT_GT(compared, 50);
        EXPECT_TRUE(std::isfinite(curve.reference->values.back())) << "up to its end";
    }
    Solution numbers = solution;
    numbers.scene.objective.reference.numeric = true;
    EXPECT_FALSE(View(numbers).curves[1].reference.has_value());
}

TEST(MotionCurves, MarkThePeaksOfBothSigns) {
    for (const Solution& solution : {test::sample_solution(), test::cam_solution()}) {
        const View view(solution);
        for (std::size_t order = 1; order <= 3; ++order) {
            const Curve& curve = view.curves[order];
            const auto [least, largest] = std::ranges::minmax_element(curve.values);
            for (const double extreme : {*least, *largest}) {
                const double size = std::max(std::abs(*least), std::abs(*largest));
                if (std::abs(extreme) < 1e-9 * size) continue;
                EXPECT_TRUE(std::ranges::any_of(
                    curve.marks,
                    [&](const CurveMark& mark) { return std::abs(mark.value - extreme) < 1e-3 * size; }))
                    << curve.key << " " << extreme;
            }
        }
    }
}

TEST(MotionSvg, NeedsACurve) {
    EXPECT_EQ(refusal([&] { (void)motion_svg(test::infeasible_solution()); }),
              "motion.svg needs a motion, and this solution has none");
}

TEST(ReferenceMotion, ReturnMirrorsRiseOnItsAngle) {
    Scene scene = test::sample_solution().scene;
    scene.motion.type = MotionType::rr;
    scene.motion.return_angle = scene.motion.rise / 2;
    const ReferenceMotion reference = reference_motion(scene);
    const Motion& motion = *reference.motion;
    EXPECT_DOUBLE_EQ(motion.end(), 1.5);
    const MotionPoint rise = motion.at(0.3), fall = motion.at(1.5 - 0.5 * 0.3);
    EXPECT_NEAR(fall.derivative[0], rise.derivative[0], 1e-14);
    EXPECT_NEAR(fall.derivative[1], -2 * rise.derivative[1], 1e-13);
    EXPECT_NEAR(fall.derivative[2], 4 * rise.derivative[2], 1e-12);
    EXPECT_NEAR(fall.derivative[3], -8 * rise.derivative[3], 1e-11);
    EXPECT_NEAR(reference.peaks.jerk.value, 8 * 69.46635728872427, 1e-9);
    // The mean square over the motion, recomputed on the return's stretched copy.
    EXPECT_NEAR(reference.peaks.rms_acceleration, 3.9088559306898487 * std::sqrt((1 + 0.5 * 16) / 1.5), 1e-9);
    EXPECT_NEAR(motion.at(1.5, Side::left).derivative[0], 0.0, 1e-15);
    EXPECT_EQ(motion.breakpoints().back(), 1.5);
}

TEST(AxisTicks, AreRoundAndInside) {
    EXPECT_EQ(round_ticks(-0.1, 1.05, 6), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
    EXPECT_EQ(degree_ticks(0, 180, 14).size(), 13U);
    EXPECT_TRUE(round_ticks(1, 1, 5).empty());
    EXPECT_TRUE(labelled_ticks(1, 1, 5).empty());
    ASSERT_EQ(labelled_ticks(0.93, 1.04, 1).size(), 1U);  // one alone has no neighbour to be told from
    EXPECT_EQ(labelled_ticks(0.93, 1.04, 1).front().words, "1.0");
    EXPECT_EQ(tick_text(-0.5, 0.5), "−0.5");
    EXPECT_EQ(tick_text(20, 10), "20");
}

TEST(NumberText, RoundTripsAndOmitsInfinity) {
    for (const double value : {1.0 / 3.0, 5e-324, -1.7976931348623157e308, 0.1})
        EXPECT_EQ(std::strtod(round_trip_text(value).c_str(), nullptr), value);
    EXPECT_EQ(round_trip_text(-0.0), "0");
    EXPECT_EQ(round_trip_text(infinity), "");
    EXPECT_EQ(short_text(infinity), "∞");
    EXPECT_EQ(change_text(0.974, 1.0), "−2.6 %");
    EXPECT_EQ(change_text(1.0, 1.0), "±0.0 %");
    EXPECT_EQ(change_text(1.0, infinity), "–");
}

}  // namespace motion_svg_test
}  // namespace camopt

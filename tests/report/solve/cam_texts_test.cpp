// SPDX-License-Identifier: MIT
// Numbers that are said of cams and programs. The words: tests/golden.
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "report/solve/cam_remarks.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/view.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/support/refusal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace camopt {
namespace cam_texts_test {

using testing_support::says;

std::string remarks_of(const Solution& solution) {
    std::string text;
    for (const std::string& remark : cam_remarks(solution)) text += remark + "\n";
    return text;
}

Solution eccentric(const std::string& motion) {
    const Scene scene = input::read_scene(
        "[motion]\ntype = \"program\"\nlift_mm = 30\nspeed_rpm = 500\n" + motion +
            "segments = [{ kind = \"law\", law = \"simple_harmonic\", angle_deg = 180, to = 1.0 }, "
            "{ kind = \"law\", law = \"simple_harmonic\", angle_deg = 180, to = 0.0 }]\n"
            "[cam]\ntype = \"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = 25\n"
            "[forces]\nmass_kg = 0.9\nspring_rate_n_m = 1000\npreload_n = 2.5\n",
        "s.toml", known_names(), {});
    return solve(scene);
}

// F = 0.9 · 15 mm ω² cos θ + 1000 · 15 mm (1 − cos θ) + 2.5.
TEST(CamRemarks, NameWhereTheFollowerLeaves) {
    EXPECT_FALSE(says(remarks_of(test::cam_solution()), "LIFTS OFF"));
    Solution solution = eccentric("");
    EXPECT_TRUE(
        says(remarks_of(solution),
             "LIFTS OFF the cam at 142.661 deg and returns at 217.339 deg: it needs a stiffer spring or"));
    ASSERT_TRUE(solution.cam->summary.forces->lift_off_speed);
    EXPECT_NEAR(solution.cam->summary.forces->lift_off_speed->value, std::sqrt(32.5 / 0.0135), 1e-6);
    EXPECT_NEAR(solution.cam->summary.forces->lift_off_speed->at, 1.0, 1e-4);
    const std::vector<CamFigure> figures = cam_figures(solution);
    const auto speed = std::ranges::find(figures, "the follower lifts off above", &CamFigure::name);
    ASSERT_NE(speed, figures.end());
    EXPECT_EQ(speed->value, "468.539 rpm");
    EXPECT_TRUE(says(remarks_of(eccentric("phase_deg = 30\n")), "at 172.661 deg and returns at 247.339 deg"));
    solution.cam->summary.forces->least_force.at = 0.0;  // a spring has nothing to press with there
    EXPECT_TRUE(says(remarks_of(solution), "217.339 deg: it needs more preload."));
}

TEST(SegmentTable, JerkIsFiniteAcrossSmoothJoint) {
    const Solution solution = eccentric("");
    // y = (1 − cos πx) / 2 by the segment: J = π³ / 2.
    const double jerk = 0.5 * std::pow(std::numbers::pi, 3);
    EXPECT_NEAR(solution.peaks.jerk.value, jerk, 1e-9);
    EXPECT_NEAR(solution.motion_peaks.jerk.value, jerk, 1e-9);
    for (const SegmentReport& segment : solution.segments) {
        EXPECT_EQ(segment.continuity, 3);
        EXPECT_NEAR(segment.peaks->jerk.value, jerk, 1e-9);
    }
}

TEST(CurvatureCurve, HasNoGapsAtItsLimit) {
    const auto solved = [](const std::string& rest) {
        return solve(input::read_scene(
            "[motion]\ntype = \"program\"\nlift_mm = 30\n"
            "segments = [{ kind = \"law\", law = \"cycloidal\", angle_deg = 90, to = 1.0 }, "
            "{ kind = \"law\", law = \"cycloidal\", angle_deg = 90, to = 0.0 }, "
            "{ kind = \"dwell\", angle_deg = 180 }]\n"
            "[cam]\ntype = \"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = 51\n" +
                rest,
            "s.toml", known_names(), {}));
    };
    const double least = solved("").cam->summary.convex_radius->value;
    ASSERT_GT(least, 0.0);
    ASSERT_LT(least, 51e-3 / 8.0);
    const Solution solution =
        solved(fmt::format("[limits]\ncam_radius_min_mm = {:.9f}\n", 0.999 * least / 1e-3));
    const View view(solution);
    const auto curve = std::ranges::find(view.curves, "curvature", &Curve::key);
    ASSERT_NE(curve, view.curves.end());
    EXPECT_TRUE(std::ranges::all_of(curve->values, [](double value) { return std::isfinite(value); }));
}

TEST(CheckCam, SampleMovesFollowerAsDesigned) {
    const Solution solution = test::cam_solution();
    const ForwardCheckReport check = check_cam(solution);
    EXPECT_LT(check.deviation, 1e-9);
    EXPECT_GE(check.points, 2000);
    EXPECT_GT(check_cam(test::undercut_solution()).relative, 1e-3);
}

TEST(CheckCam, EarlyReturnIsFollowedByDwell) {
    Solution solution = test::cam_solution();
    EXPECT_EQ(cam_motion(solution).end(), 1.0);
    solution.scene.motion.type = MotionType::rr;
    EXPECT_DOUBLE_EQ(cam_motion(solution).end(), 4.0);
    EXPECT_EQ(cam_motion(solution).at(3.0).derivative[0], 0.0);
}

// The rest of the turn, half before the rise and half after it; open between the far ends, and said why.
TEST(CheckCam, SingleRiseIncludesDwellArcs) {
    Solution solution = test::cam_solution();
    ASSERT_EQ(solution.scene.motion.type, MotionType::drd);
    const MotionChain drawn = drawn_motion(solution);
    EXPECT_DOUBLE_EQ(drawn.begin(), -1.5);
    EXPECT_DOUBLE_EQ(drawn.end(), 2.5);
    for (const double x : {-1.5, -0.1}) EXPECT_EQ(drawn.at(x).derivative[0], 0.0);
    for (const double x : {1.1, 2.5}) EXPECT_EQ(drawn.at(x, Side::left).derivative[0], 1.0);
    EXPECT_EQ(drawn.at(0.3).derivative, solution.motion->at(0.3).derivative);
    EXPECT_NE(open_because(solution).find("no return is given"), std::string::npos);
    solution.scene.motion.type = MotionType::rr;
    EXPECT_EQ(open_because(solution), "");
    EXPECT_DOUBLE_EQ(drawn_motion(solution).end(), 4.0);
}

}  // namespace cam_texts_test
}  // namespace camopt

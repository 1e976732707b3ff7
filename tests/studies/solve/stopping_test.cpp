// SPDX-License-Identifier: MIT
// Time limits, iteration limits and Ctrl-C: the best feasible point so far is kept and labelled.
#include "profiles/disk/disk_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace stopping_test {

using testing_support::is_available;
using testing_support::normalised_limit;
using testing_support::paper_objective;

class Stopping : public testing::TestWithParam<std::string> {
 protected:
    void SetUp() override {
        if (!is_available(GetParam())) GTEST_SKIP() << GetParam() << " is not part of this build";
    }
    Scene scene() const {
        Scene scene = paper_objective(MotionType::drd, 5, 24);
        scene.solver.name = GetParam();
        return scene;
    }
};

TEST_P(Stopping, AStopRequestDeliversAFeasibleCurve) {
    SolveControl control;
    int polls = 0;
    control.stop_requested = [&] { return ++polls > 3; };
    const Solution solution = solve(scene(), control);
    EXPECT_EQ(solution.certificate.verdict, Verdict::feasible);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    ASSERT_TRUE(solution.curve);
    EXPECT_NEAR(solution.curve->at(1.0).derivative[0], 1.0, 1e-9);
}

TEST_P(Stopping, ATimeLimitDeliversAFeasibleCurve) {
    Scene hurried = scene();
    hurried.solver.max_seconds = 1e-6;
    const Solution solution = solve(hurried);
    EXPECT_EQ(solution.certificate.reason, "time_limit");
    EXPECT_EQ(solution.certificate.verdict, Verdict::feasible);
    ASSERT_TRUE(solution.curve);
}

TEST_P(Stopping, StopWithoutFeasiblePointIsReported) {
    Scene capped = scene();
    capped.limits.velocity = normalised_limit("limits.velocity", 1.3);
    SolveControl control;
    control.stop_requested = [] { return true; };
    const Solution solution = solve(capped, control);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    EXPECT_FALSE(solution.curve);
}

TEST_P(Stopping, EarlyStopDeliversNoMotion) {
    SolveControl control;
    control.stop_requested = [] { return true; };
    const Solution solution = solve(scene(), control);  // its start satisfies every limit
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    EXPECT_FALSE(solution.motion);
    EXPECT_TRUE(solution.constraints.empty());
}

/// Of a cam whose limits are not convex: several starts.
Scene searched_scene() {
    Scene scene = paper_objective(MotionType::drd, 5, 16);
    scene.motion.lift = 0.02;
    scene.motion.rise = 1.6;
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 0.03);
    scene.cam->set(DimensionIndex::roller_radius, 0.01);
    scene.limits.cam_radius_min = WrittenLimit(0.012);
    scene.limits.concave_radius_min = WrittenLimit(0.05);
    return scene;
}

TEST(StoppingASearch, ImmediatelyDeliversNoMotion) {
    for (const bool free_knots : {false, true}) {
        Scene scene = free_knots ? paper_objective(MotionType::drd, 3, 6) : searched_scene();
        scene.spline.free_knots = free_knots;
        SolveControl control;
        control.stop_requested = [] { return true; };
        const Solution solution = solve(scene, control);
        EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
        EXPECT_EQ(solution.certificate.reason, "interrupted");
        EXPECT_FALSE(solution.motion);
    }
}

TEST(StoppingASearch, AnyPollEndsConsistently) {
    for (const int patience : {1, 10, 40, 160}) {
        SolveControl control;
        int polls = 0;
        control.stop_requested = [&] { return ++polls > patience; };
        const Solution solution = solve(searched_scene(), control);
        const Certificate& certificate = solution.certificate;
        if (polls <= patience) break;  // it ended before
        if (certificate.verdict == Verdict::failed) {
            EXPECT_EQ(certificate.reason, "interrupted") << patience;
            EXPECT_FALSE(solution.motion);
        } else {
            EXPECT_LE(certificate.worst_violation, 1e-9) << patience;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, Stopping,
                         testing::Values("structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"),
                         [](const auto& backend) {
                             std::string name = backend.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

}  // namespace stopping_test
}  // namespace camopt

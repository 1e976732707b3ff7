// SPDX-License-Identifier: MIT
// The body of an indexing cam: solid, and its sides are where the rollers touch.
#include "output/spatial/indexing_body.hpp"

#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace indexing_body_test {

using testing_support::refusal;

TEST(IndexingBody, IsMadeOfSolids) {
    for (const auto& [cam, motion] : {std::pair{test::barrel_cam(), test::barrel_motion()},
                                      std::pair{test::rotating_cam(), test::rotating_motion()}}) {
        const IndexingBody body = indexing_body(cam, motion);
        for (const TriangleMesh* const part : {&body.thread, &body.hub, &body.rollers}) {
            EXPECT_TRUE(mesh_edges(*part).watertight());
            EXPECT_GT(volume(*part), 0.0);
        }
        EXPECT_EQ(painted(body).size(), 3u);
    }
}

// In the dwell the thread of the paper-cup machine fills the gap between two rollers at ±180°/7:
// 2 r_i sin(π/7) − 2 r along the cam's axis.
TEST(IndexingBody, ThreadFillsTheGapBetweenTwoRollers) {
    const IndexingBody body = indexing_body(test::barrel_cam(), test::barrel_motion());
    const double gap = 2.0 * 0.164 * std::sin(std::numbers::pi / 7.0) - 2.0 * 0.03175;
    double widest = 0.0;
    for (const Eigen::Vector3d& point : body.thread.vertices) {
        // At cam angle 0 the rollers stand at polar angle 90°; 100 deg of turning into the dwell of 200 deg
        // shows the middle of it, at 90° − 100°.
        const double polar = std::atan2(point.y(), point.x());
        if (std::abs(polar + 10.0 * test::degree) < 30.0 * test::degree)
            widest = std::max(widest, std::abs(point.z()));
    }
    EXPECT_NEAR(2.0 * widest, gap, 1e-12);
    EXPECT_NEAR(gap, 0.0788136, 1e-6);
}

// No roller of the index enters the thread or the hub, wherever the cam stands.
TEST(IndexingBody, RollersDoNotEnterIt) {
    const SpatialCam cam = test::barrel_cam();
    const FollowerMotion motion = test::barrel_motion();
    const IndexingBody body = indexing_body(cam, motion);
    const double pitch = test::full_turn / 7.0;
    for (int k = 0; k <= 180; ++k) {
        const double theta = test::full_turn * k / 180;
        for (const int index : {-1, 0, 1}) {
            SpatialCam roller = cam;
            roller.start += index * pitch;
            const RollerAxis axis = roller_axis(roller, theta, motion.state(theta).s);
            for (const TriangleMesh* const part : {&body.thread, &body.hub})
                for (const Eigen::Vector3d& point : part->vertices) {
                    const double along = (point - axis.foot).dot(axis.direction);
                    if (along < 0.0 || along > cam.roller_length) continue;
                    const double distance = (point - axis.foot - along * axis.direction).norm();
                    EXPECT_GT(distance, 31.75e-3 - 1e-9) << k << ' ' << index;
                }
        }
    }
}

TEST(IndexingBody, RefusesMotionsThatDoNotIndex) {
    FollowerMotion half = test::barrel_motion();
    half.breakpoints.back() = 3.0;
    EXPECT_EQ(refusal([&] { (void)indexing_body(test::barrel_cam(), half); }),
              "indexing cam: the motion must take one turn, it takes 171.887 deg");
    FollowerMotion rest = test::barrel_motion();
    rest.state = [](double) { return FollowerState{}; };
    EXPECT_EQ(refusal([&] { (void)indexing_body(test::barrel_cam(), rest); }),
              "indexing cam: the motion must end one pitch from where it begins");
    EXPECT_EQ(refusal([&] {
                  (void)indexing_body(test::barrel_cam(), test::barrel_motion(), {4, 5, 0.4});
              }),
              "indexing body: angles must be >= 16, found 4");
}

}  // namespace indexing_body_test
}  // namespace camopt

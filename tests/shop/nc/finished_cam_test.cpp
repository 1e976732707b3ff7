// SPDX-License-Identifier: MIT
// How deep a cutter stands in the finished cam, against what is plain to see.
#include "shop/nc/finished_cam.hpp"

#include "core/errors.hpp"
#include "shop/nc/nc_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace finished_cam_test {

using test::degree;
using test::millimetre;

const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

ContourPoint circle(double theta) {
    const Eigen::Vector2d out(std::cos(theta), std::sin(theta));
    return {40.0 * millimetre * out, out};
}

TEST(FinishedPlaneCam, DepthOutsideAboveAndInside) {
    const auto cam = plane_finished_cam({circle, {0.0, test::full_turn}});
    const double radius = 6.0 * millimetre, error = 1e-7;  // of the polygon
    const auto depth = [&](double x, double z) {
        return cam->depth({{x * millimetre, 0.0, z * millimetre}, down}, radius) / millimetre;
    };
    EXPECT_NEAR(depth(46.0, -21.0), 0.0, error / millimetre);
    EXPECT_GE(depth(46.0, -21.0), 0.0);  // the polygon's error is never on the wrong side
    EXPECT_NEAR(depth(45.9, -21.0), 0.1, error / millimetre);
    EXPECT_NEAR(depth(50.0, -21.0), -4.0, error / millimetre);
    EXPECT_NEAR(depth(45.0, -0.3), 0.3, 1e-12);
    EXPECT_NEAR(depth(0.0, -9.0), 9.0, 1e-12);  // in the middle no contour is near: the tip is under the face
    EXPECT_NEAR(depth(20.0, -30.0), 26.0, error / millimetre);
    EXPECT_NEAR(depth(0.0, 2.0), -2.0, 1e-12);
    const ToolPose leaning{{0.05, 0.0, 0.0}, Eigen::Vector3d(0.1, 0.0, -1.0).normalized()};
    EXPECT_GT(cam->depth(leaning, radius), 1.0);  // it is not known how deep: too deep
}

// A cutter that touches stands no deeper than lines of roughing allow, no matter how large the cam is.
TEST(FinishedPlaneCam, LargePolygonsAreFine) {
    const auto cam = plane_finished_cam({[](double theta) {
                                             const Eigen::Vector2d out(std::cos(theta), std::sin(theta));
                                             return ContourPoint{3.0 * out, out};
                                         },
                                         {0.0, test::full_turn}});
    for (const double theta : test::even(0.0, test::full_turn, 500)) {
        const double reach = 3.006;
        const ToolPose touching{{reach * std::cos(theta), reach * std::sin(theta), -0.02}, down};
        EXPECT_GE(cam->depth(touching, 6.0 * millimetre), -1e-12);
        EXPECT_LT(cam->depth(touching, 6.0 * millimetre), 4e-7);
    }
}

TEST(FinishedPlaneCam, RefusesWhatIsNone) {
    EXPECT_THROW(static_cast<void>(plane_finished_cam({circle, {0.0}})), InputError);
    EXPECT_THROW(static_cast<void>(plane_finished_cam({circle, {0.0, 1.0}, 0.0, 3})), InputError);
}

std::unique_ptr<FinishedCam> grooved() {
    GroovedBody body{test::rotating_roller(), 0.0, test::full_turn, 8.0 * millimetre, 20.5 * millimetre,
                     {0.1, -0.05, 0.05}};
    return grooved_finished_cam(body);
}

TEST(FinishedGroovedCam, RollerGrooveIsFree) {
    const auto cam = grooved();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(0.0, test::full_turn);
    for (int i = 0; i < 500; ++i) {
        const RollerPose roller = test::rotating_roller()(angle(random), 20.0 * millimetre);
        EXPECT_LT(cam->depth({roller.center, roller.axis}, 8.0 * millimetre), 3e-6);
        EXPECT_LT(
            cam->depth({roller.center + 3.0 * millimetre * roller.normal, roller.axis}, 5.0 * millimetre),
            3e-6);
        const double deep = cam->depth({roller.center + 1.5 * millimetre * roller.axis, roller.axis}, 0.004);
        EXPECT_NEAR(deep / millimetre, 1.0, 0.01);
    }
}

TEST(FinishedGroovedCam, PointsOutsideAreDeep) {
    const auto cam = grooved();
    for (const double theta : test::even(5.0 * degree, 355.0 * degree, 70)) {
        const RollerPose roller = test::rotating_roller()(theta, 20.0 * millimetre);
        const ToolPose beside{roller.center + 0.05 * millimetre * roller.normal, roller.axis};
        EXPECT_NEAR(cam->depth(beside, 8.0 * millimetre) / millimetre, 0.05, 0.01) << theta;
        const ToolPose leaning{roller.center, (roller.axis + 0.02 * roller.normal).normalized()};
        EXPECT_GT(cam->depth(leaning, 8.0 * millimetre) / millimetre, 0.1) << theta;
        const ToolPose outside{roller.center - 0.2 * roller.axis, roller.axis};
        EXPECT_LT(cam->depth(outside, 8.0 * millimetre), -0.05) << theta;
    }
    const ToolPose along{{0.0, 0.0, -0.01}, down};
    EXPECT_GT(cam->depth(along, 1.0 * millimetre), 0.01);  // down the middle of the cam
}

}  // namespace finished_cam_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// The exported points of a flank drive the follower as designed, one seventh of a turn for the paper-cup
// machine; and flanks that are wrong are found out.
#include "studies/spatial/spatial_forward_check.hpp"

#include "core/errors.hpp"
#include "tests/profiles/spatial/reference_cams.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace camopt {
namespace spatial_forward_check_test {

using testing_support::refusal;

using namespace test;

struct Cam {
    SpatialCam cam;
    FollowerMotion motion;
};
const std::vector<Cam>& reference_cams() {
    static const std::vector<Cam> cams = {{barrel_cam(), barrel_motion()},
                                          {rotating_cam(), rotating_motion()},
                                          {translating_cam(), translating_motion()}};
    return cams;
}

SpatialForwardCheckInput input_of(const Cam& cam, int points) {
    const FlankGrid grid = flank_grid(cam.cam, cam.motion, FlankSampling{.sections = 2, .angles = points});
    SpatialForwardCheckInput input;
    input.sections = sections_of(grid);
    input.breaks = grid.breaks;
    input.follower = cam.cam;
    input.designed = [motion = cam.motion](double theta) { return motion.state(theta).s; };
    input.begin = cam.motion.begin();
    input.end = cam.motion.end();
    return input;
}

double deviation_of(const Cam& cam, int points) {
    return spatial_forward_check(input_of(cam, points)).deviation;
}

/// Independent references for the barrel: 4.8e-9, 2.9e-11, 5.4e-13 rad with a curve of lower order.
TEST(SpatialForwardCheck, CorrectFlanksReproduceDesignedMotion) {
    for (const Cam& cam : reference_cams()) {
        EXPECT_LT(deviation_of(cam, 401), 1e-9) << name_of(cam.cam.follower);
        EXPECT_LT(deviation_of(cam, 1601), 1e-12) << name_of(cam.cam.follower);
    }
}

TEST(SpatialForwardCheck, FewerPointsAreWorse) {
    const Cam& barrel = reference_cams().front();
    EXPECT_GT(deviation_of(barrel, 101), 8.0 * deviation_of(barrel, 201));
}

/// One turn from inside one dwell to inside the next.
TEST(SpatialForwardCheck, IndexRotatesOneSeventh) {
    const Cam cam{barrel_cam(), rise_motion(200.0 * degree, 160.0 * degree, full_turn / 7.0, -20.0 * degree,
                                            400.0 * degree)};
    SpatialForwardCheckInput input = input_of(cam, 1601);
    // The first and the last of the angles are one revolution apart.
    input.angles = 361;
    input.begin = -0.5 * degree;
    input.end = 360.5 * degree;
    const SpatialForwardCheckResult result = spatial_forward_check(input);
    EXPECT_EQ(result.beyond, 0);
    EXPECT_NEAR(result.travel / degree, 360.0 / 7.0, 1e-11);
    EXPECT_LT(result.deviation, 1e-12);
}

TEST(SpatialForwardCheck, FindsDisplacedFlank) {
    for (const Cam& cam : reference_cams()) {
        SpatialForwardCheckInput input = input_of(cam, 401);
        for (auto& section : input.sections)
            for (Eigen::Vector3d& point : section) point.z() += 1e-6;
        const double deviation = spatial_forward_check(input).deviation;
        EXPECT_GT(deviation, 0.5e-6) << name_of(cam.cam.follower);
        EXPECT_LT(deviation, 1e-4) << name_of(cam.cam.follower);
    }
}

TEST(SpatialForwardCheck, FindsOneWrongPoint) {
    SpatialForwardCheckInput input = input_of(reference_cams().front(), 401);
    input.sections.back()[300] += Eigen::Vector3d(1e-6, 1e-6, 1e-6);
    const SpatialForwardCheckResult result = spatial_forward_check(input);
    EXPECT_GT(result.deviation, 1e-7);
    EXPECT_EQ(result.section, 3);
    EXPECT_NEAR(result.theta, full_turn * 300.0 / 404.0, 0.1);
}

TEST(SpatialForwardCheck, FindsAWrongRoller) {
    SpatialForwardCheckInput input = input_of(reference_cams().front(), 401);
    input.follower.roller_radius += 1e-6;
    EXPECT_GT(spatial_forward_check(input).deviation, 1e-6);
}

TEST(SpatialForwardCheck, FindsUndercut) {
    Cam cam = reference_cams().front();
    cam.cam[SpatialDimension::center_distance] = 85.0 * millimetre;  // critical: 102.1 mm, flank −1
    SpatialForwardCheckInput input = input_of(cam, 1601);
    EXPECT_GT(spatial_forward_check(input).deviation, 1e-5);
}

TEST(SpatialForwardCheck, RefusesWhatItCannotCheck) {
    const SpatialForwardCheckInput good = input_of(reference_cams().front(), 101);
    const auto message = [&](auto change) {
        SpatialForwardCheckInput input = good;
        change(input);
        return refusal([&] { (void)spatial_forward_check(input); });
    };
    EXPECT_EQ(message([](auto& input) { input.designed = nullptr; }),
              "a forward check needs the designed motion");
    EXPECT_EQ(message([](auto& input) { input.sections.clear(); }),
              "a forward check needs at least one section of a flank");
    EXPECT_EQ(message([](auto& input) { input.angles = 1; }), "a forward check of 1 angles: at least 2");
    EXPECT_EQ(message([](auto& input) { input.end = input.begin; }), "a forward check from 0 to 0 rad");
    EXPECT_EQ(
        message([](auto& input) { input.sections[0][7].x() = std::numeric_limits<double>::quiet_NaN(); }),
        "a forward check takes finite points only, and one is not");
    EXPECT_EQ(message([](auto& input) { input.breaks = {100000}; }), "break 100000 of a curve of 104 points");
}

}  // namespace spatial_forward_check_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Cams that cannot be built are named as such, and those that can are not.
#include "tests/profiles/test_turn.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace camopt {
namespace geometry_fault_test {

using namespace test;
using enum DimensionIndex;

void set(DiskCam& cam, DimensionIndex index, double value) {
    cam.dimensions[static_cast<std::size_t>(index)] = value;
}

void expect_fault(const DiskCam& cam, double least, double most, const std::string& words) {
    const std::string fault = geometry_fault(cam, least, most);
    EXPECT_NE(fault.find(words), std::string::npos) << "'" << fault << "'";
}

TEST(GeometryFault, RegularCamsHaveNone) {
    for (const TestCam& cam : regular_cams()) EXPECT_EQ(geometry_fault(cam.cam, 0.0, cam.lift), "");
}

TEST(GeometryFault, EveryLengthIsPositive) {
    for (const TestCam& good : regular_cams())
        for (const DimensionIndex index : {base_radius, roller_radius, center_distance, arm_length}) {
            if (!has_dimension(good.cam.follower, index)) continue;
            DiskCam cam = good.cam;
            set(cam, index, 0.0);
            expect_fault(cam, 0.0, good.lift, name_of(index));
            set(cam, index, std::numeric_limits<double>::quiet_NaN());
            expect_fault(cam, 0.0, good.lift, name_of(index));
        }
}

TEST(GeometryFault, OffsetIsBelowThePrimeRadius) {
    for (const double roller : {0.0, 10.0})
        for (const double side : {-1.0, 1.0}) {
            EXPECT_EQ(geometry_fault(translating_roller(45, roller, side * 44.9).cam, 0.0, 0.025), "");
            expect_fault(translating_roller(45, roller, side * 45.1).cam, 0.0, 0.025,
                         "prime radius of 45 mm");
        }
}

TEST(GeometryFault, FollowerStaysAboveTheCamCentre) {
    expect_fault(translating_roller(45, 10, 0).cam, -0.046, 0.0, "above the cam centre");
    expect_fault(translating_roller(45, 10, 0).cam, -0.036, 0.0, "from the cam centre");
    EXPECT_EQ(geometry_fault(translating_roller(45, 10, 0).cam, -0.034, 0.0), "");
    expect_fault(translating_flat(60).cam, -0.061, 0.0, "above the cam centre");
    EXPECT_EQ(geometry_fault(translating_flat(60).cam, -0.059, 0.0), "");
    expect_fault(oscillating_flat(4).cam, -20.0 * degree, 0.0, "above the cam centre");
}

TEST(GeometryFault, ArmReachIsBounded) {
    TestCam cam = oscillating_roller(10);
    set(cam.cam, base_radius, 0.009);  // prime radius 19 mm, difference of the lengths 20 mm
    expect_fault(cam.cam, 0.0, cam.lift, "the reach of the arm");
    set(cam.cam, base_radius, 0.171);  // 181 mm, sum 180 mm
    expect_fault(cam.cam, 0.0, cam.lift, "the reach of the arm");
    cam = oscillating_roller(10);
    EXPECT_EQ(geometry_fault(cam.cam, 0.0, 147.0 * degree), "");
    expect_fault(cam.cam, 0.0, 149.0 * degree, "passes the line of centres");
    expect_fault(cam.cam, -33.0 * degree, 0.0, "passes the line of centres");
    expect_fault(cam.cam, -32.0 * degree, 0.0, "passes the line of centres");
}

TEST(GeometryFault, FaceReachesBaseCircle) {
    TestCam cam = oscillating_flat(4);
    EXPECT_EQ(geometry_fault(cam.cam, 0.0, 67.0 * degree), "");
    expect_fault(cam.cam, 0.0, 69.0 * degree, "right angle");
    set(cam.cam, face_offset, 0.101);
    expect_fault(cam.cam, 0.0, 0.0, "center distance of 100 mm");
}

}  // namespace geometry_fault_test
}  // namespace camopt

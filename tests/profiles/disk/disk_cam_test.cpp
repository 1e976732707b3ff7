// SPDX-License-Identifier: MIT
// Points of the disk cams: reference numbers (made in 60-digit arithmetic from positions only), differences
// of neighbouring points, mirror images, extreme sizes.
#include "tests/profiles/test_turn.hpp"
#include "tests/support/middle_cam.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace camopt {
namespace disk_cam_test {

using Eigen::Vector2d;
using namespace test;

struct Reference {
    TestCam cam;
    double theta_deg, x_mm, y_mm, tangent, radius_mm;
    friend void PrintTo(const Reference& one, std::ostream* out) {
        PrintTo(one.cam, out);
        *out << " at " << one.theta_deg << " deg";
    }
};

const Reference references[] = {
    {translating_roller(45, 10), 100, 39.537836795946, -18.724698852467, .38274331912873, 98.727668758016},
    {translating_roller(45, 10), 250, -54.49727288098, -14.48118095883, -.31088465249307, 39.973527118436},
    {translating_roller(45, 0), 100, 49.355968435994, -16.826201789347, .38274331912873, 108.72766875802},
    {oscillating_roller(10), 100, 32.95286941288, -42.168381726932, .57451175318381, 85.844198576734},
    {oscillating_roller(10), 250, -66.546363729042, 20.343420719994, .020678511130313, 46.799211507503},
    {translating_flat(60), 100, 60.388147996624, -26.411861756894, 0, 86.294030341456},
    {oscillating_flat(4), 100, 22.833970074858, -33.861118146403, .052633207199699, 51.782814876236},
};

class ReferencePoint : public ::testing::TestWithParam<Reference> {};

TEST_P(ReferencePoint, HasPointPressureAngleAndRadius) {
    const Reference& expected = GetParam();
    const ProfilePoint point = expected.cam.at(expected.theta_deg * degree, TestTurn());
    EXPECT_NEAR(point.contact.x() / millimetre, expected.x_mm, 2e-11);
    EXPECT_NEAR(point.contact.y() / millimetre, expected.y_mm, 2e-11);
    EXPECT_NEAR(std::tan(point.pressure_angle), expected.tangent, 2e-13);
    EXPECT_NEAR(point.cam_radius / millimetre, expected.radius_mm, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(All, ReferencePoint, ::testing::ValuesIn(references));

class RegularCam : public ::testing::TestWithParam<TestCam> {
 protected:
    TestTurn turn;
    /// Fourth-order central difference by the cam angle.
    template <class Function>
    [[nodiscard]] static Vector2d slope(const Function& function, double theta) {
        constexpr double h = 1e-3;
        return (8.0 * (function(theta + h) - function(theta - h)) -
                (function(theta + 2 * h) - function(theta - 2 * h))) /
               (12.0 * h);
    }
    /// Well inside the pieces of the turn.
    [[nodiscard]] static std::vector<double> places() { return angles(5.5, 10.0); }
};

TEST_P(RegularCam, NormalIsPerpendicularAndOutward) {
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        const Vector2d tangent =
            slope([&](double angle) { return GetParam().at(angle, turn).contact; }, theta);
        EXPECT_NEAR(point.normal.norm(), 1.0, 1e-14);
        EXPECT_NEAR(point.normal.dot(tangent) / tangent.norm(), 0.0, 1e-8) << theta / degree;
        EXPECT_GT(point.normal.dot(point.contact), 0.0);
    }
}

TEST_P(RegularCam, RadiusMatchesRotationOfNormal) {
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        const Vector2d tangent =
            slope([&](double angle) { return GetParam().at(angle, turn).contact; }, theta);
        const Vector2d turning =
            slope([&](double angle) { return GetParam().at(angle, turn).normal; }, theta);
        EXPECT_NEAR(turning.dot(tangent) * point.cam_radius / tangent.squaredNorm(), 1.0, 2e-7);
    }
}

TEST_P(RegularCam, RegularityComparesSurfaceWithPitchCurve) {
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        const DiskCam& cam = GetParam().cam;
        const Vector2d surface =
            slope([&](double angle) { return GetParam().at(angle, turn).contact; }, theta);
        const Vector2d pitch = slope([&](double angle) { return GetParam().at(angle, turn).pitch; }, theta);
        const double unit = has_flat_face(cam.follower) ? cam[DimensionIndex::base_radius] : pitch.norm();
        EXPECT_NEAR(point.regularity, surface.norm() / unit, 1e-8);
    }
}

TEST_P(RegularCam, PressureAngleUsesNormalAndVelocity) {
    const DiskCam& cam = GetParam().cam;
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        Vector2d velocity(0.0, 1.0);
        if (is_oscillating(cam.follower)) {
            const Vector2d arm = point.center - Vector2d(cam[DimensionIndex::center_distance], 0.0);
            velocity = Vector2d(arm.y(), -arm.x()).normalized();
        }
        const double turned = (cam.rotation == Rotation::clockwise ? -1.0 : 1.0) * theta;
        const Vector2d seen = Eigen::Rotation2Dd(-turned) * velocity;
        EXPECT_NEAR(std::cos(point.pressure_angle), point.normal.dot(seen), 1e-13);
        EXPECT_LT((Eigen::Rotation2Dd(turned) * point.pitch - point.center).norm(), 1e-15);
    }
}

/// The cam of the other rotation that meets the same positions in the opposite order is the same cam.
TEST_P(RegularCam, IsUnchangedByOppositeRotation) {
    DiskCam other = GetParam().cam;
    const bool forward = other.rotation == Rotation::counterclockwise;
    other.rotation = forward ? Rotation::clockwise : Rotation::counterclockwise;
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        FollowerState state = state_of(turn.at(theta, Side::right), {GetParam().lift, 1.0});
        state.velocity = -state.velocity;
        const ProfilePoint same = profile_point(other, -theta, state);
        EXPECT_LT((same.contact - point.contact).norm(), 1e-16);
        EXPECT_LT((same.normal - point.normal).norm(), 1e-15);
        EXPECT_NEAR(same.cam_radius, point.cam_radius, 1e-15);
        EXPECT_NEAR(same.regularity, point.regularity, 1e-15);
        EXPECT_NEAR(std::abs(same.pressure_angle), std::abs(point.pressure_angle), 1e-15);
    }
}

/// Without a pivot, which would be on the other side.
class TranslatingCam : public RegularCam {};

/// Seen in a mirror beside it, a translating cam turns the other way with the opposite offset.
TEST_P(TranslatingCam, HasItsMirrorImage) {
    DiskCam mirrored = GetParam().cam;
    const bool forward = mirrored.rotation == Rotation::counterclockwise;
    mirrored.rotation = forward ? Rotation::clockwise : Rotation::counterclockwise;
    mirrored.dimensions[static_cast<std::size_t>(DimensionIndex::offset)] *= -1.0;
    for (const double theta : places()) {
        const ProfilePoint point = GetParam().at(theta, turn);
        const ProfilePoint image = TestCam{"", mirrored, GetParam().lift}.at(theta, turn);
        EXPECT_LT((image.contact - Vector2d(-point.contact.x(), point.contact.y())).norm(), 1e-16);
        EXPECT_LT((image.normal - Vector2d(-point.normal.x(), point.normal.y())).norm(), 1e-15);
        EXPECT_EQ(image.pressure_angle, point.pressure_angle);
        EXPECT_EQ(image.cam_radius, point.cam_radius);
        EXPECT_EQ(image.contact_offset, -point.contact_offset);
    }
}

INSTANTIATE_TEST_SUITE_P(All, RegularCam, ::testing::ValuesIn(regular_cams()),
                         [](const auto& item) { return item.param.name; });

INSTANTIATE_TEST_SUITE_P(All, TranslatingCam, ::testing::ValuesIn(regular_cams([](FollowerType follower) {
                             return !is_oscillating(follower);
                         })),
                         [](const auto& item) { return item.param.name; });

/// The reference cams, every length scaled.
class ScaledCam : public ::testing::TestWithParam<double> {};

TEST_P(ScaledCam, ScalesWithItsLengths) {
    const TestTurn turn;
    for (const TestCam& original : regular_cams()) {
        TestCam scaled = original;
        for (double& dimension : scaled.cam.dimensions) dimension *= GetParam();
        if (!is_oscillating(scaled.cam.follower)) scaled.lift *= GetParam();
        for (const double theta : angles(0.0, 2.5)) {
            const ProfilePoint point = scaled.at(theta, turn);
            const ProfilePoint expected = original.at(theta, turn);
            EXPECT_LT((point.contact / GetParam() - expected.contact).norm(), 1e-15);
            EXPECT_NEAR(point.pressure_angle, expected.pressure_angle, 1e-14);
            EXPECT_NEAR(point.regularity, expected.regularity, 1e-13);
        }
    }
}

// Lifts of 1e-6 m and 1 m.
INSTANTIATE_TEST_SUITE_P(All, ScaledCam, ::testing::Values(1e-6 / 0.025, 1.0 / 0.025));

/// Lifts far from the size of the cam: everything stays a number.
TEST(ExtremeLift, StaysFinite) {
    const TestTurn turn;
    for (const TestCam& cam : regular_cams())
        for (const double factor : {1e-6, 1e-3, 4.0}) {
            TestCam extreme = cam;
            extreme.lift *= factor;
            for (const double theta : angles(0.0, 0.5)) {
                const ProfilePoint point = extreme.at(theta, turn);
                const std::array values{point.contact.x(),     point.contact.y(),    point.normal.x(),
                                        point.normal.y(),      point.pressure_angle, point.cam_radius,
                                        point.pitch_curvature, point.regularity,     point.contact_offset};
                for (const double value : values)
                    ASSERT_TRUE(std::isfinite(value)) << cam.name << " " << factor << " " << theta;
            }
        }
}

TEST(MiddleCam, TakesTheMiddleOfEachRange) {
    DiskSpec spec;
    spec.follower = FollowerType::oscillating_roller;
    spec.rotation = Rotation::clockwise;
    spec[DimensionIndex::base_radius] = Dimension(0.02, 0.06);
    spec[DimensionIndex::roller_radius] = 0.01;
    const DiskCam cam = middle_cam(spec);
    EXPECT_EQ(cam.follower, spec.follower);
    EXPECT_EQ(cam.rotation, spec.rotation);
    EXPECT_DOUBLE_EQ(cam[DimensionIndex::base_radius], 0.04);
    EXPECT_DOUBLE_EQ(cam[DimensionIndex::roller_radius], 0.01);
    EXPECT_DOUBLE_EQ(cam[DimensionIndex::offset], 0.0);
}

}  // namespace disk_cam_test
}  // namespace camopt

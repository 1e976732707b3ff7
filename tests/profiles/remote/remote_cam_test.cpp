// SPDX-License-Identifier: MIT
// The reference numbers of docs/theory/remote_follower.py, to the digits given there.
#include "tappet.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <vector>

namespace camopt {
namespace remote_cam_test {

using namespace test;

constexpr double millimetre = units::millimetre, degree = units::degree;

struct Row {
    const char* name;
    const char* law;
    double dwell;
    bool farther;
    double angle, at;
    double convex;                  ///< mm; 0: not given
    std::optional<double> concave;  ///< mm
    double contact_angle;           ///< by the contact point, deg; 0: not given
};

const Row rows[] = {
    {"MT60", "modified_trapezoid", 60, false, 28.4532918499, 300.63178, 35.3045, {}, 36.7},
    {"MT75", "modified_trapezoid", 75, false, 31.6169201862, 308.55731, 30.6803, 584.10, 39.5},
    {"MT90", "modified_trapezoid", 90, false, 35.5402136266, 316.33701, 25.1188, 157.12, 43.0},
    {"MT752", "modified_trapezoid", 75, true, 29.0928975234, 307.75166, 38.3982, {}, 37.1},
    {"P4567_60", "polynomial_4567", 60, false, 31.1914337874, 107.81257, 31.0760, 564.18, 0},
    {"P4567_75", "polynomial_4567", 75, false, 34.4944331181, 0, 0, {}, 0},
    {"P4567_752", "polynomial_4567", 75, true, 31.5612642976, 0, 0, {}, 0},
};

class Tappet : public ::testing::TestWithParam<Row> {
 protected:
    CamSpec spec = tappet(GetParam().farther);
    std::vector<double> numbers = spec.middle();
    RemoteCam cam{spec};
    TappetMotion motion{GetParam().law, GetParam().dwell};

    [[nodiscard]] MechanismPoint at(const RemoteCam& own, double theta_deg) const {
        return own.point(theta_deg * degree, {numbers, motion.at(theta_deg)}, 0);
    }
};

/// The rows for which the paper gives this number.
std::vector<Row> rows_with(double Row::*number) {
    std::vector<Row> found;
    std::ranges::copy_if(rows, std::back_inserter(found), [&](const Row& row) { return row.*number != 0.0; });
    return found;
}

class TappetContact : public Tappet {};
class TappetProfile : public Tappet {};

TEST_P(Tappet, LargestPressureAngleAtTheRollerCentre) {
    const Extreme found = largest([&](double theta) { return std::abs(at(cam, theta).pressure_angle); });
    EXPECT_NEAR(found.value / degree, GetParam().angle, 1e-10);
    // A maximum is flat: its place is known to the root of rounding.
    if (GetParam().at > 0) {
        EXPECT_NEAR(found.theta_deg, GetParam().at, 1e-5);
    }
}

TEST_P(TappetContact, LargestPressureAngle) {
    CamSpec by_contact = spec;
    by_contact.choices["pressure_angle_at"] = name_of(PressurePoint::contact_point);
    const RemoteCam other(by_contact);
    const Extreme found = largest([&](double theta) { return std::abs(at(other, theta).pressure_angle); });
    EXPECT_NEAR(found.value / degree, GetParam().contact_angle, 0.0501);
}

TEST_P(TappetProfile, Radii) {
    const double roller = 30.0;
    const double sharpest = largest([&](double theta) { return at(cam, theta).pitch_curvature; }).value;
    const double hollow = largest([&](double theta) { return -at(cam, theta).pitch_curvature; }).value;
    EXPECT_NEAR(1.0 / (sharpest * millimetre) - roller, GetParam().convex, 6e-5);
    EXPECT_EQ(hollow > 0.0, GetParam().concave.has_value());
    if (GetParam().concave) {
        EXPECT_NEAR(1.0 / (hollow * millimetre) + roller, *GetParam().concave, 6e-3);
    }
}

const auto name_of_row = [](const auto& row) { return row.param.name; };
INSTANTIATE_TEST_SUITE_P(Paper003, Tappet, ::testing::ValuesIn(rows), name_of_row);
INSTANTIATE_TEST_SUITE_P(Paper003, TappetContact, ::testing::ValuesIn(rows_with(&Row::contact_angle)),
                         name_of_row);
INSTANTIATE_TEST_SUITE_P(Paper003, TappetProfile, ::testing::ValuesIn(rows_with(&Row::convex)), name_of_row);

TEST(RemoteCam, MT60At100Degrees) {
    const CamSpec spec = tappet();
    const std::vector<double> numbers = spec.middle();
    const RemoteCam cam(spec);
    const FollowerState state = TappetMotion("modified_trapezoid", 60).at(100);
    EXPECT_NEAR(state.s / millimetre - 40.0, -23.6171056594636, 1e-12);
    const RemoteCam::LeverState lever = cam.lever({numbers, state});
    EXPECT_NEAR(lever.angle, -0.0591478088492702, 1e-14);
    EXPECT_NEAR(lever.velocity, 0.208911060095432, 1e-14);
    EXPECT_NEAR(lever.acceleration, 0.331525238681079, 1e-14);
    const MechanismPoint point = cam.point(100 * degree, {numbers, state}, 0);
    EXPECT_NEAR(point.contact.x() / millimetre, 45.2672593832514, 1e-12);
    EXPECT_NEAR(point.contact.y() / millimetre, -19.8269792393226, 1e-12);
    EXPECT_NEAR(std::tan(point.pressure_angle), -0.506286954581988, 1e-14);
    EXPECT_NEAR(point.pitch_curvature * millimetre, 0.00687914199115577, 1e-16);
    EXPECT_NEAR(point.regularity, 1.0 - 30.0 * 0.00687914199115577, 1e-14);
    EXPECT_NEAR(point.cam_radius / millimetre, 1.0 / 0.00687914199115577 - 30.0, 1e-10);
}

/// The radius of the cam is that of the circle through three of its points, near each other.
TEST(RemoteCam, RadiusMatchesContactPoints) {
    const CamSpec spec = tappet();
    const std::vector<double> numbers = spec.middle();
    const RemoteCam cam(spec);
    const TappetMotion motion("modified_trapezoid", 60);
    const auto at = [&](double theta) { return cam.point(theta * degree, {numbers, motion.at(theta)}, 0); };
    for (const double theta : {75.0, 100.0, 130.0, 165.0, 250.0, 310.0}) {
        constexpr double step = 0.05;
        const Eigen::Vector3d before = at(theta - step).contact, here = at(theta).contact,
                              after = at(theta + step).contact;
        const double twice_area = (here - before).cross(after - before).z();
        const double radius =
            (here - before).norm() * (after - here).norm() * (after - before).norm() / (2.0 * twice_area);
        const double expected = at(theta).cam_radius;
        EXPECT_NEAR(std::abs(radius / expected), 1.0, 2e-4) << theta;
    }
}

/// The cam is the envelope of the roller: the distance from its points to every other position of the
/// roller's centre is at least the radius, and just that at their own.
TEST(RemoteCam, PointsLieOnRollerEnvelope) {
    const CamSpec spec = tappet();
    const std::vector<double> numbers = spec.middle();
    const RemoteCam cam(spec);
    const TappetMotion motion("modified_trapezoid", 60);
    std::vector<MechanismPoint> points;
    for (int i = 0; i < 3600; ++i)
        points.push_back(cam.point(0.1 * i * degree, {numbers, motion.at(0.1 * i)}, 0));
    for (std::size_t i = 0; i < points.size(); i += 36) {
        double nearest = 1.0;
        for (const MechanismPoint& other : points)
            nearest = std::min(nearest, (other.pitch - points[i].contact).norm());
        EXPECT_NEAR(nearest, 0.03, 1e-15);
    }
}

TEST(RemoteCam, ClockwiseMirrorsMirroredMechanism) {
    const CamSpec spec = tappet();
    CamSpec mirrored = spec;
    mirrored.rotation = Rotation::clockwise;
    mirrored.choices["lever_branch"] = "left";
    mirrored.choices["rocker_branch"] = "right";
    for (const RemoteDimension which : {lever_pivot_x, rocker_pivot_x, slider_x, lever_angle, rocker_angle}) {
        dimension(mirrored, which).low *= -1;
        dimension(mirrored, which).high *= -1;
    }
    const std::vector<double> numbers = spec.middle(), others = mirrored.middle();
    const RemoteCam cam(spec), other(mirrored);
    const TappetMotion motion("modified_trapezoid", 75);
    for (double theta = 0; theta < 360; theta += 7.3) {
        const MechanismPoint a = cam.point(theta * degree, {numbers, motion.at(theta)}, 0);
        const MechanismPoint b = other.point(theta * degree, {others, motion.at(theta)}, 0);
        EXPECT_NEAR(a.contact.x(), -b.contact.x(), 1e-15);
        EXPECT_NEAR(a.contact.y(), b.contact.y(), 1e-15);
        EXPECT_NEAR(a.pressure_angle, -b.pressure_angle,
                    1e-13);  // by the lever's turning, +: counterclockwise
        EXPECT_NEAR(a.pitch_curvature, b.pitch_curvature, 1e-10);
    }
}

TEST(RemoteCam, ForwardLinkageReproducesOutput) {
    for (const RemoteLinkage type :
         {RemoteLinkage::lever, RemoteLinkage::lever_coupler_slider, RemoteLinkage::lever_coupler_lever,
          RemoteLinkage::lever_coupler_lever_coupler_slider}) {
        CamSpec spec = tappet();
        spec.choices["linkage"] = name_of(type);
        const bool swings = output_swings(type);
        if (type == RemoteLinkage::lever_coupler_lever) set(spec, output_angle, 185);
        if (type == RemoteLinkage::lever) set(spec, output_angle, -5);
        if (type == RemoteLinkage::lever_coupler_slider) {
            set(spec, slider_x, 110);
            set(spec, slider_y, 350);
        }
        const std::vector<double> numbers = spec.middle();
        const RemoteCam cam(spec);
        const double most = swings ? 0.2 : 0.08;
        ASSERT_EQ(cam.fault(numbers, 0.0, most), "") << name_of(type);
        const RemoteLinkageForward forward(cam, numbers);
        for (int i = 0; i <= 20; ++i) {
            const double s = most * i / 20;
            EXPECT_NEAR(forward.output(cam.lever({numbers, {s, 0.0, 0.0}}).angle), s, 1e-14) << name_of(type);
        }
    }
}

}  // namespace remote_cam_test
}  // namespace camopt

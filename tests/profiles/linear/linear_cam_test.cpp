// SPDX-License-Identifier: MIT
// A plate compared with what it is the limit of, and with its own points.
#include "profiles/disk/disk_cam.hpp"
#include "profiles/linear/linear_mechanism.hpp"
#include "scene/scene.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace camopt {
namespace linear_cam_test {

using Eigen::Vector2d;
using enum MechanismQuantity;
using enum PlateFollower;

constexpr double mm = units::millimetre, degree = units::degree;

CamSpec plate(PlateFollower follower, double travel = 180 * mm, double inclination = 0.0) {
    CamSpec spec = linear_spec(follower);
    spec.set("travel", travel);
    spec.set("base_height", 30 * mm);
    if (follower != translating_knife) spec.set("roller_radius", 8 * mm);
    if (follower == oscillating_roller) {
        spec.set("arm_length", 70 * mm);
        spec.set("pivot_height", 20 * mm);
    } else {
        spec.set("inclination", inclination);
    }
    return spec;
}

/// A disk whose arc at the roller's centre passes as the plate does, with its follower on top.
DiskCam disk_of_radius(const CamSpec& spec, double prime) {
    using enum DimensionIndex;
    const PlateFollower follower = plate_follower(spec);
    const auto number = [&](const char* name) { return spec.find(name)->low; };
    DiskCam disk{FollowerType::translating_roller, Rotation::counterclockwise, {}, {}};
    const auto set = [&](DimensionIndex which, double value) {
        disk.dimensions[static_cast<std::size_t>(which)] = value;
    };
    const double radius = number("roller_radius");
    set(base_radius, prime - radius);
    set(roller_radius, radius);
    if (follower == translating_knife) disk.follower = FollowerType::translating_knife;
    if (follower != oscillating_roller) {
        set(offset, -prime * std::sin(number("inclination")));
        return disk;
    }
    disk.follower = FollowerType::oscillating_roller;
    const double arm = number("arm_length");
    const double start = std::asin((number("base_height") + radius - number("pivot_height")) / arm);
    set(arm_length, arm);
    set(center_distance, std::hypot(arm * std::cos(start), prime - arm * std::sin(start)));
    return disk;
}

/// How far the quantities of a disk of this radius are from those of the plate: N/D, κ, lever.
Eigen::Vector3d distance_to_disk(const CamSpec& spec, double prime) {
    const bool swings = plate_follower(spec) == oscillating_roller;
    const double slide = spec.find("travel")->low / units::turn;
    const auto numbers = spec.middle();
    const auto formulas = spec.formulas();
    const DiskCam disk = disk_of_radius(spec, prime);
    const double unit = swings ? 1.0 : 70 * mm;
    const FollowerState by_metre{0.1 * unit, 3.0 * unit, 40.0 * unit};  // of travel
    const FollowerState of_plate{by_metre.s, slide * by_metre.velocity,
                                 slide * slide * by_metre.acceleration};
    const FollowerState of_disk{by_metre.s, prime * by_metre.velocity, prime * prime * by_metre.acceleration};
    const auto plate_value = [&](MechanismQuantity which) {
        return formulas->quantity(which, {numbers, of_plate}, 0, {}).value;
    };
    const auto disk_value = [&](MechanismQuantity which) { return quantity(disk, of_disk, which).value; };
    const auto tangent = [](const auto& value) {
        return value(pressure_numerator) / value(pressure_denominator);
    };
    return {tangent(disk_value) - tangent(plate_value),
            (disk_value(pitch_curvature) - plate_value(pitch_curvature)) * 8 * mm,
            (disk_value(normal_lever) - plate_value(normal_lever)) / unit};
}

class LinearCam : public testing::TestWithParam<CamSpec> {};

TEST_P(LinearCam, IsTheLimitOfGrowingDisks) {
    const Eigen::Vector3d near = distance_to_disk(GetParam(), 100.0),
                          far = distance_to_disk(GetParam(), 10000.0);
    EXPECT_LT(far.cwiseAbs().maxCoeff(), 2e-5);
    EXPECT_LT(far.norm(), 0.011 * near.norm()) << near.transpose() << " and " << far.transpose();
    EXPECT_GT(near.norm(), 1e-5);
}

std::vector<CamSpec> plates() {
    std::vector<CamSpec> all;
    for (const double angle : {0.0, 12.0, -20.0}) {
        all.push_back(plate(translating_roller, 180 * mm, angle * degree));
        all.push_back(plate(translating_knife, 180 * mm, angle * degree));
    }
    all.push_back(plate(oscillating_roller));
    return all;
}

std::string number_of(const testing::TestParamInfo<CamSpec>& info) {
    return fmt::format("plate_{}", info.index);
}

INSTANTIATE_TEST_SUITE_P(Followers, LinearCam, testing::ValuesIn(plates()), number_of);

/// The plates, and those that slide the other way.
std::vector<CamSpec> either_way() {
    std::vector<CamSpec> all = plates();
    for (CamSpec& spec : plates()) {
        spec.set("travel", -spec.find("travel")->low);
        all.push_back(spec);
    }
    return all;
}

/// A rise over 2 rad.
FollowerState rise_at(double theta, double lift) {
    const double t = 0.5 * theta;
    return {lift * t * t * t * (10.0 + t * (-15.0 + 6.0 * t)),
            0.5 * lift * 30.0 * t * t * (1.0 + t * (-2.0 + t)),
            0.25 * lift * 60.0 * t * (1.0 + t * (-3.0 + 2.0 * t))};
}

class LinearPoints : public testing::TestWithParam<CamSpec> {
 protected:
    std::shared_ptr<const CamMechanism> formulas = GetParam().formulas();
    std::vector<double> numbers = GetParam().middle();
    double lift = formulas->swings() ? 0.3 : 20 * mm;

    [[nodiscard]] MechanismPoint at(double theta) const {
        return formulas->point(theta, {numbers, rise_at(theta, lift), theta}, 0);
    }
};

TEST_P(LinearPoints, HaveNormalAndCurvatureOfPath) {
    constexpr double step = 1e-4;
    for (const double theta : {0.2, 0.7, 1.0, 1.4, 1.9}) {
        const MechanismPoint point = at(theta);
        const Vector2d before = at(theta - step).pitch.head<2>(), here = point.pitch.head<2>(),
                       after = at(theta + step).pitch.head<2>();
        const Vector2d along = (after - before) / (2.0 * step),
                       bend = (after - 2.0 * here + before) / (step * step);
        EXPECT_NEAR(point.normal.head<2>().dot(along), 0.0, 1e-7 * along.norm());
        EXPECT_GT(point.normal.y(), 0.0);
        // A path that bends away from the normal is convex.
        EXPECT_NEAR(point.pitch_curvature, -bend.dot(point.normal.head<2>()) / along.squaredNorm(),
                    1e-5 / (8 * mm));
        EXPECT_NEAR((point.pitch - point.contact).norm(), numbers[2], 1e-15);
    }
}

TEST_P(LinearPoints, LeanByThePressureAngle) {
    constexpr double step = 1e-5;
    for (const double theta : {0.3, 1.0, 1.7}) {
        const MechanismPoint point = at(theta);
        const auto tip = [&](double by) {
            const FollowerState state = rise_at(theta + by, lift);
            const auto parts = formulas->plane()->shapes({numbers, state, theta + by});
            return Vector2d(parts[1].points.front());
        };
        const Vector2d way = (tip(step) - tip(-step)).normalized();
        EXPECT_NEAR(std::acos(std::min(1.0, way.dot(point.normal.head<2>()))), std::abs(point.pressure_angle),
                    1e-6);
    }
}

TEST_P(LinearPoints, LieUnderFollowerInTheirPose) {
    for (const double theta : {0.0, 0.8, 1.6}) {
        const MechanismState state{numbers, rise_at(theta, lift), theta};
        const CamPose pose = formulas->plane()->pose(state);
        EXPECT_EQ(pose.turn, 0.0);
        const Vector2d placed = at(theta).pitch.head<2>() + pose.shift;
        EXPECT_NEAR((placed - formulas->plane()->shapes(state)[1].points.front()).norm(), 0.0, 1e-15);
    }
    EXPECT_NEAR(at(0.0).contact.y(), 30 * mm, 1e-15);
    EXPECT_NEAR(at(0.0).contact.x(), 0.0, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(EitherWay, LinearPoints, testing::ValuesIn(either_way()), number_of);

std::string fault_of(const CamSpec& spec, double least, double most) {
    return spec.formulas()->fault(spec.middle(), least, most);
}

TEST(LinearCamFault, NamesWhatCannotMove) {
    CamSpec arm = plate(oscillating_roller);
    EXPECT_EQ(fault_of(arm, 0.0, 0.3), "");
    EXPECT_NE(fault_of(arm, 0.0, 1.5).find("it must stay between -90 and 90 deg"), std::string::npos);
    arm.set("pivot_height", 150 * mm);
    EXPECT_NE(fault_of(arm, 0.0, 0.3).find("does not reach"), std::string::npos);
    EXPECT_NE(fault_of(plate(translating_knife), -0.04, 0.0).find("below the plate's bottom"),
              std::string::npos);
}

TEST(LinearCamFault, RefusesTravelThroughZero) {
    MotionSpec motion;
    motion.lift = 20 * mm;
    CamSpec spec = plate(translating_roller);
    EXPECT_FALSE(spec.formulas()->find_fault(spec, motion).has_value());
    for (const Dimension& travel : {Dimension(0.0), Dimension(-10 * mm, 100 * mm)}) {
        spec.set("travel", travel);
        EXPECT_TRUE(spec.formulas()->find_fault(spec, motion).has_value());
    }
}

}  // namespace linear_cam_test
}  // namespace camopt

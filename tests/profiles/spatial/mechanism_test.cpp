// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams as a mechanism of a scene: their values follow from where the roller goes, at
// every station, and the stations that do not bind
// the pressure angle never have the largest one.
#include "core/errors.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "situations.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace camopt {
namespace mechanism_test {

using testing_support::refusal;

using namespace test;

/// A state of a mechanism with its numbers in one row: s, s', s'', numbers.
struct Row {
    std::shared_ptr<const CamMechanism> mechanism;
    SpatialFollower follower;
    Rotation rotation;
    std::vector<double> values;
    int station = 0;

    Row(const Situation& at, int which)
        : follower(at.cam.follower), rotation(at.cam.rotation), station(which) {
        CamSpec spec = spatial_spec(follower);
        spec.rotation = rotation;
        mechanism = spatial_mechanism(spec);
        values = {at.state.s, at.state.velocity, at.state.acceleration};
        for (const double dimension : at.cam.dimensions) values.push_back(dimension);
        for (const double number : {at.cam.axial_offset, at.cam.roller_length, at.cam.start})
            values.push_back(number);
    }
    [[nodiscard]] std::span<const double> numbers() const { return std::span(values).subspan(3); }
    [[nodiscard]] FollowerState state() const { return {values[0], values[1], values[2]}; }
    [[nodiscard]] MechanismValue value(MechanismQuantity which) const {
        return mechanism->quantity(which, {numbers(), state()}, station, {});
    }
    [[nodiscard]] SpatialPoint point() const {
        const SpatialCam cam = spatial_cam(follower, rotation, numbers());
        const double share = static_cast<double>(station / 2) / (mechanism_heights - 1);
        return spatial_point(cam, 0.3, state(), {share * cam.roller_length, station % 2 == 0 ? 1 : -1});
    }
};

class SpatialMechanismOf : public ::testing::TestWithParam<Case> {};

/// The roller's axis written down once more from the frames alone, and everything else by differences along a
/// motion that has the state's s, s', s'': what the mechanism says must follow from where its roller goes.
class Rebuilt {
 public:
    Rebuilt(const Situation& at, double height, int flank)
        : at_(at), height_(height), radius_(at.cam[SpatialDimension::roller_radius]) {
        const Eigen::Vector3d along = direction(theta);
        velocity_ = slope([this](double angle) { return center(angle); });
        normal = flank * velocity_.cross(along);
        normal.normalize();
        contact = center(theta) + radius_ * normal;
        const double around = velocity_.dot(along);
        const double squared = velocity_.squaredNorm() - around * around;
        constexpr double step = 1e-3;
        const Eigen::Vector3d bend =
            (-center(theta + 2 * step) + 16.0 * center(theta + step) - 30.0 * center(theta) +
             16.0 * center(theta - step) - center(theta - 2 * step)) /
            (12.0 * step * step);
        const double twist = slope([this](double angle) { return direction(angle); }).dot(normal);
        regularity = 1.0 - radius_ * (bend.dot(normal) - 2.0 * around * twist) / squared -
                     radius_ * radius_ * twist * twist / squared;
        // The way the roller goes with growing s, cam standing still, against the flank's normal.
        constexpr double shift = 1e-4;
        const auto moved = [&](double steps) { return place(theta, at_.state.s + steps * shift); };
        const Eigen::Vector3d travel = (8.0 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))).normalized();
        pressure_angle = std::asin(std::sqrt(std::max(0.0, 1.0 - std::pow(normal.dot(travel), 2))));
    }

    static constexpr double theta = 0.3;
    Eigen::Vector3d normal, contact;
    double regularity = 0.0, pressure_angle = 0.0;  ///< |φ|

 private:
    const Situation& at_;
    double height_, radius_;
    Eigen::Vector3d velocity_;

    [[nodiscard]] double follower(double angle) const {
        const double d = angle - theta;
        return at_.state.s + d * (at_.state.velocity + 0.5 * d * at_.state.acceleration);
    }
    [[nodiscard]] Eigen::Vector3d in_cam(const Eigen::Vector3d& fixed, double angle) const {
        const double turn = at_.cam.rotation == Rotation::counterclockwise ? angle : -angle;
        return {std::cos(turn) * fixed.x() + std::sin(turn) * fixed.y(),
                std::cos(turn) * fixed.y() - std::sin(turn) * fixed.x(), fixed.z()};
    }
    [[nodiscard]] Eigen::Vector3d place(double angle, double s) const {
        const SpatialCam& cam = at_.cam;
        const auto& [r, arm, distance, aside] = cam.dimensions;
        const double q = cam.start + s, axial = cam.axial_offset;
        if (cam.follower == SpatialFollower::barrel)
            return in_cam({arm * std::cos(q) - aside, distance - height_, -arm * std::sin(q) - axial}, angle);
        if (cam.follower == SpatialFollower::cylindrical_rotating)
            return in_cam(
                {aside, distance - (arm + height_) * std::cos(q), axial + (arm + height_) * std::sin(q)},
                angle);
        return in_cam({aside, distance - height_, axial + q}, angle);
    }
    [[nodiscard]] Eigen::Vector3d center(double angle) const { return place(angle, follower(angle)); }
    [[nodiscard]] Eigen::Vector3d direction(double angle) const {
        if (at_.cam.follower != SpatialFollower::cylindrical_rotating) return in_cam({0.0, -1.0, 0.0}, angle);
        const double q = at_.cam.start + follower(angle);
        return in_cam({0.0, -std::cos(q), std::sin(q)}, angle);
    }
    template <class Function>
    [[nodiscard]] static Eigen::Vector3d slope(const Function& f) {
        constexpr double step = 1e-3;
        return (8.0 * (f(theta + step) - f(theta - step)) - (f(theta + 2 * step) - f(theta - 2 * step))) /
               (12.0 * step);
    }
};

TEST_P(SpatialMechanismOf, ValuesMatchRollerPath) {
    repeat(GetParam(), [](const Situation& at) {
        for (int station = 0; station < 2 * mechanism_heights; ++station) {
            const Row row(at, station);
            const double share = static_cast<double>(station / 2) / (mechanism_heights - 1);
            const Rebuilt expected(at, share * at.cam.roller_length, station % 2 == 0 ? 1 : -1);
            const MechanismPoint point =
                row.mechanism->point(Rebuilt::theta, {row.numbers(), row.state()}, station);
            EXPECT_LT((point.contact - expected.contact).norm(), 1e-9);
            EXPECT_LT((point.normal + expected.normal).norm(), 1e-7);
            EXPECT_NEAR(point.regularity, expected.regularity, 1e-6);
            EXPECT_NEAR(std::abs(point.pressure_angle), expected.pressure_angle, 1e-6);
            EXPECT_NEAR(row.value(MechanismQuantity::regularity).value, expected.regularity, 1e-6);
            const double angle = std::atan2(row.value(MechanismQuantity::pressure_numerator).value,
                                            row.value(MechanismQuantity::pressure_denominator).value);
            EXPECT_NEAR(std::abs(angle), expected.pressure_angle, 1e-6);
            EXPECT_EQ(std::signbit(angle), std::signbit(point.pressure_angle));
            EXPECT_TRUE(std::isnan(point.cam_radius));
        }
    });
}

TEST_P(SpatialMechanismOf, InactiveStationsAreImplied) {
    repeat(GetParam(), [](const Situation& at) {
        double bound = 0.0, other = 0.0;
        for (int station = 0; station < 2 * mechanism_heights; ++station) {
            const Row row(at, station);
            const double angle = std::abs(row.point().pressure_angle);
            const bool binds =
                row.mechanism->limit_structure().binds(MechanismQuantity::pressure_numerator, station);
            double& largest = binds ? bound : other;
            largest = std::max(largest, angle);
            EXPECT_TRUE(row.mechanism->limit_structure().binds(MechanismQuantity::regularity, station));
        }
        EXPECT_LE(other, bound + 1e-14);
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, SpatialMechanismOf, ::testing::ValuesIn(every_case()), case_name);

/// A barrel cam's numbers and a state whose angle u = φ ± (start + s) may lie anywhere.
struct BarrelState {
    std::shared_ptr<const CamMechanism> mechanism;
    Rotation rotation;
    std::vector<double> numbers = {0.01, 0.07, 0.15, 0.075, 0.004, 0.03, -0.4};

    explicit BarrelState(Rotation which) : rotation(which) {
        CamSpec spec = spatial_spec(SpatialFollower::barrel);
        spec.rotation = rotation;
        mechanism = spatial_mechanism(spec);
    }
    [[nodiscard]] MechanismValue excess(int sign, double s, double velocity) const {
        return mechanism->pressure_excess(limit, sign, {numbers, {s, velocity, 0.0}}, 0, {});
    }
    [[nodiscard]] double angle(int sign, double s) const {
        return limit + (rotation == Rotation::clockwise ? -sign : sign) * (numbers.back() + s);
    }
    static constexpr double limit = 0.5;
};

TEST(BarrelPressureAngle, IsConvexInNonrotatingDimensions) {
    const BarrelState barrel(Rotation::counterclockwise);
    const auto shape = [&](std::vector<SpatialNumber> moved) {
        std::vector<int> active;
        for (const SpatialNumber number : moved) active.push_back(static_cast<int>(number));
        return barrel.mechanism->limit_structure().pressure_shape({}, {barrel.numbers, active}, -1e9, 1e9);
    };
    using enum SpatialNumber;
    EXPECT_EQ(shape({}), Curvature::convex);
    for (const SpatialNumber number : {roller_radius, lateral_offset, axial_offset})
        EXPECT_EQ(shape({number}), Curvature::convex);
    EXPECT_EQ(shape({roller_radius, lateral_offset, axial_offset}), Curvature::convex);
    for (const SpatialNumber number : {arm_length, center_distance, roller_length, start}) {
        EXPECT_EQ(shape({number}), Curvature::general);
        EXPECT_EQ(shape({roller_radius, number}), Curvature::general);
    }
}

/// Beyond 0 <= u <= π it goes on along its tangents: nothing jumps, and the Hessian has no negative
/// direction.
TEST(BarrelPressureAngle, ContinuesAlongTangentsBothWays) {
    for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
        for (const int sign : {-1, 1}) {
            const BarrelState barrel(rotation);
            int outside = 0;
            for (double s = -5.0; s <= 5.0; s += 0.0625) {
                const double velocity = 0.3;
                const MechanismValue at = barrel.excess(sign, s, velocity);
                constexpr double step = 1e-3;
                const MechanismValue left = barrel.excess(sign, s - step, velocity);
                const MechanismValue right = barrel.excess(sign, s + step, velocity);
                EXPECT_NEAR(at.gradient(0), (right.value - left.value) / (2.0 * step), 1e-6);
                EXPECT_GE(left.value + right.value - 2.0 * at.value, -1e-14) << s;
                EXPECT_GE(at.hessian(0, 0), -1e-14) << s;
                if (const double u = barrel.angle(sign, s); u < 0.0 || u > std::numbers::pi) {
                    EXPECT_NEAR(at.hessian(0, 0), 0.0, 1e-14) << s;
                    ++outside;
                }
            }
            EXPECT_GT(outside, 50);
        }
}

TEST(SpatialSpec, KnowsItsKindsAndNoOther) {
    for (const SpatialFollower follower : {SpatialFollower::barrel, SpatialFollower::cylindrical_rotating,
                                           SpatialFollower::cylindrical_translating}) {
        const CamSpec spec = spatial_spec(follower);
        EXPECT_EQ(spatial_follower(spec), follower);
        EXPECT_EQ(spec.dimensions.size(), static_cast<std::size_t>(spatial_number_count));
        EXPECT_EQ(spatial_mechanism(spec)->swings(), swings(follower));
        EXPECT_FALSE(spatial_mechanism(spec)->radius_quantity());
    }
    CamSpec other;
    other.type = "remote";
    EXPECT_EQ(refusal([&] { (void)spatial_mechanism(other); }),
              "a mechanism of type \"remote\"; allowed: \"barrel\", or \"cylindrical\" with a follower "
              "\"rotating\" or \"translating\"");
    other.type = "cylindrical";
    EXPECT_EQ(refusal([&] { (void)spatial_mechanism(other); }),
              "a mechanism of type \"cylindrical\"; allowed: \"barrel\", or \"cylindrical\" with a follower "
              "\"rotating\" or \"translating\"");
}

}  // namespace mechanism_test
}  // namespace camopt

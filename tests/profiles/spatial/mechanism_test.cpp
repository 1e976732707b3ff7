// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams as a mechanism of a scene: their values are those of spatial_cam.hpp at every
// station, their partials by every number are those of differences, and the stations that do not bind the
// pressure angle never have the largest one.
#include "core/errors.hpp"
#include "core/spatial_spec.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"
#include "situations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace camopt {
namespace {

using namespace test;

constexpr std::array every_quantity = {MechanismQuantity::pressure_numerator,
                                       MechanismQuantity::pressure_denominator,
                                       MechanismQuantity::regularity};

/// A state of a mechanism with its numbers in one row: s, s', s'', numbers.
struct Row {
    std::shared_ptr<const CamMechanism> mechanism;
    SpatialFollower follower;
    Rotation rotation;
    std::vector<double> values;
    int station = 0;

    Row(const Situation& at, int which)
        : follower(at.cam.follower), rotation(at.cam.rotation), station(which) {
        MechanismSpec spec = spatial_spec(follower);
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
        std::vector<int> active(spatial_number_count);
        std::iota(active.begin(), active.end(), 0);
        return mechanism->quantity(which, {numbers(), state()}, station, active);
    }
    [[nodiscard]] SpatialPoint point() const {
        const SpatialCam cam = spatial_cam(follower, rotation, numbers());
        const double share = static_cast<double>(station / 2) / (mechanism_heights - 1);
        return spatial_point(cam, 0.3, state(), {share * cam.roller_length, station % 2 == 0 ? 1 : -1});
    }
};

class SpatialMechanismOf : public ::testing::TestWithParam<Case> {};

TEST_P(SpatialMechanismOf, HasTheValuesOfTheCam) {
    repeat(GetParam(), [](const Situation& at) {
        for (int station = 0; station < 2 * mechanism_heights; ++station) {
            const Row row(at, station);
            const SpatialPoint expected = row.point();
            const MechanismPoint point = row.mechanism->point(0.3, {row.numbers(), row.state()}, station);
            EXPECT_EQ(point.contact, expected.contact);
            EXPECT_EQ(point.normal, -expected.normal);
            EXPECT_EQ(point.regularity, expected.undercut);
            EXPECT_NEAR(row.value(MechanismQuantity::regularity).value, expected.undercut, 1e-14);
            EXPECT_NEAR(std::atan2(row.value(MechanismQuantity::pressure_numerator).value,
                                   row.value(MechanismQuantity::pressure_denominator).value),
                        expected.pressure_angle, 1e-14);
            EXPECT_TRUE(std::isnan(point.cam_radius));
        }
    });
}

TEST_P(SpatialMechanismOf, PartialsByEveryNumberAreThoseOfDifferences) {
    repeat(GetParam(), [](const Situation& at) {
        const int station = 2 + at.station.flank;  // 1 and 3: near end and middle, flank −1
        const Row row(at, station);
        for (const MechanismQuantity which : every_quantity) {
            const MechanismValue exact = row.value(which);
            ASSERT_EQ(exact.gradient.size(), 3 + spatial_number_count);
            for (std::size_t i = 0; i < row.values.size(); ++i) {
                constexpr double step = 1e-5;
                const auto moved = [&](double steps) {
                    Row other = row;
                    other.values[i] += steps * step;
                    return other.value(which);
                };
                const MechanismValue f1 = moved(1), m1 = moved(-1), f2 = moved(2), m2 = moved(-2);
                const auto k = static_cast<Eigen::Index>(i);
                EXPECT_NEAR(exact.gradient[k],
                            (8.0 * (f1.value - m1.value) - (f2.value - m2.value)) / (12.0 * step), 1e-7);
                const Eigen::VectorXd slope =
                    (8.0 * (f1.gradient - m1.gradient) - (f2.gradient - m2.gradient)) / (12.0 * step);
                EXPECT_LT((exact.hessian.col(k) - slope).lpNorm<Eigen::Infinity>(),
                          1e-6 * (1.0 + exact.hessian.lpNorm<Eigen::Infinity>()));
            }
        }
    });
}

TEST_P(SpatialMechanismOf, StationsThatDoNotBindAreImplied) {
    repeat(GetParam(), [](const Situation& at) {
        double bound = 0.0, other = 0.0;
        for (int station = 0; station < 2 * mechanism_heights; ++station) {
            const Row row(at, station);
            const double angle = std::abs(row.point().pressure_angle);
            const bool binds = row.mechanism->binds(MechanismQuantity::pressure_numerator, station);
            double& largest = binds ? bound : other;
            largest = std::max(largest, angle);
            EXPECT_TRUE(row.mechanism->binds(MechanismQuantity::regularity, station));
        }
        EXPECT_LE(other, bound + 1e-14);
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, SpatialMechanismOf, ::testing::ValuesIn(every_case()), case_name);

TEST(SpatialSpec, KnowsItsKindsAndNoOther) {
    for (const SpatialFollower follower : {SpatialFollower::barrel, SpatialFollower::cylindrical_rotating,
                                           SpatialFollower::cylindrical_translating}) {
        const MechanismSpec spec = spatial_spec(follower);
        EXPECT_EQ(spatial_follower(spec), follower);
        EXPECT_EQ(spec.dimensions.size(), static_cast<std::size_t>(spatial_number_count));
        EXPECT_EQ(spatial_mechanism(spec)->swings(), swings(follower));
        EXPECT_FALSE(spatial_mechanism(spec)->planar());
    }
    MechanismSpec other;
    other.type = "remote";
    EXPECT_THROW((void)spatial_mechanism(other), InputError);
    other.type = "cylindrical";
    EXPECT_THROW((void)spatial_mechanism(other), InputError);
}

}  // namespace
}  // namespace camopt

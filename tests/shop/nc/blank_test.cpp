// SPDX-License-Identifier: MIT
// How far a cutter is from the blank: never more than it is, and no less where a face or a side decides.
#include "shop/nc/blank.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace camopt {
namespace blank_test {

const Blank drum{0.050, -0.020, 0.040};

/// The least distance of many points of the blank from the cutter: never less than the true one.
double sampled_distance(const ToolPose& pose, double radius) {
    double least = HUGE_VAL;
    const int rings = 24, angles = 180, heights = 25;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < angles; ++j)
            for (int k = 0; k <= heights; ++k) {
                if (i < rings && k > 0 && k < heights) continue;  // its surface is enough
                const double r = drum.radius * i / rings, a = 2.0 * std::numbers::pi * j / angles;
                const Eigen::Vector3d point(r * std::cos(a), r * std::sin(a),
                                            drum.lower + (drum.upper - drum.lower) * k / heights);
                const Eigen::Vector3d from = point - pose.tip;
                const double along = -from.dot(pose.axis);
                const double beside = std::max((from + along * pose.axis).norm() - radius, 0.0);
                least = std::min(least, std::hypot(beside, std::min(along, 0.0)));
            }
    return least;
}

TEST(BlankDistance, IsTightLowerBound) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int apart = 0;
    for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d axis =
            Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
        const ToolPose pose{0.08 * Eigen::Vector3d(normal(random), normal(random), normal(random)), axis};
        const double radius = 0.006, found = distance_to_blank(drum, pose, radius);
        const double sampled = sampled_distance(pose, radius);
        EXPECT_LE(found, sampled + 1e-9) << i;
        if (sampled < 0.004) continue;  // the samples' own spacing
        ++apart;
        EXPECT_GT(found, sampled - 0.003) << i;
    }
    EXPECT_GT(apart, 50);
}

TEST(BlankDistance, FacesAndSidesAreExact) {
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(distance_to_blank(drum, {{0.01, 0.02, 0.047}, down}, 0.006), 0.007, 1e-15);
    EXPECT_NEAR(distance_to_blank(drum, {{0.09, 0.0, -0.03}, down}, 0.006), 0.034, 1e-15);
    EXPECT_NEAR(distance_to_blank(drum, {{0.0, 0.052, 0.0}, -Eigen::Vector3d::UnitY()}, 0.006), 0.002, 1e-15);
    EXPECT_LE(distance_to_blank(drum, {{0.0, 0.049, 0.0}, -Eigen::Vector3d::UnitY()}, 0.006), 0.0);
    // From below through the whole blank: the cutter's shank is a cutter too.
    EXPECT_LE(distance_to_blank(drum, {{0.0, 0.0, -0.1}, down}, 0.006), 0.0);
}

TEST(Blank, HeightAtAnyTableAngle) {
    EXPECT_DOUBLE_EQ(greatest_height(drum, *plane_milling_machine()), 0.040);
    EXPECT_DOUBLE_EQ(greatest_height(drum, *rotary_table_machine()), 0.050);
    const auto five = table_tilting_machine(0.12);
    EXPECT_NEAR(greatest_height(drum, *five), std::hypot(0.050, 0.040), 1e-15);
    EXPECT_NEAR(greatest_height(drum, *five), drum.reach(), 1e-15);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> angle(-4.0, 4.0);
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Vector3d up =
            -five->pose(Eigen::Vector<double, 5>{0, 0, 0, angle(random), angle(random)}).axis;
        EXPECT_LE(drum.support(up), greatest_height(drum, *five) + 1e-15);
    }
}

TEST(Blank, RefusesWhatIsNone) {
    for (const Blank& wrong : {Blank{}, Blank{-1.0, 0.0, 1.0}, Blank{1.0, 1.0, 0.0}, Blank{1.0, NAN, 1.0}})
        EXPECT_THROW(wrong.validate(), InputError);
    const Blank chosen = chosen_blank(drum, {0.06, {}, 0.05, 0.001});
    EXPECT_EQ(chosen.radius, 0.06);
    EXPECT_EQ(chosen.lower, drum.lower);
    EXPECT_EQ(chosen.upper, 0.05);
    EXPECT_THROW(static_cast<void>(chosen_blank(drum, {{}, {}, {}, -1e-3})), InputError);
    EXPECT_THROW(static_cast<void>(chosen_blank(drum, {{}, 0.05, {}, 0.0})), InputError);
}

}  // namespace blank_test
}  // namespace camopt

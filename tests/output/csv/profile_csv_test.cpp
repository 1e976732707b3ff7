// SPDX-License-Identifier: MIT
#include "output/csv/profile_csv.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace {

using testing_support::refusal;

/// The cells of a line; empty ones are NaN.
std::vector<double> numbers(const std::string& line) {
    std::vector<double> values;
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');)
        values.push_back(cell.empty() ? NAN : std::stod(cell));
    return values;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

struct Sample {
    std::vector<ProfilePoint> points;
    std::vector<double> displacements;
};

Sample sample(FollowerType follower) {
    const MotionChain motion = test::turn_motion("modified_sine");
    const MotionScale scale = test::sample_scale(follower);
    Sample result{sampled_profile(test::sample_cam(follower), motion, scale, {90, 1e-6}), {}};
    for (const ProfilePoint& point : result.points)
        result.displacements.push_back(scale.lift * motion.at(point.theta).derivative[0]);
    return result;
}

TEST(ProfileCsv, ColumnsFollowTheFollower) {
    for (const FollowerType follower : test::all_followers) {
        const auto [points, displacements] = sample(follower);
        const auto lines = lines_of(profile_csv(points, displacements, follower_of(follower)));
        EXPECT_EQ(lines.size(), points.size() + 1);
        const std::string& header = lines.front();
        EXPECT_EQ(header.find("s_deg") != std::string::npos, is_oscillating(follower));
        EXPECT_EQ(header.find("contact_offset_mm") != std::string::npos, has_flat_face(follower));
        const auto columns = std::count(header.begin(), header.end(), ',');
        for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    }
}

TEST(ProfileCsv, RowsAgreeWithEachOther) {
    const auto follower = FollowerType::translating_roller;
    const auto [points, displacements] = sample(follower);
    const auto lines = lines_of(profile_csv(points, displacements, follower_of(follower)));
    const auto first = numbers(lines[1]), last = numbers(lines.back());
    EXPECT_EQ(first[0], 0.0);
    EXPECT_NEAR(last[0], 360.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[2], first[3]), 45.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[4], first[5]), 35.0, 1e-12);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto cells = numbers(lines[i]);
        EXPECT_NEAR(cells[2] - cells[4], 10.0 * cells[6], 1e-12);  // pitch − cam = roller radius · normal
        EXPECT_NEAR(cells[3] - cells[5], 10.0 * cells[7], 1e-12);
        EXPECT_EQ(cells[1], displacements[i - 1] / units::millimetre);
    }
}

TEST(ProfileCsv, AnInfiniteRadiusStaysEmpty) {
    auto [points, displacements] = sample(FollowerType::translating_knife);
    points.resize(1);
    displacements.resize(1);
    points[0].pitch_curvature = 0.0;
    points[0].cam_radius = HUGE_VAL;
    const auto cells = numbers(
        lines_of(profile_csv(points, displacements, follower_of(FollowerType::translating_knife)))[1]);
    EXPECT_TRUE(std::isnan(cells[9]));
    EXPECT_TRUE(std::isnan(cells[10]));
    EXPECT_EQ(cells[11], 1.0);
}

TEST(ProfileCsv, NeedsADisplacementForEveryPoint) {
    auto [points, displacements] = sample(FollowerType::translating_flat);
    displacements.pop_back();
    EXPECT_EQ(refusal([&] {
                  (void)profile_csv(points, displacements, follower_of(FollowerType::translating_flat));
              }),
              "profile.csv: 97 points and 96 displacements");
}

}  // namespace
}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv/motion_csv.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace profile_csv_test {

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

MechanismProfile sample(FollowerType follower) {
    return mechanism_profile(disk_mechanism(test::sample_cam(follower)), test::turn_motion("modified_sine"),
                             test::sample_scale(follower), 90);
}

ProfileColumns columns_of(FollowerType follower) {
    return {is_oscillating(follower), has_flat_face(follower), {}, {}};
}

TEST(ProfileCsv, ColumnsFollowTheFollower) {
    for (const FollowerType follower : test::all_followers) {
        const MechanismProfile profile = sample(follower);
        const auto lines = lines_of(profile_csv(profile, columns_of(follower)));
        EXPECT_EQ(lines.size(), profile.points.size() + 1);
        const std::string& header = lines.front();
        EXPECT_EQ(header.find("s_deg") != std::string::npos, is_oscillating(follower));
        EXPECT_EQ(header.find("contact_offset_mm") != std::string::npos, has_flat_face(follower));
        const auto columns = std::count(header.begin(), header.end(), ',');
        for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    }
}

TEST(ProfileCsv, RowsAgreeWithEachOther) {
    const auto follower = FollowerType::translating_roller;
    const MechanismProfile profile = sample(follower);
    const auto lines = lines_of(profile_csv(profile, columns_of(follower)));
    const auto first = numbers(lines[1]), last = numbers(lines.back());
    EXPECT_EQ(first[0], 0.0);
    EXPECT_NEAR(last[0], 360.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[2], first[3]), 45.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[4], first[5]), 35.0, 1e-12);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto cells = numbers(lines[i]);
        EXPECT_NEAR(cells[2] - cells[4], 10.0 * cells[6], 1e-12);  // pitch − cam = roller radius · normal
        EXPECT_NEAR(cells[3] - cells[5], 10.0 * cells[7], 1e-12);
        EXPECT_EQ(cells[1], profile.outputs[i - 1] / units::millimetre);
    }
}

TEST(ProfileCsv, AnInfiniteRadiusStaysEmpty) {
    MechanismProfile profile = sample(FollowerType::translating_knife);
    profile.points.resize(1);
    profile.outputs.resize(1);
    profile.points[0].pitch_curvature = 0.0;
    profile.points[0].cam_radius = HUGE_VAL;
    const auto cells =
        numbers(lines_of(profile_csv(profile, columns_of(FollowerType::translating_knife)))[1]);
    EXPECT_TRUE(std::isnan(cells[9]));
    EXPECT_TRUE(std::isnan(cells[10]));
    EXPECT_EQ(cells[11], 1.0);
}

TEST(ProfileCsv, NeedsADisplacementForEveryPoint) {
    MechanismProfile profile = sample(FollowerType::translating_flat);
    profile.outputs.pop_back();
    EXPECT_EQ(refusal([&] { (void)profile_csv(profile, columns_of(FollowerType::translating_flat)); }),
              "profile.csv: 97 points and 96 displacements");
}

}  // namespace profile_csv_test
}  // namespace camopt

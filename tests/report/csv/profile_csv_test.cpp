// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/csv/motion_csv.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/studies/cam_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace profile_csv_test {

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

/// A turn with the modified sine, without forces.
Solution sample(FollowerType follower) {
    Solution solution = test::cam_solution();
    solution.motion = std::make_shared<MotionChain>(test::turn_motion("modified_sine"));
    solution.scene.motion.type = MotionType::program;
    solution.scene.motion.segments.resize(1);
    solution.scene.motion.segments[0].angle = test::sample_scale(follower).unit_angle;
    solution.scene.motion.lift = test::sample_scale(follower).lift;
    solution.scene.motion.lift_is_angle = is_oscillating(follower);
    solution.cam->cam = disk_mechanism(test::sample_cam(follower));
    solution.cam->summary.forces.reset();
    return solution;
}

std::vector<DeliveredRow> rows_of(const View& view) {
    return profile_rows(view.solution, view.delivered, {.count = 90});
}

TEST(ProfileCsv, ColumnsFollowTheFollower) {
    for (const FollowerType follower : test::all_followers) {
        const Solution solution = sample(follower);
        const View view(solution);
        const auto rows = rows_of(view);
        const auto lines = lines_of(profile_csv(view, rows));
        EXPECT_EQ(lines.size(), rows.size() + 1);
        const std::string& header = lines.front();
        EXPECT_EQ(header.find("s_deg") != std::string::npos, is_oscillating(follower));
        EXPECT_EQ(header.find("contact_offset_mm") != std::string::npos, has_flat_face(follower));
        const auto columns = std::count(header.begin(), header.end(), ',');
        for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    }
}

TEST(ProfileCsv, RowsAgreeWithEachOther) {
    const Solution solution = sample(FollowerType::translating_roller);
    const View view(solution);
    const auto rows = rows_of(view);
    const auto lines = lines_of(profile_csv(view, rows));
    const auto first = numbers(lines[1]), last = numbers(lines.back());
    EXPECT_EQ(first[0], 0.0);
    EXPECT_NEAR(last[0], 360.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[2], first[3]), 45.0, 1e-12);
    EXPECT_NEAR(std::hypot(first[4], first[5]), 35.0, 1e-12);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto cells = numbers(lines[i]);
        EXPECT_NEAR(cells[2] - cells[4], 10.0 * cells[6], 1e-12);  // pitch − cam = roller radius · normal
        EXPECT_NEAR(cells[3] - cells[5], 10.0 * cells[7], 1e-12);
        EXPECT_NEAR(cells[1],
                    solution.scene.motion.lift * rows[i - 1].motion.derivative[0] / units::millimetre, 1e-12);
    }
}

TEST(ProfileCsv, AnInfiniteRadiusStaysEmpty) {
    const Solution solution = sample(FollowerType::translating_knife);
    const View view(solution);
    std::vector<DeliveredRow> rows = rows_of(view);
    rows.resize(1);
    rows[0].cam[0].pitch_curvature = 0.0;
    rows[0].cam[0].cam_radius = HUGE_VAL;
    const auto cells = numbers(lines_of(profile_csv(view, rows))[1]);
    EXPECT_TRUE(std::isnan(cells[9]));
    EXPECT_TRUE(std::isnan(cells[10]));
    EXPECT_EQ(cells[11], 1.0);
}

}  // namespace profile_csv_test
}  // namespace camopt

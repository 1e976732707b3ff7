// SPDX-License-Identifier: MIT
// The report of paper 003 against docs/theory/remote_follower.py: largest pressure angles by both
// definitions, verdicts, forward checks.
#include "benchmarks/papers/papers.hpp"
#include "benchmarks/papers/tappet_shedding.hpp"
#include "core/units.hpp"
#include "studies/check/forward_check_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace camopt {
namespace paper_003_test {

const PaperTable& table_of(const PaperReport& report, const std::string& key) {
    return *std::ranges::find(report.tables, key, &PaperTable::key);
}

double number(const PaperCell& cell) {
    return std::get<double>(cell);
}

TEST(Paper003, ReportsTheReferenceNumbersAndBothVerdicts) {
    const PaperReport report = paper_003();
    EXPECT_TRUE(report.faults.empty());
    const std::map<std::string, std::pair<double, double>> expected = {
        {"MT60", {28.4532918499, 36.7}},  {"MT75", {31.6169201862, 39.5}}, {"MT90", {35.5402136266, 43.0}},
        {"MT752", {29.0928975234, 37.1}}, {"4567-60", {31.1914337874, 0}}, {"4567-75", {34.4944331181, 0}},
        {"4567-752", {31.5612642976, 0}},
    };
    std::size_t seen = 0;
    for (const auto& row : table_of(report, "figure_8_extremes").rows) {
        const auto found = expected.find(std::get<std::string>(row[0]));
        if (found == expected.end()) continue;
        ++seen;
        EXPECT_NEAR(number(row[1]), found->second.first, 1e-10) << found->first;
        EXPECT_EQ(std::get<std::string>(row[3]), number(row[1]) <= 30.0 ? "within 30 deg" : "above 30 deg");
        if (found->second.second > 0) {
            EXPECT_NEAR(number(row[4]), found->second.second, 0.0501) << found->first;
        }
        const std::string paper = std::get<std::string>(row[7]);
        if (!paper.empty()) {
            EXPECT_EQ(paper == "satisfactory", number(row[1]) <= 30.0) << found->first;
        }
    }
    EXPECT_EQ(seen, expected.size());
    for (const auto& row : table_of(report, "optimized").rows) EXPECT_LE(number(row[2]), 30.0 + 1e-7);
    EXPECT_TRUE(std::ranges::find(report.figures, "figure_7", &PaperFigure::key)->equal_scales)
        << "a profile";
    EXPECT_FALSE(report.assumptions.empty());
    EXPECT_NE(report.notes.front().find("EVIDENCE VALUE LOW"), std::string::npos);
}

TEST(Paper003, ForwardCheckFindsFrameFromPoints) {
    // A polygon's, MT60: 2.9e-6, 5.9e-9, 1.8e-11 mm; ours goes through the points with a smoother curve.
    const CamSpec spec = tappet_spec(false);
    const DrivenMechanism mechanism{std::make_shared<RemoteCam>(spec), spec.middle()};
    const MotionChain motion = tappet_motion("modified_trapezoid", 60);
    const std::pair<int, double> rows[] = {{360, 2.9e-9}, {1440, 5.9e-12}, {6000, 1e-12}};
    for (const auto& [points, most] : rows) {
        const ForwardCheckResult result =
            forward_check(forward_check_input(mechanism, motion, tappet_scale(), points));
        EXPECT_LE(result.deviation, most) << points;
    }
}

TEST(Paper003, ForwardCheckIgnoresFrameOrigin) {
    CamSpec spec = tappet_spec(true);
    using enum RemoteDimension;
    const std::initializer_list<std::pair<RemoteDimension, double>> moved = {
        {lever_pivot_x, 40}, {center_x, 40}, {rocker_pivot_x, 40}, {slider_x, 40},
        {lever_pivot_y, 25}, {center_y, 25}, {rocker_pivot_y, 25}, {slider_y, 25}};
    for (const auto& [which, by] : moved) {
        Dimension& dimension = spec.dimensions[static_cast<std::size_t>(which)].value;
        dimension.low = dimension.high = dimension.low + by * units::millimetre;
    }
    const DrivenMechanism mechanism{std::make_shared<RemoteCam>(spec), spec.middle()};
    const MotionChain motion = tappet_motion("modified_trapezoid", 60);
    EXPECT_LE(forward_check(forward_check_input(mechanism, motion, tappet_scale(), 1440)).deviation, 1e-11);
}

TEST(Paper003, ForwardCheckRejectsOtherCam) {
    const CamSpec spec = tappet_spec(false);
    const DrivenMechanism mechanism{std::make_shared<RemoteCam>(spec), spec.middle()};
    const MotionChain motion = tappet_motion("modified_trapezoid", 60);
    ForwardCheckInput input = forward_check_input(mechanism, motion, tappet_scale(), 1440);
    for (Eigen::Vector2d& point : input.points) point *= 1.001;  // 0.035 mm at the least radius
    EXPECT_GT(forward_check(input).deviation, 1e-5);
}

}  // namespace paper_003_test
}  // namespace camopt

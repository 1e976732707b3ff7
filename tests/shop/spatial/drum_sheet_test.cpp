// SPDX-License-Identifier: MIT
// The workshop drawing of a drum: what it measures is the drum, and its lines stay on the body.
#include "shop/spatial/drum_sheet.hpp"

#include "report/spatial/flank_surfaces.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/spatial/spatial_forward_check.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace drum_sheet_test {

/// A slide that goes and returns by laws, on a drum of its own size.
const std::string slide = R"(
[motion]
type = "program"
lift_mm = 30
segments = [
  { kind = "dwell", angle_deg = 40 },
  { kind = "law", law = "cycloidal", angle_deg = 120, to = 1.0 },
  { kind = "dwell", angle_deg = 60 },
  { kind = "law", law = "cycloidal", angle_deg = 140, to = 0.0 },
]
[cam]
type = "cylindrical"
follower = "translating"
roller_radius_mm = 9
roller_length_mm = 12
cylinder_radius_mm = 50
groove_clearance_mm = 0.1
body_diameter_mm = 96
body_length_mm = 80
)";

const std::string index = R"(
[motion]
type = "program"
closed = "relative"
lift_deg = 45
segments = [
  { kind = "law", law = "cycloidal", angle_deg = 180, to = 1.0 },
  { kind = "dwell", angle_deg = 180 },
]
[cam]
type = "cylindrical"
follower = "rotating"
roller_radius_mm = 8
roller_length_mm = 20
arm_length_mm = 70
center_distance_mm = 150
)";

struct Drawn {
    Solution solution;
    Sheet sheet;
};

Drawn drawn(const std::string& text, const DrawingSpec& drawing = {}) {
    Drawn made{solve(testing_support::TestScene(text)), {}};
    const MotionChain turn = whole_turn(made.solution);
    made.sheet = drum_sheet(made.solution, solved_flanks(made.solution),
                            follower_motion(turn, motion_scale(made.solution.scene)), drawing);
    return made;
}

bool measures(const Sheet& sheet, double length) {
    return std::ranges::any_of(sheet.dimensions, [&](const DrawnDimension& dimension) {
        return std::abs(dimension.measured() - length) < 1e-7;
    });
}

/// The vertices of the lines of a style.
std::vector<Eigen::Vector2d> points_of(const Sheet& sheet, const std::string& style) {
    std::vector<Eigen::Vector2d> points;
    for (const DrawnElement& element : sheet.drawing.elements)
        if (const auto* const path = std::get_if<DrawnPath>(&element);
            path != nullptr && path->style == style)
            for (const ArcVertex& vertex : path->vertices) points.push_back(vertex.position);
    return points;
}

bool says(const Sheet& sheet, const std::string& words) {
    return std::ranges::any_of(sheet.drawing.elements, [&](const DrawnElement& element) {
        const auto* const text = std::get_if<DrawnText>(&element);
        return text != nullptr && text->words.find(words) != std::string::npos;
    });
}

TEST(DrumSheet, MeasuresBodyStrokeAndGroove) {
    DrawingSpec drawing;
    drawing.bore = 25e-3;
    const Sheet sheet = drawn(slide, drawing).sheet;
    const double around = std::numbers::pi * 96e-3;
    for (const double length : {around, 96e-3, 80e-3, 30e-3, 25e-3, 18.1e-3})
        EXPECT_TRUE(measures(sheet, length)) << length;
    // From the lower end to the axis at the start: the groove lies in the middle of the body.
    EXPECT_TRUE(measures(sheet, 25e-3));
    // 48 − (50 − 12): the depth of the groove in the body.
    EXPECT_TRUE(measures(sheet, 10e-3));
    EXPECT_TRUE(says(sheet, "18.1 wide, for a roller ⌀18 × 12, clearance 0.1"));
    EXPECT_FALSE(says(sheet, "OPEN"));
}

TEST(DrumSheet, EdgesLieOnTheOutside) {
    const Sheet sheet = drawn(slide).sheet;
    const std::vector<Eigen::Vector2d> edges = points_of(sheet, "cam");
    const double around = std::numbers::pi * 96e-3;
    double low = 1.0, high = 0.0;
    for (const Eigen::Vector2d& point : edges) {
        EXPECT_GE(point.x(), -1e-9);
        EXPECT_LE(point.x(), around + 1e-9);
        if (point.x() > 0.03 * around && point.x() < 0.08 * around) {  // in the dwell
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    }
    EXPECT_NEAR(low, 25e-3 - 9.05e-3, 1e-9);
    EXPECT_NEAR(high, 25e-3 + 9.05e-3, 1e-9);
}

TEST(DrumSheet, DatumMovesTheAngles) {
    DrawingSpec drawing;
    drawing.datum = 160.0 * units::degree;  // where the upper dwell begins
    const Sheet sheet = drawn(slide, drawing).sheet;
    EXPECT_TRUE(says(sheet, "55.000"));
    const std::vector<Eigen::Vector2d> way = points_of(sheet, "pitch");
    for (const Eigen::Vector2d& point : way)
        if (point.x() < 0.16 * std::numbers::pi * 96e-3) {
            EXPECT_NEAR(point.y(), 55e-3, 1e-9);
        }
}

TEST(DrumSheet, IndexShowsEveryRoller) {
    const Drawn made = drawn(index);
    const Sheet& sheet = made.sheet;
    EXPECT_TRUE(says(sheet, "Body as turned before the grooves of all rollers are milled"));
    int edges = 0;
    for (const DrawnElement& element : sheet.drawing.elements)
        if (const auto* const path = std::get_if<DrawnPath>(&element);
            path != nullptr && path->style == "cam")
            ++edges;
    EXPECT_GT(edges, 4);
    double length = 0.0;
    for (const DrawnDimension& dimension : sheet.dimensions)
        if (dimension.first.x() == 0.0 && dimension.second.x() == 0.0)
            length = std::max(length, dimension.measured());
    for (const Eigen::Vector2d& point : points_of(sheet, "cam")) {
        EXPECT_GE(point.y(), -1e-9);
        EXPECT_LE(point.y(), length + 1e-9);
    }
}

TEST(DrumSheet, SolidHasTheGivenSize) {
    const Drawn made = drawn(slide);
    const MotionChain turn = whole_turn(made.solution);
    const FollowerMotion motion = follower_motion(turn, motion_scale(made.solution.scene));
    const TriangleMesh solid = drum_solid(solved_flanks(made.solution), motion, {5, 181, 0.0, 0.0});
    double radius = 0.0, lower = 1.0, upper = -1.0;
    for (const Eigen::Vector3d& vertex : solid.vertices) {
        radius = std::max(radius, vertex.head<2>().norm());
        lower = std::min(lower, vertex.z());
        upper = std::max(upper, vertex.z());
    }
    EXPECT_NEAR(radius, 48e-3, 1e-9);
    EXPECT_NEAR(upper - lower, 80e-3, 1e-9);
}

TEST(DrumSheet, BoreBeyondTheFloorIsRefused) {
    DrawingSpec drawing;
    drawing.bore = 77e-3;
    EXPECT_THROW((void)drawn(slide, drawing), InputError);
}

}  // namespace drum_sheet_test
}  // namespace camopt

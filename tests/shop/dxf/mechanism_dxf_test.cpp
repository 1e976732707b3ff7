// SPDX-License-Identifier: MIT
// The drawings of remote and inverse cams, read back by the tests' own small reader and held against exact
// points between their knots.
#include "core/errors.hpp"
#include "report/folders/result_folder.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/solve/solve.hpp"
#include "tests/shop/dxf/dxf_text.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace mechanism_dxf_test {

using testing_support::refusal;

constexpr double millimetre = 1e-3;
constexpr int places = 4001;

Solution solved(const std::string& name) {
    return solve(testing_support::scene_named(name).with("solver.starts=1"));
}

std::vector<test::DxfPolyline> on_layer(const std::string& text, const std::string& layer) {
    std::vector<test::DxfPolyline> found = test::dxf_polylines(text);
    std::erase_if(found, [&](const test::DxfPolyline& line) { return line.layer != layer; });
    return found;
}

/// From exact points of a station to the polyline, m; the last bit before either end is left out.
double largest_distance(const Solution& solution, int station, bool of_cam, const test::DxfPolyline& line) {
    const MechanismProfile profile = mechanism_profile(solution.cam->cam, cam_motion(solution),
                                                       motion_scale(solution.scene), places, station);
    double largest = 0.0;
    for (std::size_t i = 3; i + 3 < profile.points.size(); ++i) {
        const MechanismPoint& point = profile.points[i];
        const Eigen::Vector2d place = (of_cam ? point.contact : point.pitch).head<2>();
        largest = std::max(largest, millimetre * line.distance(place / millimetre));
    }
    return largest;
}

TEST(MechanismDxf, RemoteCamIsOneClosedOutline) {
    const Solution solution = solved("tappet_75");
    ASSERT_NE(solution.cam->cam.formulas->plane(), nullptr);
    const ProfileDxf dxf = cam_dxf(solution);
    const auto outlines = on_layer(dxf.text, "CAM"), pitches = on_layer(dxf.text, "PITCH");
    ASSERT_EQ(outlines.size(), 1U);
    ASSERT_EQ(pitches.size(), 1U);
    EXPECT_TRUE(outlines[0].closed);
    EXPECT_EQ(static_cast<int>(outlines[0].arcs.size()), dxf.arcs);
    EXPECT_LE(dxf.deviation, 1e-6);
    EXPECT_LE(largest_distance(solution, 0, true, outlines[0]), 1.02e-6);
    EXPECT_LE(largest_distance(solution, 0, false, pitches[0]), 1.02e-6);
}

TEST(MechanismDxf, AGuideHasBothWalls) {
    const Solution solution = solved("inverse_feeder");
    const ProfileDxf dxf = cam_dxf(solution);
    const auto walls = on_layer(dxf.text, "WALLS"), middle = on_layer(dxf.text, "PITCH");
    ASSERT_EQ(walls.size(), 2U);
    ASSERT_EQ(middle.size(), 1U);
    for (int wall = 0; wall < 2; ++wall) {
        EXPECT_FALSE(walls[static_cast<std::size_t>(wall)].closed);
        EXPECT_LE(largest_distance(solution, wall, true, walls[static_cast<std::size_t>(wall)]), 1.02e-6);
    }
    EXPECT_LE(largest_distance(solution, 0, false, middle[0]), 1.02e-6);
}

TEST(MechanismDxf, ADrumIsRefused) {
    const Solution solution = solved("cylinder_slide");
    EXPECT_EQ(solution.cam->cam.formulas->plane(), nullptr);
    EXPECT_EQ(refusal([&] { (void)cam_dxf(solution); }),
              "a drawing needs the cam of a plane mechanism, and this solution has none");
}

}  // namespace mechanism_dxf_test
}  // namespace camopt

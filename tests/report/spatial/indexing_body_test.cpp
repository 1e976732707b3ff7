// SPDX-License-Identifier: MIT
// The body of an indexing cam: one solid, its groove is what all rollers take out of it.
#include "report/spatial/indexing_body.hpp"

#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "tests/report/surface/mesh_edges.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {
namespace indexing_body_test {

using testing_support::refusal;

std::vector<std::pair<SpatialCam, FollowerMotion>> cams() {
    return {{test::barrel_cam(), test::barrel_motion()}, {test::rotating_cam(), test::rotating_motion()}};
}

TEST(IndexingBody, IsOneSolid) {
    for (const auto& [cam, motion] : cams()) {
        const TriangleMesh body = indexing_body(cam, motion, {360, 6});
        EXPECT_TRUE(mesh_edges(body).watertight());
        EXPECT_GT(volume(body), 0.0);
        EXPECT_TRUE(mesh_edges(holding_rollers(cam, motion)).watertight());
    }
}

// The volume of the turned body less that of the ways of all rollers, by points spread evenly (Halton): as
// the mesh says, within what so many points can tell.
TEST(IndexingBody, HoldsWhatRollersLeave) {
    const SpatialCam cam = test::rotating_cam();
    const FollowerMotion motion = test::rotating_motion();
    const TriangleMesh body = indexing_body(cam, motion, {360, 6});
    const IndexingGroove groove(cam, motion, cam.roller_length + floor_clearance);
    double bore = HUGE_VAL, most = 0.0;
    for (const Eigen::Vector3d& vertex : body.vertices) {
        bore = std::min(bore, vertex.head<2>().norm());
        most = std::max(most, vertex.head<2>().norm());
    }
    std::vector<RollerAxis> rollers;
    for (double phi = groove.path().begin(); phi < groove.path().end(); phi += 0.01)
        rollers.push_back(roller_axis(cam, phi, groove.path().state(phi).s));
    const auto is_taken = [&](const Eigen::Vector3d& point) {
        return std::ranges::any_of(rollers, [&](const RollerAxis& axis) {
            const double along = (point - axis.foot).dot(axis.direction);
            return along < groove.floor() &&
                   (point - axis.foot - along * axis.direction).norm() < cam[SpatialDimension::roller_radius];
        });
    };
    const auto halton = [](int index, int base) {
        double value = 0.0, part = 1.0;
        for (; index > 0; index /= base) value += (part /= base) * (index % base);
        return value;
    };
    const int count = 20000;
    int held = 0;
    for (int i = 1; i <= count; ++i) {
        const double rho = std::sqrt(bore * bore + (most * most - bore * bore) * halton(i, 2));
        const double polar = test::full_turn * halton(i, 3);
        const double z = groove.lower() + (groove.upper() - groove.lower()) * halton(i, 5);
        const Eigen::Vector3d point(rho * std::cos(polar), rho * std::sin(polar), z);
        held += groove.depth(point) > 0.0 && !is_taken(point) ? 1 : 0;
    }
    const double whole = std::numbers::pi * (most * most - bore * bore) * (groove.upper() - groove.lower());
    EXPECT_NEAR(volume(body), whole * held / count, 0.003 * whole);
}

// In the dwell the rib of the paper-cup machine fills the gap between two rollers at ±180°/7:
// 2 r_i sin(π/7) − 2 r along the cam's axis.
TEST(IndexingBody, RibFillsGapBetweenRollers) {
    const SpatialCam cam = test::barrel_cam();
    const IndexingGroove groove(cam, test::barrel_motion(), cam.roller_length + floor_clearance);
    const double gap = 2.0 * 0.164 * std::sin(std::numbers::pi / 7.0) - 2.0 * 0.03175;
    const double theta = 100.0 * test::degree;
    EXPECT_NEAR(std::abs(groove.contact(theta, 4.5).z() - groove.contact(theta + test::full_turn, 0.5).z()),
                gap, 1e-9);
    EXPECT_NEAR(gap, 0.0788136, 1e-6);
}

// No roller of the index enters the body, wherever the cam stands: beyond what a chord may.
TEST(IndexingBody, RollersDoNotEnterIt) {
    for (const auto& [cam, motion] : cams()) {
        const TriangleMesh body = indexing_body(cam, motion, {360, 6});
        const IndexingGroove groove(cam, motion, cam.roller_length + floor_clearance);
        double deepest = 0.0;
        for (double phi = groove.path().begin(); phi < groove.path().end(); phi += 0.02) {
            const RollerAxis axis = roller_axis(cam, phi, groove.path().state(phi).s);
            for (std::size_t i = 0; i < body.vertices.size(); i += 7) {
                const Eigen::Vector3d from = body.vertices[i] - axis.foot;
                const double along = from.dot(axis.direction);
                const double beside = (from - along * axis.direction).norm();
                deepest = std::max(deepest, std::min(cam[SpatialDimension::roller_radius] - beside,
                                                     cam.roller_length + floor_clearance - along));
            }
        }
        EXPECT_LT(deepest, 2e-4);  // in the ends, which are cut off along chords
    }
}

TEST(IndexingBody, RefusesMotionsThatDoNotIndex) {
    FollowerMotion half = test::barrel_motion();
    half.breakpoints.back() = 3.0;
    EXPECT_EQ(refusal([&] { (void)indexing_body(test::barrel_cam(), half); }),
              "indexing cam: the motion must take one turn, it takes 171.887 deg");
    FollowerMotion rest = test::barrel_motion();
    rest.state = [](double) { return FollowerState{}; };
    EXPECT_EQ(refusal([&] { (void)indexing_body(test::barrel_cam(), rest); }),
              "indexing cam: the motion must end one pitch from where it begins");
    EXPECT_EQ(refusal([&] {
                  (void)indexing_body(test::barrel_cam(), test::barrel_motion(), {4, 5});
              }),
              "indexing body: angles must be >= 16, found 4");
    EXPECT_FALSE(drawn_indexing_body(test::barrel_cam(), rest, {}));
}

}  // namespace indexing_body_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "tests/shop/dxf/dxf_text.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>

namespace camopt {
namespace profile_dxf_test {

using testing_support::refusal;

using units::millimetre;

const test::DxfPolyline& on_layer(const std::vector<test::DxfPolyline>& lines, const std::string& layer) {
    return *std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.layer == layer; });
}

/// The largest distance from points of the true curve to the polyline, m.
template <class Point>
double largest_distance(const ProfileShape& shape, const test::DxfPolyline& line, Point point) {
    double worst = 0.0;
    constexpr int count = 4001;
    for (int i = 0; i < count; ++i) {
        const double theta = shape.begin() + (shape.end() - shape.begin()) * i / count;
        worst = std::max(worst, line.distance(point(shape.at(theta)) / millimetre));
    }
    return worst * millimetre;
}

TEST(ProfileDxf, ArcsStayWithinTolerance) {
    for (const std::string law : {"polynomial_4567", "modified_sine"})
        for (const FollowerType follower : test::all_followers)
            for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
                const MotionChain motion = test::turn_motion(law);
                const ProfileShape shape = profile_shape(disk_mechanism(test::sample_cam(follower, rotation)),
                                                         motion, test::sample_scale(follower));
                ASSERT_TRUE(shape.closed);
                const ProfileDxf dxf = profile_dxf(shape);
                const auto lines = test::dxf_polylines(dxf.text);
                const test::DxfPolyline& outline = on_layer(lines, "CAM");
                EXPECT_TRUE(outline.closed);
                EXPECT_EQ(static_cast<int>(outline.arcs.size()), dxf.arcs);
                EXPECT_LE(dxf.deviation, 1e-6);
                const double found = largest_distance(
                    shape, outline, [](const MechanismPoint& point) { return in_plane(point.contact); });
                EXPECT_LE(found, 1e-6);
                EXPECT_NEAR(found, dxf.deviation, 5e-8);
                EXPECT_EQ(lines.size(), has_roller(follower) ? 2U : 1U);
                if (has_roller(follower)) {
                    EXPECT_LE(
                        largest_distance(shape, on_layer(lines, "PITCH"),
                                         [](const MechanismPoint& point) { return in_plane(point.pitch); }),
                        1e-6);
                }
                std::printf("[ dxf      ] %-19s %-16s %-16s %4d arcs, deviation %.3f um, read back %.3f um\n",
                            name_of(follower), law.c_str(), name_of(rotation), dxf.arcs, 1e6 * dxf.deviation,
                            1e6 * found);
            }
}

TEST(ProfileDxf, HandlesAreUniqueBelowSeed) {
    const MotionChain motion = test::turn_motion("modified_sine");
    const auto follower = FollowerType::oscillating_flat;
    const ProfileDxf dxf = profile_dxf(
        profile_shape(disk_mechanism(test::sample_cam(follower)), motion, test::sample_scale(follower)));
    std::set<long> handles;
    long seed = 0;
    bool in_header = true, seed_follows = false;
    for (const test::DxfTag& tag : test::dxf_tags(dxf.text)) {
        if (tag.value == "ENDSEC") in_header = false;
        if (in_header && seed_follows) seed = std::stol(tag.value, nullptr, 16);
        seed_follows = tag.value == "$HANDSEED";
        if (!in_header && (tag.code == 5 || tag.code == 105)) {
            EXPECT_TRUE(handles.insert(std::stol(tag.value, nullptr, 16)).second) << tag.value;
        }
    }
    EXPECT_GT(handles.size(), 40U);
    EXPECT_LT(*handles.rbegin(), seed);
    EXPECT_TRUE(dxf.text.ends_with("  0\nEOF\n"));
}

TEST(ProfileDxf, UndercutCamShowsLoops) {
    DiskCam cam = test::sample_cam(FollowerType::translating_roller);
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] = 39 * millimetre;
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 6 * millimetre;
    const MotionChain motion = test::turn_motion("polynomial_4567");
    const ProfileShape shape = profile_shape(disk_mechanism(cam), motion, test::sample_scale(cam.follower));
    EXPECT_GE(cusp_angles(shape).size(), 2U);
    const ProfileDxf dxf = profile_dxf(shape);
    EXPECT_LE(dxf.deviation, 1e-6);
    EXPECT_LT(dxf.arcs, 2000);
}

TEST(ProfileDxf, SectorIsOpenWithPositiveTolerance) {
    const auto law = test::turn_motion("modified_sine");
    ProfileShape shape = profile_shape(disk_mechanism(test::sample_cam(FollowerType::translating_flat)), law,
                                       test::sample_scale(FollowerType::translating_flat));
    shape.knots = {shape.knots[1], shape.knots[2]};
    shape.closed = false;
    const ProfileDxf dxf = profile_dxf(shape);
    EXPECT_FALSE(test::dxf_polylines(dxf.text).front().closed);
    EXPECT_EQ(refusal([&] { (void)profile_dxf(shape, 0.0); }),
              "the tolerance of an arc chain is 0, it must be > 0");
}

}  // namespace profile_dxf_test
}  // namespace camopt

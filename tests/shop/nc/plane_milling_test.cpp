// SPDX-License-Identifier: MIT
// A disk cam milled on three axes, a cylindrical cam on four.
#include "profiles/disk/disk_cam.hpp"
#include "shop/nc/machine.hpp"
#include "shop/nc/nc_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace plane_milling_test {

using test::degree;
using test::millimetre;

ProfilePoint disk_point(double theta) {
    DiskCam cam;
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 40.0 * millimetre;
    cam.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] = 10.0 * millimetre;
    const double lift = 10.0 * millimetre;  // a harmonic: 1 - cos
    return profile_point(cam, theta,
                         {lift * (1.0 - std::cos(theta)), lift * std::sin(theta), lift * std::cos(theta)});
}

std::vector<Eigen::Vector3d> disk_surface(double height, int count) {
    std::vector<Eigen::Vector3d> points;
    for (const double theta : test::even(0.0, test::full_turn, count)) {
        const Eigen::Vector2d contact = disk_point(theta).contact;
        points.emplace_back(contact.x(), contact.y(), height);
    }
    return points;
}

TEST(PlaneMilling, MillsDiskCam) {
    const auto machine = plane_milling_machine();
    const PlaneCutter cutter{16.0 * millimetre, 0.0, -22.0 * millimetre};
    const ToolPath path = plane_cutter_path(
        [](double theta) {
            const ProfilePoint point = disk_point(theta);
            return ContourPoint{point.contact, point.normal};
        },
        cutter);
    const double tolerance = 2e-6;
    const std::vector<double> turn{0.0, test::full_turn};
    const BlockAngles blocks = block_angles(path, *machine, turn, {std::nullopt, tolerance, 0.0});
    EXPECT_LE(blocks.chord_deviation, tolerance);
    const std::vector<ToolPose> poses = test::poses_at(path, blocks.theta);
    for (const FeedMode mode : {FeedMode::inverse_time, FeedMode::per_minute}) {
        PostProcessor post = generic_post(*machine);
        post.feed_mode = mode;
        const NcProgram program = nc_program(*machine, post, test::job_of(poses));
        const auto moves = read_nc_text(program.text, *machine, post);
        const NcPoseCheck check = check_poses(moves, *machine, post, poses);
        EXPECT_TRUE(check.within_rounding);
        EXPECT_LT(check.tip_deviation, 0.5e-4 * std::sqrt(3.0) * 1.001 * millimetre);
        const NcSurfaceCheck surface = check_surface(moves, *machine, {cutter.diameter, 30.0 * millimetre},
                                                     disk_surface(-10.0 * millimetre, 500));
        EXPECT_LT(surface.gouge, tolerance + check.tip_rounding);
        EXPECT_LT(surface.stock, tolerance + check.tip_rounding);
        EXPECT_GT(surface.gouge, 0.3 * tolerance);  // chords of a convex cam's offset cut into it
    }
}

TEST(PlaneMilling, LargeCutterInHollowIsFound) {
    const auto machine = plane_milling_machine();
    const auto contour = [](double theta) {  // a cam with hollows of 21.6 mm radius
        const double r = 50.0 * millimetre, wave = 4.0 * millimetre;
        const double radius = r + wave * std::cos(6.0 * theta), slope = -6.0 * wave * std::sin(6.0 * theta);
        const Eigen::Vector2d out(std::cos(theta), std::sin(theta)), along(-out.y(), out.x());
        return ContourPoint{radius * out, (radius * out - slope * along).normalized()};
    };
    std::vector<Eigen::Vector3d> points;
    for (const double theta : test::even(0.0, test::full_turn, 720)) {
        const Eigen::Vector2d p = contour(theta).position;
        points.emplace_back(p.x(), p.y(), 0.0);
    }
    // Hollow where r is least: 1/κ = r² / |r² − r r''| there, with r = 46, r'' = 144 mm.
    const double hollow = 46.0 * 46.0 / (46.0 * (144.0 - 46.0)) * 46.0 * millimetre;
    for (const double share : {0.9, 1.5}) {
        const PlaneCutter cutter{2.0 * share * hollow, 0.0, -5.0 * millimetre};
        const auto poses =
            test::poses_at(plane_cutter_path(contour, cutter), test::even(0.0, test::full_turn, 2000));
        const PostProcessor post = test::fine_post(*machine);
        const auto moves = read_nc_text(nc_program(*machine, post, test::job_of(poses)).text, *machine, post);
        const NcSurfaceCheck check =
            check_surface(moves, *machine, {cutter.diameter, 20.0 * millimetre}, points);
        if (share < 1.0)
            EXPECT_LT(check.gouge, 2e-6);
        else
            EXPECT_GT(check.gouge, 1e-4);
    }
}

TEST(RotaryTable, CylindricalCamWithBothCutters) {
    const auto machine = rotary_table_machine();
    const RollerPath roller = roller_path(test::translating_cam(), test::translating_motion());
    const double radius = 10.0 * millimetre;
    for (const double diameter : {2.0 * radius, 1.5 * radius})
        for (const int flank : {1, -1}) {
            CutterLocation location;
            location.roller_radius = radius;
            location.diameter = diameter;
            location.flank = flank;
            location.station = 7.5 * millimetre;
            location.tip_beyond = 8.0 * millimetre;
            const ToolPath path = cutter_path(roller, location);
            BlockOptions options;
            options.working_length = 20.0 * millimetre;
            const BlockAngles blocks =
                block_angles(path, *machine, test::translating_motion().breakpoints, options);
            const std::vector<ToolPose> poses = test::poses_at(path, blocks.theta);
            const PostProcessor post = generic_post(*machine);
            const auto moves =
                read_nc_text(nc_program(*machine, post, test::job_of(poses)).text, *machine, post);
            const NcPoseCheck check = check_poses(moves, *machine, post, poses);
            EXPECT_TRUE(check.within_rounding);
            std::vector<Eigen::Vector3d> points;
            for (const double theta : test::even(1.0 * degree, 359.0 * degree, 358)) {
                const RollerPose at = roller(theta, 7.5 * millimetre);
                points.push_back(at.center + flank * radius * at.normal);
            }
            const NcSurfaceCheck surface =
                check_surface(moves, *machine, {diameter, 30.0 * millimetre}, points);
            EXPECT_LT(surface.gouge, 1e-6 + check.tip_rounding);
            EXPECT_LT(surface.stock, 1e-6 + check.tip_rounding);
        }
}

}  // namespace plane_milling_test
}  // namespace camopt

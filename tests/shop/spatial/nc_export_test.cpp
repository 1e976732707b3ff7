// SPDX-License-Identifier: MIT
// Programs of the reference cams with what their check says.
#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "report/spatial/indexing_body.hpp"
#include "shop/spatial/cam_export.hpp"
#include "tests/shop/nc/nc_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace nc_export_test {

using testing_support::refusal;

using test::millimetre;

CheckedProgram exported(const SpatialCam& cam, const FollowerMotion& motion, const NcExportOptions& options) {
    const auto machine = machine_for(cam, options.z_offset);
    return checked_program(*machine, generic_post(*machine), nc_work(cam, motion, options));
}

TEST(NcExport, RollerSizedCutterIsBlockExact) {
    NcExportOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 5e-6;
    options.z_offset = 0.12;
    for (const auto& [cam, motion] : {std::pair{test::barrel_cam(), test::barrel_motion()},
                                      std::pair{test::rotating_cam(), test::rotating_motion()},
                                      std::pair{test::translating_cam(), test::translating_motion()}}) {
        const CheckedProgram result = exported(cam, motion, options);
        EXPECT_TRUE(result.poses.within_rounding);
        EXPECT_LE(result.chord_deviation, options.chord_tolerance);
        // Of an index the floor too.
        ASSERT_EQ(result.surfaces.size(), cam.follower == SpatialFollower::cylindrical_translating ? 5u : 6u);
        for (const SurfaceFinding& height : result.surfaces) {
            EXPECT_LT(height.check.gouge, options.chord_tolerance + result.poses.tip_rounding) << height.name;
            EXPECT_LT(height.check.stock, options.chord_tolerance + result.poses.tip_rounding) << height.name;
        }
        const std::string text = nc_check_text(result);
        EXPECT_NE(text.find("within the printed digits"), std::string::npos) << text;
        EXPECT_EQ(text.find("WRONG"), std::string::npos);
    }
}

TEST(NcExport, SmallerCutterLeavesPredictedStock) {
    NcExportOptions options;
    options.milling.full_depth = true;
    options.cutter_diameter = 10.0 * millimetre;
    const CheckedProgram result = exported(test::rotating_cam(), test::rotating_motion(), options);
    EXPECT_TRUE(result.poses.within_rounding);
    EXPECT_NE(result.program.text.find("(pass: flank +1)"), std::string::npos);
    EXPECT_NE(result.program.text.find("(pass: flank -1)"), std::string::npos);
    EXPECT_NEAR(result.surfaces.front().check.stock / millimetre, 0.069, 0.0015);
    for (const SurfaceFinding& height : result.surfaces)
        EXPECT_LT(height.check.gouge, options.chord_tolerance + result.poses.tip_rounding);
    EXPECT_LT(result.surfaces[4].check.stock, options.chord_tolerance + result.poses.tip_rounding);
}

TEST(NcExport, RefusesCutterLargerThanRoller) {
    NcExportOptions options;
    options.cutter_diameter = 64.0 * millimetre;
    EXPECT_EQ(refusal([&] { (void)exported(test::barrel_cam(), test::barrel_motion(), options); }),
              "cutter location: cutter radius + stock must not exceed the roller radius, or the other flank "
              "is cut away; m, found 0.032");
}

// The neighbour's groove in the dwell, and the ways in and out of every roller: a program of one roller over
// one turn leaves them.
TEST(NcExport, MillsAllGroovesOfAnIndex) {
    for (const auto& [cam, motion] : {std::pair{test::barrel_cam(), test::barrel_motion()},
                                      std::pair{test::rotating_cam(), test::rotating_motion()}}) {
        NcExportOptions options;
        options.chord_tolerance = 5e-6;
        options.z_offset = 0.12;
        options.milling.full_depth = true;
        const auto machine = machine_for(cam, options.z_offset);
        const PostProcessor post = generic_post(*machine);
        NcWork work = nc_work(cam, motion, options);
        const CheckedProgram whole = checked_program(*machine, post, work);
        EXPECT_EQ(whole.fault(), "");
        // Of the solid that STL files hold, without its ends, which are cut off along chords.
        const TriangleMesh body = indexing_body(cam, motion, {360, 6});
        const auto upper =
            std::ranges::max(body.vertices, {}, [](const Eigen::Vector3d& v) { return v.z(); }).z();
        std::vector<Eigen::Vector3d> points;
        for (std::size_t i = 0; i < body.vertices.size(); i += 61)
            if (std::abs(body.vertices[i].z()) < upper - 1e-6) points.push_back(body.vertices[i]);
        const NcSurfaceCheck left = check_surface(read_nc_text(whole.program.text, *machine, post), *machine,
                                                  work.task.cutter, points);
        EXPECT_LT(left.gouge, 5e-5);
        CuttingPass& pass = work.task.passes.front();
        pass.knots = motion.breakpoints;
        const std::string fault = checked_program(*machine, post, work).fault();
        EXPECT_NE(fault.find("the program leaves"), std::string::npos) << fault;
    }
}

}  // namespace nc_export_test
}  // namespace camopt

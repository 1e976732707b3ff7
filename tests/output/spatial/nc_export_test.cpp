// SPDX-License-Identifier: MIT
// Programs of the reference cams with what their check says.
#include "output/spatial/nc_export.hpp"

#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace nc_export_test {

using testing_support::refusal;

using test::millimetre;

CheckedProgram exported(const SpatialCam& cam, const FollowerMotion& motion, const NcExportOptions& options) {
    const auto machine = machine_for(cam, options.z_offset);
    return nc_export(cam, motion, *machine, generic_post(*machine), options);
}

TEST(NcExport, RollerEqualCutterIsAsExactAsItsBlocks) {
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
        ASSERT_EQ(result.surfaces.size(), 5u);
        for (const SurfaceFinding& height : result.surfaces) {
            EXPECT_LT(height.check.gouge, options.chord_tolerance + result.poses.tip_rounding) << height.name;
            EXPECT_LT(height.check.stock, options.chord_tolerance + result.poses.tip_rounding) << height.name;
        }
        const std::string text = nc_check_text(result);
        EXPECT_NE(text.find("within the printed digits"), std::string::npos) << text;
        EXPECT_EQ(text.find("WRONG"), std::string::npos);
    }
}

TEST(NcExport, SmallerCutterTakesTwoPassesAndLeavesWhatMechanismsSay) {
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
    EXPECT_LT(result.surfaces.back().check.stock, options.chord_tolerance + result.poses.tip_rounding);
}

TEST(NcExport, RefusesACutterLargerThanTheRoller) {
    NcExportOptions options;
    options.cutter_diameter = 64.0 * millimetre;
    EXPECT_EQ(refusal([&] { (void)exported(test::barrel_cam(), test::barrel_motion(), options); }),
              "cutter location: cutter radius + stock must not exceed the roller radius, or the other flank "
              "is cut away; m, found 0.032");
}

}  // namespace nc_export_test
}  // namespace camopt

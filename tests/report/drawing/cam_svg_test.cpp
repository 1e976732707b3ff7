// SPDX-License-Identifier: MIT
#include "report/drawing/cam_svg.hpp"

#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "report/chart/curve_chart.hpp"
#include "studies/delivered/cam_summary.hpp"
#include "tests/report/well_formed.hpp"
#include "tests/studies/cam_samples.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt {
namespace cam_svg_test {

using testing_support::count_of;

/// Elements are closed and numbers are numbers.
void expect_sound(const std::string& svg) {
    EXPECT_EQ(count_of(svg, "<"), count_of(svg, ">"));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    for (const char* broken : {"nan", "inf", "-0°"}) EXPECT_EQ(svg.find(broken), std::string::npos) << broken;
}

/// A solution with that cam along the motion, as a solve reports it.
Solution with_cam(const DiskCam& cam, const MotionChain& motion, const MotionScale& scale) {
    Solution solution;
    Scene& scene = solution.scene;
    scene.motion.type = MotionType::program;
    scene.motion.lift = scale.lift;
    scene.motion.lift_is_angle = is_oscillating(cam.follower);
    scene.motion.segments = {{.kind = SegmentKind::spline, .angle = scale.unit_angle, .to = {}}};
    DiskSpec spec{.follower = cam.follower, .rotation = cam.rotation};
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i) spec.dimensions[i] = cam.dimensions[i];
    scene.cam = disk_spec(spec);
    solution.motion = std::make_shared<const MotionChain>(motion);
    CamReport report;
    report.cam = disk_mechanism(cam);
    report.summary = cam_summary(report.cam, motion, scene);
    solution.cam = std::move(report);
    return solution;
}

TEST(CamSvg, ShowsEveryPartOfEveryCam) {
    for (const FollowerType follower : test::all_followers)
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
            Solution solution = with_cam(test::sample_cam(follower, rotation),
                                         test::turn_motion("modified_sine"), test::sample_scale(follower));
            solution.scene.title = "A <cam> & its follower";
            const std::string svg = cam_svg(solution);
            expect_sound(svg);
            EXPECT_NE(svg.find("A &lt;cam&gt; &amp; its follower"), std::string::npos);
            EXPECT_EQ(count_of(svg, "class=\"cam\""), 2);    // outline and legend
            EXPECT_EQ(count_of(svg, "class=\"mark\""), 13);  // every 30° and legend
            for (const char* const style : {"class=\"pitch\"", "class=\"prime\"", "class=\"roller\""})
                EXPECT_EQ(count_of(svg, style), has_roller(follower) ? 2 : 0) << style;
            EXPECT_EQ(count_of(svg, "class=\"face\""), has_flat_face(follower) ? 2 : 0);
            EXPECT_EQ(count_of(svg, "class=\"link\""), 2);
            EXPECT_EQ(count_of(svg, "class=\"pivot\""), is_oscillating(follower) ? 1 : 0);
            EXPECT_NE(svg.find(name_of(rotation)), std::string::npos);
            EXPECT_EQ(svg.find("UNDERCUT"), std::string::npos);
        }
}

TEST(CamSvg, AnUndercutCamSaysSo) {
    const DiskCam cam = test::sample_cam(FollowerType::oscillating_flat, Rotation::clockwise);
    const std::string svg =
        cam_svg(with_cam(cam, test::turn_motion("polynomial_4567"), {10 * units::degree, 1.0}));
    expect_sound(svg);
    EXPECT_NE(svg.find("UNDERCUT"), std::string::npos);
    EXPECT_GE(count_of(svg, "class=\"undercut\""), 2);
}

TEST(CamSvg, ASectorIsOpen) {
    const MotionChain motion = test::turn_motion("modified_sine");
    const MotionChain part(std::vector<ChainPart>(motion.parts().begin() + 1, motion.parts().end()));
    const std::string svg = cam_svg(with_cam(test::sample_cam(FollowerType::translating_roller), part,
                                             test::sample_scale(FollowerType::translating_roller)));
    expect_sound(svg);
    EXPECT_NE(svg.find("open: θ from 60° to 360°"), std::string::npos);
    EXPECT_EQ(count_of(svg, "class=\"cam\""), 1);  // the legend alone
    EXPECT_EQ(count_of(svg, "class=\"cam sector\""), 1);
}

TEST(CamDiagrams, ShowLimitsAndExtremes) {
    for (const FollowerType follower : test::all_followers) {
        Solution solution = with_cam(test::sample_cam(follower), test::turn_motion("modified_sine"),
                                     test::sample_scale(follower));
        solution.scene.limits.pressure_angle = WrittenLimit(30 * units::degree);
        solution.scene.limits.cam_radius_min = WrittenLimit(20e-3);
        const std::string svg = cam_diagrams_svg(solution);
        expect_sound(svg);
        // A translating flat face presses straight down: its pressure angle 0 is no diagram.
        const bool straight = follower == FollowerType::translating_flat;
        EXPECT_EQ(count_of(svg, "class=\"optimum\""), straight ? 1 : 2);
        EXPECT_EQ(svg.find("Pressure angle (φ)") == std::string::npos, straight);
        EXPECT_EQ(svg.find(">limit 30 deg") == std::string::npos, straight);
        EXPECT_NE(svg.find("limit: radius 20 mm"), std::string::npos);
        EXPECT_GE(count_of(svg, ">radius "), 1);
        EXPECT_GE(count_of(svg, " deg at "), straight ? 0 : 1);
    }
}

TEST(CamDiagrams, UnboundedCurvatureLeavesTheFrame) {
    const DiskCam cam = test::sample_cam(FollowerType::oscillating_flat, Rotation::clockwise);
    const std::string svg = cam_diagrams_svg(
        with_cam(cam, test::turn_motion("polynomial_4567"), {10 * units::degree, 1.0}), "curvature");
    expect_sound(svg);
    EXPECT_NE(svg.find("it leaves the frame"), std::string::npos);
}

}  // namespace cam_svg_test
}  // namespace camopt

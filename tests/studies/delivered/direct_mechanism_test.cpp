// SPDX-License-Identifier: MIT
// A direct cam that is none of the project's own: what it says of itself behind CamMechanism is enough for
// forces, figures, the forward check and the bounds of its size.
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/delivered/cam_summary.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/forwarding_cam.hpp"
#include "tests/support/middle_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace camopt {
namespace direct_mechanism_test {

using namespace testing_support;

/// A cam of the program's own, with the formulas of another one.
class Foreign final : public ForwardingCam {
 public:
    using ForwardingCam::ForwardingCam;
    [[nodiscard]] std::string type() const override { return "foreign"; }
};

DrivenMechanism foreign(const DrivenMechanism& cam) {
    return {std::make_shared<Foreign>(cam.formulas), cam.dimensions};
}

DrivenMechanism sample(FollowerType follower, CamForm form) {
    DiskCam cam = test::sample_cam(follower, Rotation::clockwise);
    cam.form.type = form;
    if (form == CamForm::grooved) cam.form.groove_clearance = 0.05e-3;
    if (form == CamForm::conjugate) {
        cam.form.second_roller_radius = 6e-3;
        cam.form.arm_angle = 85.0 * units::degree;
        cam.form.roller_distance = 135e-3;
    }
    return disk_mechanism(cam);
}

std::vector<DrivenMechanism> samples() {
    std::vector<DrivenMechanism> all;
    for (const FollowerType follower : test::all_followers) {
        all.push_back(sample(follower, CamForm::open));
        if (!has_roller(follower)) continue;
        all.push_back(sample(follower, CamForm::grooved));
        all.push_back(sample(follower, CamForm::conjugate));
    }
    return all;
}

Scene loaded_scene(bool swings) {
    Scene scene;
    scene.motion.lift = swings ? 5.0 * units::degree : 12e-3;
    scene.motion.rise = 1.0;
    scene.motion.speed = 20.0;
    scene.forces = ForceSpec{};
    scene.forces->mass = 1.0;
    scene.forces->preload = 20.0;
    scene.forces->contact_width = 8e-3;
    return scene;
}

double value_of(const std::optional<CamExtreme>& extreme) {
    return extreme ? extreme->value : -1.0;
}

TEST(DirectMechanism, EveryKindCarriesLoads) {
    const MotionChain motion = test::turn_motion("modified_sine");
    for (const DrivenMechanism& cam : samples()) {
        const Scene scene = loaded_scene(cam.formulas->swings());
        const CamSummary expected = cam_summary(cam, motion, scene),
                         found = cam_summary(foreign(cam), motion, scene);
        ASSERT_TRUE(found.forces);
        EXPECT_GT(value_of(found.forces->normal_force), 0.0);
        EXPECT_EQ(value_of(found.forces->normal_force), value_of(expected.forces->normal_force));
        EXPECT_EQ(value_of(found.forces->hertz_pressure), value_of(expected.forces->hertz_pressure));
        EXPECT_EQ(value_of(found.rise_pressure_angle), value_of(expected.rise_pressure_angle));
        EXPECT_EQ(found.no_contact, expected.no_contact);
        EXPECT_EQ(found.forces->hertz_pressure.has_value(), cam.formulas->contact() != ContactKind::edge);
    }
}

TEST(DirectMechanism, EveryKindIsChecked) {
    const MotionChain motion = test::turn_motion("modified_sine");
    for (const DrivenMechanism& cam : samples()) {
        const MotionScale scale{loaded_scene(cam.formulas->swings()).motion.lift, 1.0};
        const DrivenMechanism other = foreign(cam);
        if (cam.formulas->stations() > 1) {
            const ForwardCheckReport found = two_sided_check(other, motion, scale, 500);
            EXPECT_EQ(found.deviation, two_sided_check(cam, motion, scale, 500).deviation);
            EXPECT_LT(found.relative, 1e-6);
        } else {
            const ForwardCheckResult found = forward_check(forward_check_input(other, motion, scale, 500));
            EXPECT_EQ(found.deviation, forward_check(forward_check_input(cam, motion, scale, 500)).deviation);
            EXPECT_LT(found.relative, 1e-6);
        }
    }
}

TEST(DirectMechanism, EveryKindHasSmallestSize) {
    const Scene scene = pressure_angle_scene(40.0);
    const DrivenMechanism cam = disk_mechanism(middle_cam(disk_of(*scene.cam))), other = foreign(cam);
    const auto law = make_law("modified_sine");
    ASSERT_TRUE(needed_base(scene, other, *law).radius);
    EXPECT_NEAR(*needed_base(scene, other, *law).radius / *needed_base(scene, cam, *law).radius, 1.0, 1e-10);
    ASSERT_TRUE(smallest_of_any_motion(scene, other));
    EXPECT_EQ(smallest_of_any_motion(scene, other)->prime_radius,
              smallest_of_any_motion(scene, cam)->prime_radius);
}

}  // namespace direct_mechanism_test
}  // namespace camopt

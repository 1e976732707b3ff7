// SPDX-License-Identifier: MIT
// Three beats for every limit of a cam: broken without it, kept with it on a dense grid, rows added for it.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/cam_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camopt {
namespace cam_limits_test {

using namespace testing_support;
using enum DimensionIndex;

Scene roller_scene() {
    Scene scene = pressure_angle_scene(40, 12);
    scene.limits = {};
    return scene;
}

Scene oscillating_scene(FollowerType follower) {
    Scene scene;
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 20.0 * units::degree;
    scene.motion.lift_is_angle = true;
    scene.motion.rise = 90.0 * units::degree;
    scene.spline.segments = 16;
    paper_weights(scene);
    scene.cam = disk_spec({.follower = follower});
    scene.cam->set(center_distance, 100e-3);
    if (follower == FollowerType::oscillating_roller) {
        scene.cam->set(base_radius, 40e-3);
        scene.cam->set(roller_radius, 10e-3);
        scene.cam->set(arm_length, 80e-3);
    } else {
        scene.motion.lift = 10.0 * units::degree;
        scene.cam->set(base_radius, 60e-3);
        scene.cam->set(face_offset, 5e-3);
    }
    return scene;
}

void add_forces(Scene& scene) {
    scene.motion.speed = 60.0;
    scene.forces = ForceSpec{.mass = 0.8, .spring_rate = 4000.0, .preload = 400.0, .contact_width = 12e-3};
}

Scene grooved(Scene scene) {
    DiskSpec cam = disk_of(*scene.cam);
    cam.form.type = CamForm::grooved;
    cam.form.groove_clearance = 0.1e-3;
    scene.cam = disk_spec(cam);
    return scene;
}

/// Both disks carry: no preload.
Scene conjugate(Scene scene) {
    DiskSpec cam = disk_of(*scene.cam);
    cam.form.type = CamForm::conjugate;
    if (scene.motion.lift_is_angle)
        cam.form.arm_angle = 75.0 * units::degree;
    else
        cam.form.roller_distance = 120e-3;
    scene.cam = disk_spec(cam);
    return scene;
}

Scene with_free_forces(Scene scene) {
    add_forces(scene);
    scene.forces->preload = 0.0;
    scene.forces->spring_rate = 0.0;
    return scene;
}

/// One limit: how to set it to a value, and the figure it limits.
struct Beat {
    const char* name;
    std::function<Scene()> scene;
    std::function<void(Scene&, double)> set;
    std::function<double(const CamSummary&)> figure;
    int sign;     ///< +1: at most, −1: at least
    double part;  ///< the limit as a part of the free figure
};
void PrintTo(const Beat& beat, std::ostream* stream) {
    *stream << beat.name;
}

std::optional<WrittenLimit> written(double value, const char* key) {
    return WrittenLimit{value, key, 1.0, ""};
}

const Beat beats[] = {
    {"pressure_angle", roller_scene,
     [](Scene& s, double v) { s.limits.pressure_angle = written(v, "limits.pressure_angle_deg"); },
     [](const CamSummary& c) { return c.pressure_angle.value; }, 1, 0.9},
    {"rise_pressure_angle",
     [] {
         Scene scene = roller_scene();
         scene.motion.type = MotionType::rr;
         return scene;
     },
     [](Scene& s, double v) { s.limits.rise_pressure_angle = written(v, "limits.rise_pressure_angle_deg"); },
     [](const CamSummary& c) { return c.rise_pressure_angle->value; }, 1, 0.9},
    {"return_pressure_angle",
     [] {
         Scene scene = roller_scene();
         scene.motion.type = MotionType::rr;
         scene.cam->set(offset, 3e-3);
         return scene;
     },
     [](Scene& s, double v) {
         s.limits.return_pressure_angle = written(v, "limits.return_pressure_angle_deg");
     },
     [](const CamSummary& c) { return c.return_pressure_angle->value; }, 1, 0.9},
    {"cam_radius_min", roller_scene,
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) { return c.convex_radius->value; }, -1, 1.1},
    {"concave_radius_min", roller_scene,
     [](Scene& s, double v) { s.limits.concave_radius_min = written(v, "limits.concave_radius_min_mm"); },
     [](const CamSummary& c) { return c.concave_radius ? c.concave_radius->value : 1e9; }, -1, 1.2},
    {"undercut_margin", roller_scene,
     [](Scene& s, double v) { s.limits.undercut_margin = written(v, "limits.undercut_margin"); },
     [](const CamSummary& c) { return c.regularity.value; }, -1, 1.03},
    {"knife_radius",
     [] {
         Scene scene = roller_scene();
         scene.cam = disk_spec({.follower = FollowerType::translating_knife});
         scene.cam->set(base_radius, 40e-3);
         return scene;
     },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) { return c.convex_radius->value; }, -1, 1.03},
    {"flat_radius",
     [] {
         Scene s = flat_scene(40, 0);
         s.limits = {};
         return s;
     },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) { return c.convex_radius->value; }, -1, 1.1},
    {"flat_margin",
     [] {
         Scene s = flat_scene(40, 0);
         s.limits = {};
         return s;
     },
     [](Scene& s, double v) { s.limits.undercut_margin = written(v, "limits.undercut_margin"); },
     [](const CamSummary& c) { return c.regularity.value; }, -1, 1.1},
    {"face_width",
     [] {
         Scene s = flat_scene(60, 0);
         s.limits = {};
         return s;
     },
     [](Scene& s, double v) { s.cam->face_half_width = v; },
     [](const CamSummary& c) { return c.contact_offset->value; }, 1, 0.9},
    {"arm_pressure_angle", [] { return oscillating_scene(FollowerType::oscillating_roller); },
     [](Scene& s, double v) { s.limits.pressure_angle = written(v, "limits.pressure_angle_deg"); },
     [](const CamSummary& c) { return c.pressure_angle.value; }, 1, 0.95},
    {"arm_radius", [] { return oscillating_scene(FollowerType::oscillating_roller); },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) { return c.convex_radius->value; }, -1, 1.05},
    {"arm_face_pressure_angle", [] { return oscillating_scene(FollowerType::oscillating_flat); },
     [](Scene& s, double v) { s.limits.pressure_angle = written(v, "limits.pressure_angle_deg"); },
     [](const CamSummary& c) { return c.pressure_angle.value; }, 1, 0.97},
    {"arm_face_radius", [] { return oscillating_scene(FollowerType::oscillating_flat); },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) { return c.convex_radius->value; }, -1, 1.05},
    {"contact_force",
     [] {
         Scene s = roller_scene();
         add_forces(s);
         return s;
     },
     [](Scene& s, double v) { s.limits.contact_force_min = written(v, "limits.contact_force_min_n"); },
     [](const CamSummary& c) { return c.forces->least_force.value; }, -1, 1.05},
    {"torque",
     [] {
         Scene s = roller_scene();
         add_forces(s);
         return s;
     },
     [](Scene& s, double v) { s.limits.torque_max = written(v, "limits.torque_max_nm"); },
     [](const CamSummary& c) { return c.forces->torque.value; }, 1, 0.95},
    {"hertz_pressure",
     [] {
         Scene s = roller_scene();
         add_forces(s);
         // One speed: the whole range from 0 has a test of its own (hertz_at_speed) and needs more boxes.
         s.forces->speed_range = {s.motion.speed, s.motion.speed};
         return s;
     },
     [](Scene& s, double v) { s.limits.hertz_pressure_max = written(v, "limits.hertz_pressure_max_mpa"); },
     [](const CamSummary& c) { return c.forces->hertz_pressure->value; }, 1, 0.97},
    {"groove_flank_radius", [] { return grooved(roller_scene()); },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) {
         return std::min(c.sides[0].convex_radius->value,
                         c.sides[1].convex_radius ? c.sides[1].convex_radius->value : 1e9);
     },
     -1, 1.1},
    {"groove_outer_margin", [] { return grooved(oscillating_scene(FollowerType::oscillating_roller)); },
     [](Scene& s, double v) { s.limits.undercut_margin = written(v, "limits.undercut_margin"); },
     [](const CamSummary& c) { return std::min(c.sides[0].regularity.value, c.sides[1].regularity.value); },
     -1, 1.02},
    {"groove_hertz", [] { return grooved(with_free_forces(roller_scene())); },
     [](Scene& s, double v) { s.limits.hertz_pressure_max = written(v, "limits.hertz_pressure_max_mpa"); },
     [](const CamSummary& c) {
         return std::max(c.sides[0].hertz_pressure->value, c.sides[1].hertz_pressure->value);
     },
     1, 0.97},
    {"second_disk_pressure_angle",
     [] { return conjugate(oscillating_scene(FollowerType::oscillating_roller)); },
     [](Scene& s, double v) { s.limits.pressure_angle = written(v, "limits.pressure_angle_deg"); },
     [](const CamSummary& c) {
         return std::max(c.sides[0].pressure_angle.value, c.sides[1].pressure_angle.value);
     },
     1, 0.98},
    {"second_disk_radius", [] { return conjugate(roller_scene()); },
     [](Scene& s, double v) { s.limits.cam_radius_min = written(v, "limits.cam_radius_min_mm"); },
     [](const CamSummary& c) {
         return std::min(c.sides[0].convex_radius->value, c.sides[1].convex_radius->value);
     },
     -1, 1.05},
};

class CamLimit : public testing::TestWithParam<Beat> {};

TEST_P(CamLimit, IsInactiveActiveOrInfeasible) {
    const Beat& beat = GetParam();
    Scene scene = beat.scene();
    const Solution free = solve(scene);
    ASSERT_EQ(free.certificate.verdict, Verdict::optimal);
    const double without = beat.figure(free.cam->summary);
    const double limit = beat.part * without;
    const Peaks reference = reference_peaks(scene);
    const int rows =
        CamProblem(scene_model(scene, DesignKind::states, reference)).grid().shape().constraints();
    beat.set(scene, limit);
    const CamProblem limited(scene_model(scene, DesignKind::states, reference));
    EXPECT_GT(limited.grid().shape().constraints(), rows);

    EXPECT_GT(beat.sign * (without - limit), 0.0);  // broken without it
    const Solution kept = solve(scene);
    ASSERT_TRUE(kept.motion) << name_of(kept.certificate.verdict) << ' ' << kept.certificate.reason;
    const double with = beat.figure(kept.cam->summary);
    EXPECT_LE(beat.sign * (with - limit), 1e-6 * std::abs(limit)) << with << " against " << limit;
    EXPECT_GT(kept.certificate.objective, free.certificate.objective - 1e-9);
    ASSERT_FALSE(kept.constraints.empty());
    EXPECT_TRUE(kept.constraints.back().active) << kept.constraints.back().worst;
}

INSTANTIATE_TEST_SUITE_P(All, CamLimit, testing::ValuesIn(beats),
                         [](const auto& beat) { return beat.param.name; });

}  // namespace cam_limits_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Three beats for every limit of a cam: broken without it, kept with it on a dense grid, rows added for it.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camopt {
namespace cam_limits_test {

using namespace testing_support;

TestScene roller() {
    return pressure_angle_scene(40, 12).with("limits = {}");
}
TestScene arm() {
    return scene_named("rr_cubic_24")
        .with("motion.lift_deg = 20", "motion.rise_deg = 90", "spline.segments = 16",
              "cam = { type = 'disk', follower = 'oscillating_roller', center_distance_mm = 100, "
              "base_radius_mm = 40, roller_radius_mm = 10, arm_length_mm = 80 }");
}
TestScene arm_face() {
    return arm().with("motion.lift_deg = 10",
                      "cam = { type = 'disk', follower = 'oscillating_flat', center_distance_mm = 100, "
                      "base_radius_mm = 60, face_offset_mm = 5 }");
}
TestScene loaded(const TestScene& scene) {
    return scene.with(
        "motion.speed_rad_s = 60",
        "forces = { mass_kg = 0.8, spring_rate_n_m = 4000, preload_n = 400, contact_width_mm = 12 }");
}
TestScene grooved(const TestScene& scene) {
    return scene.with("cam.form = grooved", "cam.groove_clearance_mm = 0.1");
}

/// One limit, and the figure it limits.
struct Beat {
    const char* name;
    TestScene scene;
    const char* limit;  ///< its key, in SI units
    std::function<double(const CamSummary&)> figure;
    int sign;     ///< +1: at most, −1: at least
    double part;  ///< the limit as a part of the free figure
};
void PrintTo(const Beat& beat, std::ostream* stream) {
    *stream << beat.name;
}

constexpr const char* pressure_angle = "limits.pressure_angle_rad";
constexpr const char* radius = "limits.cam_radius_min_m";
constexpr const char* margin = "limits.undercut_margin";
constexpr const char* hertz = "limits.hertz_pressure_max_pa";

double convex_radius(const CamSummary& c) {
    return c.convex_radius->value;
}
double angle(const CamSummary& c) {
    return c.pressure_angle.value;
}
double regularity(const CamSummary& c) {
    return c.regularity.value;
}

const Beat beats[] = {
    {"pressure_angle", roller(), pressure_angle, angle, 1, 0.9},
    {"rise_pressure_angle", roller().with("motion.type = RR"), "limits.rise_pressure_angle_rad",
     [](const CamSummary& c) { return c.rise_pressure_angle->value; }, 1, 0.9},
    {"return_pressure_angle", roller().with("motion.type = RR", "cam.offset_mm = 3"),
     "limits.return_pressure_angle_rad", [](const CamSummary& c) { return c.return_pressure_angle->value; },
     1, 0.9},
    {"cam_radius_min", roller(), radius, convex_radius, -1, 1.1},
    {"concave_radius_min", roller(), "limits.concave_radius_min_m",
     [](const CamSummary& c) { return c.concave_radius ? c.concave_radius->value : 1e9; }, -1, 1.2},
    {"undercut_margin", roller(), margin, regularity, -1, 1.03},
    {"knife_radius",
     roller().with("cam = { type = 'disk', follower = 'translating_knife', base_radius_mm = 40 }"), radius,
     convex_radius, -1, 1.03},
    {"flat_radius", flat_scene(40), radius, convex_radius, -1, 1.1},
    {"flat_margin", flat_scene(40), margin, regularity, -1, 1.1},
    {"face_width", flat_scene(60), "cam.face_half_width_m",
     [](const CamSummary& c) { return c.contact_offset->value; }, 1, 0.9},
    {"arm_pressure_angle", arm(), pressure_angle, angle, 1, 0.95},
    {"arm_radius", arm(), radius, convex_radius, -1, 1.05},
    {"arm_face_pressure_angle", arm_face(), pressure_angle, angle, 1, 0.97},
    {"arm_face_radius", arm_face(), radius, convex_radius, -1, 1.05},
    {"contact_force", loaded(roller()), "limits.contact_force_min_n",
     [](const CamSummary& c) { return c.forces->least_force.value; }, -1, 1.05},
    {"largest_force", loaded(roller()), "limits.contact_force_max_n",
     [](const CamSummary& c) { return c.forces->largest_force.value; }, 1, 0.95},
    {"groove_force", grooved(loaded(roller()).with("forces.preload_n = 0", "forces.spring_rate_n_m = 0")),
     "limits.contact_force_max_n",
     [](const CamSummary& c) {
         return std::max(c.forces->largest_force.value, -c.forces->least_force.value);
     },
     1, 0.97},
    {"torque", loaded(roller()), "limits.torque_max_nm",
     [](const CamSummary& c) { return c.forces->torque.value; }, 1, 0.95},
    // One speed: the whole range from 0 has a test of its own (hertz_at_speed) and needs more boxes.
    {"hertz_pressure", loaded(roller()).with("forces.speed_range_rad_s = [60, 60]"), hertz,
     [](const CamSummary& c) { return c.forces->hertz_pressure->value; }, 1, 0.97},
    {"groove_flank_radius", grooved(roller()), radius,
     [](const CamSummary& c) {
         return std::min(c.sides[0].convex_radius->value,
                         c.sides[1].convex_radius ? c.sides[1].convex_radius->value : 1e9);
     },
     -1, 1.1},
    {"groove_outer_margin", grooved(arm()), margin,
     [](const CamSummary& c) { return std::min(c.sides[0].regularity.value, c.sides[1].regularity.value); },
     -1, 1.02},
    {"groove_hertz", grooved(loaded(roller()).with("forces.preload_n = 0", "forces.spring_rate_n_m = 0")),
     hertz,
     [](const CamSummary& c) {
         return std::max(c.sides[0].hertz_pressure->value, c.sides[1].hertz_pressure->value);
     },
     1, 0.97},
    {"second_disk_pressure_angle", arm().with("cam.form = conjugate", "cam.arm_angle_deg = 75"),
     pressure_angle,
     [](const CamSummary& c) {
         return std::max(c.sides[0].pressure_angle.value, c.sides[1].pressure_angle.value);
     },
     1, 0.98},
    {"second_disk_radius", roller().with("cam.form = conjugate", "cam.roller_distance_mm = 120"), radius,
     [](const CamSummary& c) {
         return std::min(c.sides[0].convex_radius->value, c.sides[1].convex_radius->value);
     },
     -1, 1.05},
};

class CamLimit : public testing::TestWithParam<Beat> {};

TEST_P(CamLimit, IsInactiveActiveOrInfeasible) {
    const Beat& beat = GetParam();
    Scene scene = beat.scene;
    const Solution free = solve(scene);
    ASSERT_EQ(free.certificate.verdict, Verdict::optimal);
    const double without = beat.figure(free.cam->summary);
    const double limit = beat.part * without;
    const Peaks reference = reference_peaks(scene);
    const int rows =
        CamProblem(scene_model(scene, DesignKind::states, reference)).grid().shape().constraints();
    scene = beat.scene.set(beat.limit, limit);
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

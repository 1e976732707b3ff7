// SPDX-License-Identifier: MIT
// Drums that carry a load, and grooves wider than their roller: pressure, torque and lost motion of solved
// scenes against their own formulas.
#include "profiles/spatial/spatial_cam.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/spatial/spatial_forward_check.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace camopt {
namespace drum_loads_test {

using testing_support::refusal;

/// A slide that goes and returns by laws: nothing is searched.
const std::string slide = R"(
[motion]
type = "program"
lift_mm = 30
speed_rpm = 200
segments = [
  { kind = "law", law = "cycloidal", angle_deg = 120, to = 1.0 },
  { kind = "dwell", angle_deg = 60 },
  { kind = "law", law = "cycloidal", angle_deg = 140, to = 0.0 },
  { kind = "dwell", angle_deg = 40 },
]
[cam]
type = "cylindrical"
follower = "translating"
roller_radius_mm = 9
roller_length_mm = 12
cylinder_radius_mm = 50
groove_clearance_mm = 0.1
[forces]
mass_kg = 5
preload_n = 60
contact_width_mm = 12
)";

Solution solved(const std::string& text) {
    return testing_support::solved(testing_support::TestScene(text));
}

/// Written down once more: the pressure of the whole force at one end of the roller, on one flank.
double pressure_at(const Solution& solution, const MotionPoint& at, double height, int flank) {
    const Scene& scene = solution.scene;
    const FollowerState state = state_of(at, motion_scale(scene));
    const double r = 9e-3, groove = 9.05e-3, rho = 50e-3 - height, speed = *scene.motion.speed;
    const double force = 5.0 * speed * speed * state.acceleration + 60.0;
    if (!(flank * force > 0.0)) return 0.0;
    const double w = std::hypot(rho, state.velocity), cosine = rho / w,
                 twist = groove * state.velocity / (w * w);
    const double g = 1.0 + flank * groove * rho * state.acceleration / (w * w * w) - twist * twist;
    const double inclined = 1.0 + twist * twist;
    const double curvature = inclined / (groove * g) + 1.0 / r - 1.0 / groove;
    const double normal = std::abs(force) / cosine / (12e-3 * std::sqrt(inclined)),
                 modulus = 210e9 / (2.0 * 0.91);
    return std::sqrt(normal * modulus * curvature / std::numbers::pi);
}

TEST(DrumLoads, LoadsFollowFromTheMotion) {
    const Solution solution = solved(slide);
    ASSERT_TRUE(solution.cam->summary.forces);
    const ForceSummary& forces = *solution.cam->summary.forces;
    const MotionChain turn = whole_turn(solution);
    std::array<double, 2> pressure{};
    double torque = 0.0;
    constexpr int fine = 20000;
    for (int i = 0; i < fine; ++i) {
        const MotionPoint at = turn.at(turn.begin() + (turn.end() - turn.begin()) * (i + 0.5) / fine);
        const FollowerState state = state_of(at, motion_scale(solution.scene));
        const double speed = *solution.scene.motion.speed;
        torque =
            std::max(torque, std::abs((5.0 * speed * speed * state.acceleration + 60.0) * state.velocity));
        for (const double height : {0.0, 6e-3, 12e-3})
            for (const int side : {0, 1})
                pressure[side] =
                    std::max(pressure[side], pressure_at(solution, at, height, side == 0 ? 1 : -1));
    }
    EXPECT_NEAR(forces.torque.value, torque, 1e-5 * torque);
    ASSERT_EQ(solution.cam->summary.sides.size(), 2U);
    for (const std::size_t side : {0U, 1U})
        EXPECT_NEAR(solution.cam->summary.sides[side].hertz_pressure->value, pressure[side],
                    1e-5 * pressure[side]);
    EXPECT_EQ(forces.hertz_pressure->value, std::max(solution.cam->summary.sides[0].hertz_pressure->value,
                                                     solution.cam->summary.sides[1].hertz_pressure->value));
}

TEST(DrumLoads, LostMotionIsClearanceOverCosine) {
    const Solution solution = solved(slide);
    const ForwardCheckReport check = check_flanks(solution);
    ASSERT_TRUE(check.play);
    // In the dwells the whole clearance; where it is steepest as much as the end of the roller leaves that is
    // less inclined, the near one.
    EXPECT_NEAR(check.play->least, 0.1e-3, 1e-9);
    const double steepest = std::atan(2.0 * 30e-3 / (120.0 * units::degree) / 50e-3);
    EXPECT_NEAR(check.play->largest, 0.1e-3 / std::cos(steepest), 2e-7);
    EXPECT_LT(check.deviation, 1e-9);
}

TEST(DrumLoads, PressureLimitChangesTheMotion) {
    const std::string text = R"(
[motion]
type = "DRD"
lift_deg = 45
rise_deg = 150
speed_rpm = 120
[spline]
segments = 8
[objective]
velocity = 1
[cam]
type = "barrel"
roller_radius_mm = 20
roller_length_mm = 20
arm_length_mm = 120
center_distance_mm = 120
lateral_offset_mm = 115
[forces]
inertia_kg_m2 = 0.5
contact_width_mm = 18
[solver]
starts = 1
)";
    const Solution free = solved(text);
    const double most = free.cam->summary.forces->hertz_pressure->value;
    const double limit = 0.95 * most / 1e6;
    const Solution held = solved(text + "[limits]\nhertz_pressure_max_mpa = " + std::to_string(limit) + "\n");
    ASSERT_TRUE(held.motion);
    EXPECT_LE(held.cam->summary.forces->hertz_pressure->value, limit * 1e6 * (1.0 + 1e-6));
    EXPECT_GT(held.certificate.objective, free.certificate.objective);
    const MotionChain turn = whole_turn(held);
    for (int i = 0; i <= 2000; ++i) {
        const MotionPoint at = turn.at(turn.begin() + (turn.end() - turn.begin()) * i / 2000.0, Side::left);
        const FollowerState state = state_of(at, motion_scale(held.scene));
        const double force = held.scene.forces->force(*held.scene.motion.speed, state, 0.0);
        for (int station = 0; station < held.cam->cam.formulas->stations(); ++station) {
            const MechanismPoint point =
                mechanism_point(held.cam->cam, at, motion_scale(held.scene), station);
            const double normal = normal_force(held.cam->cam, state, force, station);
            EXPECT_LE(hertz_pressure(held.cam->cam, *held.scene.forces, point, normal, station),
                      limit * 1e6 * (1.0 + 1e-6));
        }
    }
}

TEST(DrumLoads, TooSmallBodyIsRefused) {
    const auto with = [](const std::string& key) {
        std::string text = slide;
        text.insert(text.find("[forces]"), key + "\n");
        return refusal([&] { (void)solve(testing_support::TestScene(text)); }, "");
    };
    EXPECT_NE(with("body_length_mm = 40").find("at least 48.1 mm"), std::string::npos);
    EXPECT_NE(with("groove_wall_mm = 5\nbody_length_mm = 58").find("at least 58.1 mm"), std::string::npos);
    EXPECT_NE(with("body_diameter_mm = 70").find("above 76 mm"), std::string::npos);
    EXPECT_NE(with("body_diameter_mm = 101").find("at most 100 mm"), std::string::npos);
    EXPECT_EQ(with("body_diameter_mm = 96\nbody_length_mm = 60"), "");
}

}  // namespace drum_loads_test
}  // namespace camopt

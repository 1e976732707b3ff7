// SPDX-License-Identifier: MIT
// Random cams of every follower, rotation and kind of motion: whatever is delivered satisfies every limit of
// its scene, evaluated independently on 20,000 angles and closer about the worst. The limits are set near
// what the motion without them reaches, so that many of them bite, among them where the cam would undercut.
#include "profiles/disk/disk_cam.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/studies/independent_cam.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace camopt {
namespace delivered_cam_test {

using namespace testing_support;
using enum DimensionIndex;

constexpr int dense_points = 20000;
constexpr double kept = 1e-6;  // of a limit, as other trials demand it

class Random {
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
    }
    bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
    std::mt19937 engine_;
};

struct Case {
    FollowerType follower;
    Rotation rotation;
    MotionType motion;
    unsigned seed;
};

void set_motion(Scene& scene, MotionType type, Random& random) {
    scene.motion.type = type;
    scene.motion.rise = random.between(55.0, 120.0) * units::degree;
    scene.motion.speed = random.between(20.0, 80.0);
    if (type == MotionType::rr) scene.motion.return_angle = random.between(55.0, 120.0) * units::degree;
    if (type != MotionType::program) return;
    const double rise = random.between(60.0, 130.0), back = random.between(60.0, 130.0);
    scene.motion.segments = {dwell(40.0), spline(rise, 1.0), dwell(20.0), spline(back, 0.0),
                             dwell(300.0 - rise - back)};
}

void set_cam(Scene& scene, FollowerType follower, Random& random) {
    DiskSpec cam;
    cam.follower = follower;
    const bool swings = is_oscillating(follower);
    scene.motion.lift_is_angle = swings;
    scene.motion.lift = swings ? random.between(8.0, 20.0) * units::degree : random.between(8e-3, 30e-3);
    const double reach = swings ? scene.motion.lift * 0.12 : scene.motion.lift;
    const double prime = reach * random.between(1.6, 3.5);
    const double roller = has_roller(follower) ? prime * random.between(0.2, 0.45) : 0.0;
    cam[base_radius] = prime - roller;
    if (roller > 0.0) cam[roller_radius] = roller;
    if (has_dimension(follower, offset)) cam[offset] = prime * random.between(-0.3, 0.3);
    if (!swings) {
        scene.cam = disk_spec(cam);
        return;
    }
    cam[center_distance] = prime * random.between(1.3, 2.2);
    if (follower == FollowerType::oscillating_roller)
        cam[arm_length] = cam[center_distance].low * random.between(0.75, 1.05);
    if (follower == FollowerType::oscillating_flat) cam[face_offset] = prime * random.between(-0.2, 0.2);
    scene.cam = disk_spec(cam);
}

void set_forces(Scene& scene, Random& random) {
    ForceSpec& forces = scene.forces.emplace();
    const double lift = scene.motion.lift, unit = scene.motion.unit_angle();
    forces.mass = scene.motion.lift_is_angle ? 0.02 : 1.5;
    const double swing = 6.0 * forces.mass * std::pow(*scene.motion.speed / unit, 2) * lift;
    forces.preload = swing * random.between(0.6, 1.6);
    forces.spring_rate = swing / lift * random.between(0.1, 0.8);
    forces.contact_width = 10e-3;
}

/// Limits near what the motion without them reaches: some beyond it, or all satisfied by it.
enum class Tightness { near, satisfied };

void set_limits(Scene& scene, const CamReport& free, Random& random, Tightness tightness) {
    const CamSummary& reached = free.summary;
    const bool satisfied = tightness == Tightness::satisfied;
    const auto share = [&](double low, double high) { return random.between(satisfied ? 1.01 : low, high); };
    LimitSpec& limits = scene.limits;
    limits = {};
    const auto angle = [&](const CamExtreme& extreme, const char* key) {
        return degrees(
            std::clamp(extreme.value / units::degree * share(0.9, 1.15), 5.0, satisfied ? 89.0 : 80.0), key);
    };
    if (random.chance(0.4))
        limits.pressure_angle = angle(reached.pressure_angle, "limits.pressure_angle_deg");
    if (random.chance(0.3))
        limits.rise_pressure_angle = angle(reached.pressure_angle, "limits.rise_pressure_angle_deg");
    if (random.chance(0.3))
        limits.return_pressure_angle = angle(reached.pressure_angle, "limits.return_pressure_angle_deg");
    if (random.chance(0.2) && (reached.convex_radius->value > 1e-3 || !satisfied)) {
        const double radius = std::max(1e-3, reached.convex_radius->value);
        limits.cam_radius_min =
            millimetres(1e3 * std::min(radius, 0.2) * random.between(0.5, satisfied ? 0.99 : 1.2),
                        "limits.cam_radius_min_mm");
    }
    const ForceSummary& forces = *reached.forces;
    // Where the cam is not undercut either.
    const bool touches = forces.least_force.value > 0.0 && reached.convex_radius->value > 1e-3;
    if (random.chance(0.3) && (touches || !satisfied))
        limits.contact_force_min = {
            std::max(0.0, forces.least_force.value) * random.between(0.8, satisfied ? 0.99 : 1.1),
            "limits.contact_force_min_n", 1.0, "N"};
    if (random.chance(0.4) && (touches || !satisfied))
        limits.torque_max = {forces.torque.value * share(0.85, 1.1), "limits.torque_max_nm", 1.0, "N m"};
    const bool is_knife = disk_of(*scene.cam).follower == FollowerType::translating_knife;
    const bool has_pressure = forces.hertz_pressure && std::isfinite(forces.hertz_pressure->value);
    if (!is_knife && random.chance(0.7) && ((touches && has_pressure) || !satisfied)) {
        const double most = satisfied ? infinity : 4e9;
        const double pressure = has_pressure ? std::min(forces.hertz_pressure->value, most) : 1.5e9;
        limits.hertz_pressure_max = {pressure * share(0.8, 1.3), "limits.hertz_pressure_max_mpa", 1e6, "MPa"};
    }
    // One at least.
    if (limits == LimitSpec())
        limits.pressure_angle = angle(reached.pressure_angle, "limits.pressure_angle_deg");
}

Scene base_scene(const Case& one, Random& random) {
    Scene scene;
    set_cam(scene, one.follower, random);
    set_motion(scene, one.motion, random);
    scene.cam->rotation = one.rotation;
    scene.spline.segments = 10;
    scene.objective.velocity = random.between(0.2, 1.0);
    scene.objective.acceleration = random.between(0.2, 1.0);
    scene.objective.jerk = random.between(0.1, 0.5);
    scene.solver.starts = 2;
    scene.solver.max_seconds = 10.0;
    set_forces(scene, random);
    return scene;
}

/// By how much of itself the limit that is worst kept is passed.
double worst_excess(const Scene& scene, const DiskCam& cam, const Motion& motion, std::string& which) {
    const LimitSpec& limits = scene.limits;
    const IndependentCam independent(scene, cam);
    double worst = -infinity;
    const auto see = [&](const char* name, const auto& excess) {
        const double value = densely_worst(
            motion, dense_points, [&](const MotionPoint& point) { return excess(independent.at(point)); });
        if (value <= worst) return;
        worst = value;
        which = name;
    };
    const auto most = [&](const char* name, const std::optional<WrittenLimit>& limit, const auto& figure) {
        if (!limit) return;
        see(name, [&](const CamContact& at) { return figure(at) / limit->value - 1.0; });
    };
    // Signs of s' are told apart from rounding; at rest all that are given hold.
    const double still = 1e-9 * scene.motion.lift / scene.motion.unit_angle();
    const auto rise = [&](const CamContact& at) { return at.velocity > still ? at.pressure : 0.0; };
    const auto back = [&](const CamContact& at) { return at.velocity < -still ? at.pressure : 0.0; };
    most("rise pressure", limits.rise_pressure_angle ? limits.rise_pressure_angle : limits.pressure_angle,
         rise);
    most("return pressure",
         limits.return_pressure_angle ? limits.return_pressure_angle : limits.pressure_angle, back);
    for (const auto& limit :
         {limits.pressure_angle, limits.rise_pressure_angle, limits.return_pressure_angle}) {
        if (!limit) continue;
        std::vector<double> rests = {motion.begin(), motion.end()};
        if (scene.motion.type != MotionType::program) rests.push_back(1.0);
        for (const double x : motion.breakpoints())
            if (scene.motion.type == MotionType::program && std::abs(motion.at(x).derivative[1]) < 1e-12)
                rests.push_back(x);
        for (const double x : rests) {
            const double excess = independent.at(motion.at(x)).pressure / limit->value - 1.0;
            if (excess > worst) {
                worst = excess;
                which = "pressure at rest";
            }
        }
    }
    most("torque", limits.torque_max, [](const CamContact& at) { return at.torque; });
    most("Hertz pressure", limits.hertz_pressure_max, [](const CamContact& at) { return at.hertz; });
    if (limits.contact_force_min)
        see("force", [&](const CamContact& at) {
            return (limits.contact_force_min->value - at.force) /
                   std::max(std::abs(limits.contact_force_min->value), scene.forces->preload);
        });
    if (limits.cam_radius_min)
        see("radius", [&](const CamContact& at) {
            if (has_flat_face(cam.follower)) return 1.0 - at.radius / limits.cam_radius_min->value;
            const double roller = has_roller(cam.follower) ? cam[roller_radius] : 0.0;
            return at.curvature * (limits.cam_radius_min->value + roller) - 1.0;
        });
    if (limits.torque_max || limits.hertz_pressure_max)
        see("contact", [](const CamContact& at) { return at.touches ? -1.0 : 1.0; });
    return worst;
}

class DeliveredCam : public testing::TestWithParam<Case> {};

TEST_P(DeliveredCam, SatisfiesEveryLimitOfItsScene) {
    Random random(GetParam().seed);
    Scene scene = base_scene(GetParam(), random);
    const Solution free = solve_without_explaining(scene, {});
    ASSERT_TRUE(free.cam) << "this cam cannot be built";
    set_limits(scene, *free.cam, random, Tightness::near);
    Solution solution = solve_without_explaining(scene, {});
    std::printf("%s", name_of(solution.certificate.verdict));
    if (!solution.motion) {
        set_limits(scene, *free.cam, random, Tightness::satisfied);
        solution = solve_without_explaining(scene, {});
        std::printf(", then %s", name_of(solution.certificate.verdict));
    }
    const Verdict verdict = solution.certificate.verdict;
    ASSERT_TRUE(solution.motion) << name_of(verdict) << " where the motion without limits satisfies them";
    EXPECT_TRUE(verdict != Verdict::infeasible && verdict != Verdict::failed) << name_of(verdict);
    std::string which;
    const double excess = worst_excess(scene, *disk_cam(solution.cam->cam), *solution.motion, which);
    EXPECT_LE(excess, kept) << which << ", verdict " << name_of(verdict);
    EXPECT_FALSE(which.empty()) << "no limit was looked at";
    std::printf(", worst %.2g %s\n", excess, which.c_str());
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    const char* asked = std::getenv("CAMOPT_TRIALS");
    const int trials = asked ? std::atoi(asked) : 1;
    unsigned seed = 0;
    for (int k = 0; k < trials; ++k)
        for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::translating_flat,
                                            FollowerType::translating_knife, FollowerType::oscillating_roller,
                                            FollowerType::oscillating_flat})
            for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
                for (const MotionType type : {MotionType::drd, MotionType::rr, MotionType::program})
                    cases.push_back({follower, rotation, type, ++seed});
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Random, DeliveredCam, testing::ValuesIn(all_cases()),
                         [](const testing::TestParamInfo<Case>& one) {
                             return std::string(name_of(one.param.follower)) + "_" +
                                    name_of(one.param.rotation) + "_" + std::to_string(one.param.seed);
                         });

}  // namespace delivered_cam_test
}  // namespace camopt

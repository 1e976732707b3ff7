// SPDX-License-Identifier: MIT
// Optimised scenes with barrel and cylindrical cams, rebuilt from the delivered motion alone: pressure angle
// by the short formulas of each mechanism, undercut by the distance of the flank from the roller's sweep.
#include "benchmarks/papers/spatial_methods.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/spatial/spatial_forward_check.hpp"
#include "tests/profiles/spatial/reference_cams.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace spatial_scenes_test {

using test::degree;
using test::millimetre;

constexpr int fine = 20000;

/// One start finds what all find; and it may take the time it takes.
Solution solved(const std::string& name) {
    return testing_support::solved(
        testing_support::scene_named(name).with("solver.starts = 1", "solver.max_seconds = 600"));
}

/// Written down once more, from numbers only: MECHANISMS' tan φ of a barrel cam and of a rotating follower.
struct Rebuilt {
    double barrel_arm = 0.0, center_distance = 0.0, start = 0.0, roller_length = 0.0;
    bool barrel = true;

    [[nodiscard]] double pressure_angle(double s, double slope, double h) const {
        const double q = start + s;
        if (barrel) {
            const double rho = center_distance - h;
            return std::atan((barrel_arm * slope - rho * std::sin(q)) / (rho * std::cos(q)));
        }
        const double rho = barrel_arm + h;
        return std::atan(rho * slope / (center_distance - rho * std::cos(q)));
    }
    /// The largest |φ| over the motion, deg.
    [[nodiscard]] double largest(const Motion& motion, const MotionScale& scale) const {
        double worst = 0.0;
        for (int i = 0; i <= fine; ++i) {
            const double x = motion.begin() + (motion.end() - motion.begin()) * i / fine;
            const MotionPoint point = motion.at(x);
            const double s = scale.lift * point.derivative[0];
            const double slope = scale.lift / scale.unit_angle * point.derivative[1];
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                worst = std::max(worst, std::abs(pressure_angle(s, slope, share * roller_length)));
        }
        return worst / degree;
    }
};

Rebuilt paper_cup(double center_distance_mm) {
    return {164.0 * millimetre, center_distance_mm * millimetre, -180.0 / 7.0 * degree, 38.1 * millimetre,
            true};
}
Rebuilt indexing() {
    return {70.0 * millimetre, 150.0 * millimetre, -22.5 * degree, 20.0 * millimetre, false};
}

/// Of one law of the catalogue, for what the scene asks.
double of_modified_sine(const Rebuilt& cam, const MotionScale& scale) {
    return cam.largest(*make_law("modified_sine"), scale);
}

void expect_motion_of_the_scene(const Solution& solution) {
    ASSERT_TRUE(solution.motion);
    EXPECT_LE(solution.certificate.worst_violation, solution.scene.solver.tolerance);
    const Motion& motion = *solution.motion;
    const MotionPoint first = motion.at(motion.begin()), last = motion.at(motion.end(), Side::left);
    EXPECT_NEAR(first.derivative[0], 0.0, 1e-9);
    EXPECT_NEAR(last.derivative[0], 1.0, 1e-9);
    for (const std::size_t order : {1U, 2U}) {
        EXPECT_NEAR(first.derivative[order], 0.0, 1e-7);
        EXPECT_NEAR(last.derivative[order], 0.0, 1e-7);
    }
}

/// No roller-sized cutter takes anything of the flanks, and they drive the follower as designed.
void expect_sound_flanks(const Solution& solution) {
    const SpatialCam cam = spatial_cam(solution.scene.cam.value(), solution.cam->cam.dimensions);
    const MotionScale scale = motion_scale(solution.scene);
    const FollowerMotion motion = follower_motion(*solution.motion, scale);
    for (const int flank : {1, -1})
        EXPECT_GE(least_undercut(cam, motion, flank, {0.0, cam.roller_length}).value, 0.5 - 1e-7);
    EXPECT_LT(interference(cam, motion, {}).depth, 1e-12);
    EXPECT_LT(check_flanks(solution).deviation, 1e-8);
}

/// Under 42 deg, where the modified sine has 43.78, and gentler than it in every peak.
TEST(SpatialScenes, PaperCupMachineBeatsModifiedSine) {
    const Solution solution = solved("barrel_paper_cup");
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    expect_motion_of_the_scene(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const Rebuilt cam = paper_cup(150.0);
    EXPECT_NEAR(of_modified_sine(cam, scale), 43.7789637, 1e-5);
    EXPECT_LT(cam.largest(*solution.motion, scale), 42.0 + 1e-6);
    const Peaks law = make_law("modified_sine")->peaks();
    EXPECT_LT(solution.peaks.velocity.value, law.velocity.value);
    EXPECT_LT(solution.peaks.acceleration.value, law.acceleration.value);
    EXPECT_LT(solution.peaks.jerk.value, law.jerk.value);
    expect_sound_flanks(solution);
}

TEST(SpatialScenes, IndexingByACylindricalCam) {
    const Solution solution = solved("ocrf_indexing");
    expect_motion_of_the_scene(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::boxes);
    EXPECT_NEAR(solution.certificate.objective, 0.94635201327, 1e-8);  // of 40 starts the best
    const MotionScale scale = motion_scale(solution.scene);
    EXPECT_NEAR(of_modified_sine(indexing(), scale), 33.4188748, 1e-5);
    EXPECT_LT(indexing().largest(*solution.motion, scale), 32.0 + 1e-6);
    expect_sound_flanks(solution);
}

/// tan φ = s'/ρ, largest at the far end, 45 mm from the cam's axis.
TEST(SpatialScenes, SlideOnACylindricalCam) {
    const Solution solution = solved("cylinder_slide");
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    expect_motion_of_the_scene(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const auto largest = [&](const Motion& motion) {
        double worst = 0.0;
        for (int i = 0; i <= fine; ++i) {
            const double slope = motion.at(static_cast<double>(i) / fine).derivative[1];
            worst = std::max(worst, std::abs(scale.lift / scale.unit_angle * slope));
        }
        return std::atan(worst / (45.0 * millimetre)) / degree;
    };
    EXPECT_NEAR(largest(*make_law("modified_sine")), 30.855746, 1e-5);
    EXPECT_LT(largest(*solution.motion), 30.0 + 1e-6);
    expect_sound_flanks(solution);
}

/// 40 deg: the distance of the axes that the modified sine needs, and the smaller one that the optimum needs.
TEST(SpatialScenes, TheSmallestBarrelForFortyDegrees) {
    const Solution solution = solved("barrel_smallest");
    expect_motion_of_the_scene(solution);
    // Found by both solvers from all starts; the flat bottom leaves the last digits of stationarity open.
    EXPECT_NEAR(solution.certificate.objective, 9.53878965, 1e-7);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::boxes);
    const MotionScale scale = motion_scale(solution.scene);
    double enough = 250.0, too_little = 100.0;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (enough + too_little);
        (of_modified_sine(paper_cup(middle), scale) <= 40.0 ? enough : too_little) = middle;
    }
    const double chosen = spatial_cam(solution.scene.cam.value(),
                                      solution.cam->cam.dimensions)[SpatialDimension::center_distance] /
                          millimetre;
    RecordProperty("modified_sine_mm", std::to_string(enough));
    RecordProperty("optimum_mm", std::to_string(chosen));
    EXPECT_LT(chosen, 0.9 * enough);
    EXPECT_LT(paper_cup(chosen).largest(*solution.motion, scale), 40.0 + 1e-6);
    expect_sound_flanks(solution);
}

}  // namespace spatial_scenes_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Extreme scenes end in a true verdict: never a crash, a NaN or a false success.
#include "solvers/certificate/box_proof.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/cam_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace camopt {
namespace cam_extremes_test {

using namespace testing_support;
using enum DimensionIndex;

struct Extreme {
    const char* name;
    std::function<Scene()> scene;
};
void PrintTo(const Extreme& extreme, std::ostream* stream) {
    *stream << extreme.name;
}

Scene scaled_scene(double factor) {
    Scene scene = pressure_angle_scene(40, 12);
    scene.motion.lift *= factor;
    for (CamDimension& dimension : scene.cam->dimensions)
        dimension.value.low = dimension.value.high = dimension.value.low * factor;
    scene.limits.cam_radius_min = millimetres(5.0 * factor, "limits.cam_radius_min_mm");
    return scene;
}

Scene changed(const std::function<void(Scene&)>& change) {
    Scene scene = pressure_angle_scene(40, 12);
    scene.limits.cam_radius_min = millimetres(2.0, "limits.cam_radius_min_mm");
    scene.solver.max_seconds = 20.0;
    change(scene);
    return scene;
}

const Extreme extremes[] = {
    {"lift_of_a_micrometre", [] { return scaled_scene(1e-3 / 20.0); }},
    {"lift_of_a_metre", [] { return scaled_scene(1e3 / 20.0); }},
    {"small_lift_on_a_usual_cam", [] { return changed([](Scene& s) { s.motion.lift = 1e-6; }); }},
    {"large_lift_on_a_usual_cam", [] { return changed([](Scene& s) { s.motion.lift = 1.0; }); }},
    {"rise_of_2_degrees", [] { return changed([](Scene& s) { s.motion.rise = 2.0 * units::degree; }); }},
    {"rise_of_350_degrees", [] { return changed([](Scene& s) { s.motion.rise = 350.0 * units::degree; }); }},
    {"base_just_above_the_limit",
     [] {
         Scene scene = pressure_angle_scene(27.0058744, 24);
         return scene;
     }},
    {"base_just_below_the_limit", [] { return pressure_angle_scene(27.00587, 24); }},
    {"offset_near_the_prime_radius", [] { return changed([](Scene& s) { s.cam->set(offset, 39.9e-3); }); }},
    {"offset_near_the_prime_radius_clockwise",
     [] {
         return changed([](Scene& s) {
             s.cam->set(offset, 39.9e-3);
             s.cam->rotation = Rotation::clockwise;
         });
     }},
    {"roller_as_large_as_the_pitch_curvature",
     [] {
         return changed([](Scene& s) {
             s.cam->set(base_radius, 10.5e-3);
             s.cam->set(roller_radius, 29.5e-3);
             s.limits.cam_radius_min = millimetres(0.0, "limits.cam_radius_min_mm");
         });
     }},
    {"pressure_angle_of_1_degree",
     [] {
         return changed(
             [](Scene& s) { s.limits.pressure_angle = degrees(1.0, "limits.pressure_angle_deg"); });
     }},
    {"pressure_angle_of_89_degrees",
     [] {
         return changed(
             [](Scene& s) { s.limits.pressure_angle = degrees(89.0, "limits.pressure_angle_deg"); });
     }},
};

class ExtremeCam : public testing::TestWithParam<Extreme> {};

TEST_P(ExtremeCam, EndsInATrueVerdict) {
    const Scene scene = GetParam().scene();
    const Solution solution = solve(scene);
    const Certificate& certificate = solution.certificate;
    std::printf("%s: %s %s, objective %.9g, %.2f s\n", GetParam().name, name_of(certificate.verdict),
                name_of(certificate.reason), certificate.objective, solution.seconds_total);
    if (certificate.verdict == Verdict::infeasible) {
        ASSERT_TRUE(certificate.proof || certificate.box_proof);
        const double bound = certificate.proof ? recomputed_bound(*certificate.proof)
                                               : recomputed_bound(*certificate.box_proof);
        EXPECT_GT(bound, 0.0);
        EXPECT_FALSE(solution.motion);
        return;
    }
    if (certificate.verdict == Verdict::failed) {
        EXPECT_NE(certificate.reason, Reason::none);
        EXPECT_FALSE(solution.motion);
        return;
    }
    ASSERT_TRUE(solution.motion);
    EXPECT_TRUE(std::isfinite(certificate.objective));
    const CamSummary& summary = solution.cam->summary;
    EXPECT_LE(summary.pressure_angle.value, scene.limits.pressure_angle->value * (1 + 1e-6));
    if (scene.limits.cam_radius_min) {
        const double least = scene.limits.cam_radius_min->value;
        EXPECT_GE(summary.convex_radius->value, least - 1e-6 * std::max(least, 1e-3 * scene.motion.lift));
    }
    for (int k = 0; k <= 1000; ++k) {
        const double x = solution.motion->end() * k / 1000.0;
        for (const double value : solution.motion->at(x).derivative) ASSERT_TRUE(std::isfinite(value));
    }
}

INSTANTIATE_TEST_SUITE_P(All, ExtremeCam, testing::ValuesIn(extremes),
                         [](const auto& extreme) { return std::string(extreme.param.name); });

}  // namespace cam_extremes_test
}  // namespace camopt

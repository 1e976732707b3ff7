// SPDX-License-Identifier: MIT
// Extreme scenes end in a true verdict: never a crash, a NaN or a false success.
#include "solvers/certificate/box_proof.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace cam_extremes_test {

using namespace testing_support;

struct Extreme {
    const char* name;
    TestScene scene;
};
void PrintTo(const Extreme& extreme, std::ostream* stream) {
    *stream << extreme.name;
}

TestScene scaled_scene(double factor) {
    return pressure_angle_scene(40, 12)
        .set("motion.lift_mm", 20.0 * factor)
        .set("cam.base_radius_mm", 30.0 * factor)
        .set("cam.roller_radius_mm", 10.0 * factor)
        .set("limits.cam_radius_min_mm", 5.0 * factor);
}

template <class... Settings>
TestScene changed(const Settings&... settings) {
    return pressure_angle_scene(40, 12).with("limits.cam_radius_min_mm = 2", "solver.max_seconds = 20",
                                             settings...);
}

const Extreme extremes[] = {
    {"lift_of_a_micrometre", scaled_scene(1e-3 / 20.0)},
    {"lift_of_a_metre", scaled_scene(1e3 / 20.0)},
    {"small_lift_on_a_usual_cam", changed("motion.lift_m = 1e-6")},
    {"large_lift_on_a_usual_cam", changed("motion.lift_m = 1")},
    {"rise_of_2_degrees", changed("motion.rise_deg = 2")},
    {"rise_of_350_degrees", changed("motion.rise_deg = 350")},
    {"base_just_above_the_limit", pressure_angle_scene(27.0058744)},
    {"base_just_below_the_limit", pressure_angle_scene(27.00587)},
    {"offset_near_the_prime_radius", changed("cam.offset_mm = 39.9")},
    {"offset_near_the_prime_radius_clockwise", changed("cam.offset_mm = 39.9", "cam.rotation = clockwise")},
    {"roller_as_large_as_the_pitch_curvature",
     changed("cam.base_radius_mm = 10.5", "cam.roller_radius_mm = 29.5", "limits.cam_radius_min_mm = 0")},
    {"pressure_angle_of_1_degree", changed("limits.pressure_angle_deg = 1")},
    {"pressure_angle_of_89_degrees", changed("limits.pressure_angle_deg = 89")},
};

class ExtremeCam : public testing::TestWithParam<Extreme> {};

TEST_P(ExtremeCam, EndsInATrueVerdict) {
    const Scene scene = GetParam().scene;
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

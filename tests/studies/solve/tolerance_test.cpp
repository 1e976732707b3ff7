// SPDX-License-Identifier: MIT
// Limits that hold for every cam within the tolerances, against references of independent linear programs
// (docs/tolerances.md), and what tolerances cost. Cams drawn at random: made_cams_test.cpp.
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace tolerance_test {

using namespace testing_support;

/// A rise of 20 mm in 24 cubic segments, a roller of 10 mm on a prime circle of 35 mm, 30° of pressure angle.
TestScene rise(double offset_mm = 0.0) {
    const TestScene scene(R"(
[motion]
type = "DRD"
lift_mm = 20
rise_deg = 60
[spline]
degree = 3
segments = 24
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
reference = { velocity = 1.76, acceleration = 5.53, jerk = 69 }
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 25
roller_radius_mm = 10
offset_mm = 0
[limits]
pressure_angle_deg = 30
[solver]
tolerance = 1e-11
)");
    return scene.set("cam.offset_mm", offset_mm);
}

TestScene with_profile(const TestScene& scene) {
    return scene.with("tolerance.profile_um = 20", "tolerance.slope_mm_deg = 0.005");
}

void expect_optimum(const Scene& scene, double objective, const std::array<double, 3>& peaks) {
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective, objective, 1e-8 * objective);
    // Of equally good motions the tie-break takes one.
    EXPECT_NEAR(solution.peaks.velocity.value, peaks[0], 2e-5);
    EXPECT_NEAR(solution.peaks.acceleration.value, peaks[1], 5e-5);
    EXPECT_NEAR(solution.peaks.jerk.value, peaks[2], 5e-4);
}

TEST(Tolerances, MatchIndependentProgram) {
    expect_optimum(rise(), 1.2117060211, {1.5253231, 8.0757965, 96.9095575});
    expect_optimum(with_profile(rise()), 1.2443784369, {1.5088163, 8.4158408, 100.9900891});
    expect_optimum(with_profile(rise()).with("tolerance.base_radius_mm = 0.05"), 1.2475626440,
                   {1.5073031, 8.4487783, 101.3853400});
    expect_optimum(rise(5.0), 0.9720642276, {1.6267348, 5.6233942, 67.4807308});
    expect_optimum(
        with_profile(rise(5.0)).with("tolerance.base_radius_mm = 0.05", "tolerance.offset_mm = 0.05"),
        0.9798034311, {1.6289835, 5.6908740, 68.2904882});
}

TEST(Tolerances, WithoutNumbersChangeNoBit) {
    Scene empty = rise();
    empty.tolerance.emplace();
    const Solution with = solve(empty), without = solve(rise());
    EXPECT_EQ(with.certificate.objective, without.certificate.objective);
    EXPECT_EQ(with.design.values, without.design.values);
}

/// Without the table no rule of a made cam exists, none is enclosed, nothing is reported.
TEST(Tolerances, WithoutTableNothingIsEvaluated) {
    const Scene plain = rise(5.0);
    const Scene tolerant = with_profile(rise(5.0)).with("tolerance.base_radius_mm = 0.05");
    const Solution without = solve(plain), with = solve(tolerant);
    EXPECT_FALSE(without.tolerance);
    const auto made = [](const Solution& solution) {
        return std::ranges::count_if(solution.cam->limits_along, [](const EnclosedLimit& one) {
            return !one.made.empty() || one.between.has_value();
        });
    };
    EXPECT_EQ(made(without), 0);
    EXPECT_GT(made(with), 0);
    EXPECT_EQ(without.cam->limits_along.size(), 2U);  // one a side
    EXPECT_LT(without.evaluations.profile_points, with.evaluations.profile_points);
    // As often as before there were tolerances, to the last point of the cam: twice the same.
    EXPECT_EQ(solve(plain).evaluations.profile_points, without.evaluations.profile_points);
}

/// The nose of a cam bends most where the made cam's slope is 0: between the ends of its slope error.
TEST(Tolerances, HoldBetweenTheirEnds) {
    const TestScene scene = scene_named("cam_roller")
                                .with("tolerance.profile_um = 20", "tolerance.slope_um_deg = 20",
                                      "tolerance.acceleration_um_deg2 = 1", "limits.cam_radius_min_mm = 9.5");
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.motion);
    ASSERT_TRUE(solution.scene.tolerance);
    bool enclosed = false;
    for (const EnclosedLimit& one : solution.cam->limits_along) {
        if (!one.between) continue;
        EXPECT_TRUE(one.complete) << one.key;
        EXPECT_LE(one.worst, 1e-8) << one.key;
        enclosed = true;
    }
    EXPECT_TRUE(enclosed);
}

TEST(Tolerances, ReportTheirPriceAndWhatDecides) {
    const Solution solution = solve(with_profile(rise()).with("tolerance.base_radius_mm = 0.05"));
    ASSERT_TRUE(solution.tolerance && solution.tolerance->price);
    EXPECT_NEAR(*solution.tolerance->price, 1.2475626440 / 1.2117060211 - 1.0, 1e-7);
    ASSERT_EQ(solution.tolerance->decides.size(), 1U);
    EXPECT_EQ(solution.tolerance->decides[0].limit, "limits.pressure_angle_deg");
    EXPECT_EQ(solution.tolerance->decides[0].tolerance, "tolerance.slope");
    EXPECT_EQ(solution.tolerance->halved.size(), 3U);
    for (const auto& [tolerance, gain] : solution.tolerance->halved) EXPECT_GT(gain, 0.0) << tolerance;
    EXPECT_TRUE(solution.tolerance->open.empty());
    ASSERT_TRUE(solution.tolerance->segments_worth);
    EXPECT_GT(*solution.tolerance->segments_worth, 2);
    EXPECT_LT(*solution.tolerance->segments_worth, 24);
    const auto limit =
        std::ranges::find(solution.constraints, std::string("pressure_angle"), &ConstraintReport::name);
    ASSERT_NE(limit, solution.constraints.end());
    EXPECT_LT(limit->worst, 29.9);
    ASSERT_TRUE(limit->made);
    EXPECT_NEAR(*limit->made, 30.0, 1e-6);
    EXPECT_TRUE(limit->active);
}

/// Five tolerances, each of a size that some shop has.
TestScene with_sizes(const TestScene& scene, const std::array<double, 5>& sizes) {
    constexpr std::array keys = {"profile_um", "slope_um_deg", "acceleration_um_deg2", "base_radius_mm",
                                 "offset_mm"};
    TestScene made = scene;
    for (std::size_t k = 0; k < keys.size(); ++k)
        made = made.set(std::string("tolerance.") + keys[k], sizes[k]);
    return made;
}

/// One tolerance of two equal scenes is larger in one of them.
TEST(Tolerances, RandomPairsCostMoreWithLargerOne) {
    std::mt19937 random(56);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    constexpr std::array largest = {60.0, 10.0, 2.0, 0.2, 0.2};
    const auto objective = [](const Scene& scene) {
        const Solution solution = solve_without_explaining(scene, {});
        if (solution.certificate.verdict == Verdict::infeasible) return infinity;
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
        return solution.certificate.objective;
    };
    int priced = 0;
    const int pairs = scenes_to_try(5, 100);
    for (int pair = 0; pair < pairs; ++pair) {
        const TestScene scene = rise(pair % 2 == 0 ? 5.0 : 0.0)
                                    .set("limits.acceleration", 12.0)
                                    .set("cam.base_radius_mm", 20.0 + 10.0 * part(random));
        std::array<double, 5> sizes{};
        for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = part(random) * largest[k];
        const double less = objective(with_sizes(scene, sizes));
        const auto raised = static_cast<std::size_t>(pair) % sizes.size();
        sizes[raised] += part(random) * largest[raised];
        const double more = objective(with_sizes(scene, sizes));
        EXPECT_TRUE(more >= less || more >= less - 1e-9 * less) << pair << ", " << raised;
        if (std::isfinite(more)) ++priced;
    }
    EXPECT_GE(priced, pairs / 2);
}

TEST(Tolerances, PriceGrowsWithEveryTolerance) {
    double before = 0.0;
    for (const int profile : {0, 10, 20, 40}) {
        const TestScene scene = rise().set("tolerance.base_radius_mm", 0.02 + 0.001 * profile);
        const double own =
            solve(profile > 0 ? scene.set("tolerance.profile_um", profile) : scene).certificate.objective;
        EXPECT_GT(own, before);
        before = own;
    }
}

std::string refusal(const std::function<void()>& use) {
    try {
        use();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(Tolerances, OfForeignNumbersAreRefused) {
    Scene scene = rise();
    scene.tolerance.emplace();
    scene.tolerance->numbers["arm_length"] = {1e-3};
    EXPECT_NE(refusal([&] { validate(scene); }).find("base_radius, roller_radius or offset"),
              std::string::npos);
    EXPECT_NE(
        refusal([] { (void)rise().with("tolerance.profile_deg = 1").read(); }).find("tolerance.profile"),
        std::string::npos);
}

}  // namespace tolerance_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Limits that hold for every cam within the tolerances, against references of independent linear programs
// (docs/tolerances.md) and against cams drawn at random from the tolerances.
#include "scene/limit_table.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/solve/solve.hpp"
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

/// A motion with errors in s, s', s'' that are the same everywhere, SI.
class OffMotion final : public Motion {
 public:
    OffMotion(const Motion& drawn, const std::array<double, 3>& errors, const MotionScale& scale)
        : drawn_(drawn), errors_(errors), scale_(scale) {}
    [[nodiscard]] double begin() const override { return drawn_.begin(); }
    [[nodiscard]] double end() const override { return drawn_.end(); }
    [[nodiscard]] std::vector<double> breakpoints() const override { return drawn_.breakpoints(); }
    [[nodiscard]] MotionPoint at(double x, Side side) const override {
        MotionPoint point = drawn_.at(x, side);
        double unit = scale_.lift;
        for (std::size_t order = 0; order < errors_.size(); ++order, unit /= scale_.unit_angle)
            point.derivative[order] += errors_[order] / unit;
        return point;
    }

 private:
    const Motion& drawn_;
    std::array<double, 3> errors_;
    MotionScale scale_;
};

/// The worst violation of the scene's limits, relative to them, by cams drawn at random from the tolerances
/// and by those at their ends.
double worst_of_made_cams(const Solution& solution, const ToleranceSpec& tolerance, int cams) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    const Scene& scene = solution.scene;
    const MotionScale scale{scene.motion.lift, scene.motion.unit_angle()};
    double worst = -infinity;
    for (int cam = 0; cam < cams; ++cam) {
        const auto part = [&] {  // every other cam at the ends
            const double at = anywhere(random);
            return cam % 2 == 0 ? at : std::copysign(1.0, at);
        };
        std::array<double, 3> errors{};
        for (std::size_t order = 0; order < errors.size(); ++order)
            errors[order] = part() * tolerance.of_motion(order);
        CamReport made;
        made.cam = solution.cam->cam;
        for (const auto& [name, one] : tolerance.numbers)
            made.cam.dimensions.at(static_cast<std::size_t>(scene.cam->written_as(name))) +=
                part() * one.size;
        made.summary = cam_summary(made.cam, OffMotion(*solution.motion, errors, scale), scene);
        for (ConstraintReport one : cam_constraints(scene, made)) {
            one.made.reset();
            worst = std::max(worst, limit_excess(one) / std::max(1.0, std::abs(one.limit)));
        }
    }
    return worst;
}

/// Of a profile of 20 µm (or 20 parts in a million of a turn of the output), and of the first two fixed
/// lengths of the cam, a thousandth.
ToleranceSpec ordinary_tolerance(const Scene& scene) {
    ToleranceSpec tolerance;
    const double size = scene.motion.lift_is_angle ? 1e-4 : 20e-6;
    tolerance.motion = {size, 5.0 * size, 20.0 * size};
    for (const CamDimension& dimension : scene.cam->dimensions) {
        const bool fixed = !dimension.value.is_variable() && dimension.value.low != 0.0;
        if (fixed && !dimension.is_angle && !dimension.value.key.empty() && tolerance.numbers.size() < 2)
            tolerance.numbers[written_name(dimension.value)] = {1e-3 * std::abs(dimension.value.low)};
    }
    return tolerance;
}

class MadeCams : public testing::TestWithParam<const char*> {};

TEST_P(MadeCams, KeepLimitsThatDrawnOnesPass) {
    Scene scene = scene_named(GetParam());
    const ToleranceSpec tolerance = ordinary_tolerance(scene);
    constexpr int cams = 300;
    EXPECT_GT(worst_of_made_cams(solve(scene), tolerance, cams), 1e-5);
    scene.tolerance = tolerance;
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion);
    EXPECT_LE(worst_of_made_cams(solution, tolerance, cams), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, MadeCams,
                         testing::Values("cam_roller", "cam_knife", "cam_flat", "cam_smallest",
                                         "cam_arm_flat", "cam_conjugate", "cam_forces", "linear_press",
                                         "linear_arm", "barrel_paper_cup", "cylinder_slide",
                                         "inverse_feeder"),
                         [](const auto& test) { return std::string(test.param); });

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

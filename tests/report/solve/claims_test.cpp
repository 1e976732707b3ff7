// SPDX-License-Identifier: MIT
// What is said of scenes without a motion, and of limits of any curve, held against solves: every sentence is
// a claim.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/solve/cam_remarks.hpp"
#include "report/solve/infeasible_words.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/least/adjustment.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace camopt {
namespace claims_test {

using testing_support::says;

using enum DimensionIndex;
using units::degree, units::millimetre;

/// DRD, lift 20 mm in 60 deg, quintic, roller of 10 mm on the axis, |φ| <= 30 deg.
Scene roller_scene(int segments, double base_mm) {
    Scene scene;
    scene.motion.lift = 20 * millimetre;
    scene.motion.rise = 60 * degree;
    scene.spline.degree = 5;
    scene.spline.segments = segments;
    scene.objective.velocity = scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    scene.cam = disk_spec({});
    scene.cam->set(base_radius, base_mm * millimetre);
    scene.cam->set(roller_radius, 10 * millimetre);
    scene.limits.pressure_angle = WrittenLimit{30 * degree, "limits.pressure_angle_deg", degree, "deg"};
    scene.solver.explain_changes = 100;
    return scene;
}

PeakLimit cap(const char* key, double value) {
    return {value, key, value, ""};
}

std::string told(const Solution& solution) {
    std::string text;
    for (const std::string& remark : infeasible_remarks(solution)) text += remark + "\n";
    return text;
}

struct Change {
    std::string words;
    double value = 0.0;
};

/// "raise the pressure angle limit to 33.1 deg", "use 6 segments", … as a reader finds them in the text.
std::vector<Change> changes_in(const std::string& text) {
    static const std::regex form(
        "(?:raise|lower|increase|reduce|lengthen|shorten) the ([a-z ]+?)(?: limit)? to "
        "((?:−)?)([0-9.]+(?:e[-+]?[0-9]+)?)");
    static const std::regex segments("use ([0-9]+) segments");
    std::vector<Change> all;
    for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it)
        all.push_back({(*it)[1], ((*it)[2].length() > 0 ? -1.0 : 1.0) * std::atof((*it)[3].str().c_str())});
    if (std::smatch found; std::regex_search(text, found, segments))
        all.push_back({"segments", std::atof(found[1].str().c_str())});
    return all;
}

void apply(Scene& scene, const Change& change) {
    const MotionSpec before = scene.motion;
    const auto peak = [&](std::optional<PeakLimit>& limit) {
        limit->normalised = change.value / limit->unit_per_normalised();
        limit->given = change.value;
    };
    const auto written = [&](std::optional<WrittenLimit>& limit) {
        limit->value = change.value * limit->unit_value;
    };
    const auto dimension = [&](DimensionIndex which) { scene.cam->set(which, change.value * millimetre); };
    const std::map<std::string, std::function<void()>> setters = {
        {"segments", [&] { scene.spline.segments = static_cast<int>(change.value); }},
        {"rise",
         [&] {
             scene.motion.rise = change.value * degree;
             keep_written(scene, before);
         }},
        {"lift",
         [&] {
             scene.motion.lift = change.value * millimetre;
             keep_written(scene, before);
         }},
        {"velocity", [&] { peak(scene.limits.velocity); }},
        {"acceleration", [&] { peak(scene.limits.acceleration); }},
        {"jerk", [&] { peak(scene.limits.jerk); }},
        {"pressure angle", [&] { written(scene.limits.pressure_angle); }},
        {"cam radius", [&] { written(scene.limits.cam_radius_min); }},
        {"contact force", [&] { written(scene.limits.contact_force_min); }},
        {"base radius", [&] { dimension(base_radius); }},
        {"roller radius", [&] { dimension(roller_radius); }},
        {"offset", [&] { dimension(offset); }},
        {"preload", [&] { scene.forces->preload = change.value; }},
        {"spring rate", [&] { scene.forces->spring_rate = change.value * 1e3; }},
        {"speed",
         [&] {
             scene.motion.speed = change.value * units::revolution_per_minute;
             keep_written(scene, before);
         }},
    };
    const auto found = setters.find(change.words);
    ASSERT_NE(found, setters.end()) << change.words;
    found->second();
}

/// How many changes the text offers, each of which is found to do alone.
int expect_each_does(const Scene& scene, const std::string& text) {
    const std::vector<Change> changes = changes_in(text);
    for (const Change& change : changes) {
        Scene changed = scene;
        apply(changed, change);
        const Solution solved = solve(changed);
        EXPECT_TRUE(solved.motion) << change.words << ' ' << change.value << ": "
                                   << name_of(solved.certificate.verdict) << "\n"
                                   << text;
    }
    return static_cast<int>(changes.size());
}

TEST(InfeasibleClaims, OneSplineIsNotEveryMotion) {
    const Scene coarse = roller_scene(4, 20);
    const Solution solution = solve(coarse);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const std::string text = told(solution);
    EXPECT_FALSE(says(text, "any motion"));
    EXPECT_TRUE(says(text, "cannot be satisfied by any spline of 4 quintic segments"));
    EXPECT_TRUE(says(text, "use "));
    EXPECT_GE(expect_each_does(coarse, text), 5);
}

TEST(InfeasibleClaims, TimeCapConcernsOnlyOneSpline) {
    Scene scene = roller_scene(4, 60);
    scene.motion.speed = 300 * units::revolution_per_minute;
    // 5 normalised; every motion needs 4, four quintic segments about 5.9.
    const double unit = scene.motion.lift * std::pow(*scene.motion.speed / scene.motion.rise, 2);
    scene.limits.acceleration = PeakLimit{5.0, "limits.acceleration_m_s2", 5.0 * unit, "m/s^2"};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const std::string text = told(solution);
    EXPECT_FALSE(says(text, "any motion"));
    EXPECT_TRUE(says(text, "any spline of 4 quintic segments"));
    EXPECT_TRUE(says(text, "use "));
    EXPECT_GE(expect_each_does(scene, text), 3);
}

TEST(InfeasibleClaims, ReportEveryMotionWhenNoneExists) {
    // The smallest prime radius is 24.08 mm (docs/cams.md).
    const Solution solution = solve(roller_scene(8, 14.0));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_TRUE(says(told(solution), "cannot be satisfied by any motion that makes the lift in its angle"));
    EXPECT_TRUE(std::ranges::none_of(changes_in(told(solution)), [](const Change& one) {
        return one.words == "segments";
    })) << told(solution);
}

TEST(InfeasibleClaims, MoreSegmentsFixCoarseSpline) {
    Scene scene = roller_scene(2, 60);
    scene.spline.degree = 3;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const std::string text = told(solution);
    EXPECT_EQ(expect_each_does(scene, text), 1) << text;
    EXPECT_TRUE(says(text, "use "));
}

TEST(InfeasibleClaims, EveryReportedChangeWasSolved) {
    Scene turning = roller_scene(4, 20);
    turning.motion.type = MotionType::rr;
    turning.motion.rise = 90 * degree;
    turning.spline.degree = 3;
    turning.limits.pressure_angle->value = 20 * degree;
    Scene capped = roller_scene(12, 30);
    capped.limits.acceleration = cap("limits.acceleration", 3.9);
    for (const Scene& scene : {turning, capped}) {
        const Solution solution = solve(scene);
        ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
        EXPECT_GE(expect_each_does(scene, told(solution)), 1) << told(solution);
    }
}

TEST(InfeasibleClaims, LimitsImpossibleAloneAreRelaxedTogether) {
    Scene scene = roller_scene(12, 20);
    scene.limits.pressure_angle->value = 20 * degree;
    scene.limits.velocity = cap("limits.velocity", 0.9);
    scene.limits.acceleration = cap("limits.acceleration", 3.0);
    scene.solver.explain_seconds = 30.0;  // enough on a busy machine
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const std::string text = told(solution);
    EXPECT_FALSE(says(text, "conflicts with"));
    EXPECT_TRUE(says(text, "A combined change that suffices: "));
    const std::vector<Change> together = changes_in(text.substr(text.find("A combined change")));
    EXPECT_EQ(together.size(), 3U) << text;
    Scene changed = scene;
    for (const Change& change : together) apply(changed, change);
    EXPECT_TRUE(solve(changed).motion) << text;
}

TEST(InfeasibleClaims, SpringsAreTried) {
    Scene scene = roller_scene(12, 40);
    scene.limits.pressure_angle.reset();
    scene.motion.speed = 60.0;
    scene.forces = ForceSpec{.mass = 0.8, .spring_rate = 4000.0, .preload = 20.0, .contact_width = 12e-3};
    scene.limits.contact_force_min = WrittenLimit{10.0, "limits.contact_force_min_n", 1.0, "N"};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const std::string text = told(solution);
    for (const char* part :
         {"increase the preload to ", "increase the spring rate to ", "reduce the speed to "})
        EXPECT_TRUE(says(text, part)) << part << "\n" << text;
    EXPECT_GE(expect_each_does(scene, text), 3);
}

TEST(SmallestCam, TheReturnCountsToo) {
    Scene scene = roller_scene(24, 60);
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 10 * millimetre;
    scene.motion.rise = 120 * degree;
    scene.motion.return_angle = 40 * degree;
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.cam);
    const double tangent = std::tan(30 * degree);
    const double rise = 10.0 / std::expm1(120 * degree * tangent);
    const double back = 10.0 / std::expm1(40 * degree * tangent);
    ASSERT_TRUE(solution.cam->smallest);
    EXPECT_GT(back, 2.0 * rise);
    EXPECT_NEAR(solution.cam->smallest->prime_radius / millimetre, back, 1e-9);
    std::string text;
    for (const std::string& remark : cam_remarks(solution)) text += remark + "\n";
    EXPECT_TRUE(says(text, "on the return"));
    EXPECT_FALSE(says(text, "on this rise"));
}

}  // namespace claims_test
}  // namespace camopt

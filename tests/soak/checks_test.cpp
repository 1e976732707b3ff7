// SPDX-License-Identifier: MIT
// The checks of the soak trials can fail: a true result passes each of them, the same result with one number
// spoiled fails the one that is about it.
#include "tests/soak/figures/cam_extremes.hpp"
#include "tests/soak/figures/law.hpp"
#include "tests/soak/relations/relation.hpp"
#include "tests/soak/run/trial.hpp"
#include "tests/soak/run/worker_pool.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <set>
#include <unistd.h>

namespace camopt::soak {
namespace checks_test {

constexpr const char* motion_scene = R"([motion]
type = "DRD"
lift_mm = 10.0
rise_deg = 120.0
via = [{ at = 0.3, displacement = 0.2 }]
[spline]
degree = 3
segments = 8
[objective]
acceleration = 0.5
jerk = 0.5
rms_jerk = 0.1
[limits]
velocity = 1.8
)";

constexpr const char* cam_scene = R"([motion]
type = "RR"
lift_mm = 10.0
rise_deg = 110.0
speed_rpm = 300.0
[spline]
segments = 10
[objective]
acceleration = 1.0
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = { min = 20.0, max = 40.0 }
roller_radius_mm = 8.0
offset_mm = 2.0
[forces]
mass_kg = 1.0
spring_rate_n_mm = 5.0
preload_n = 60.0
contact_width_mm = 10.0
[limits]
pressure_angle_deg = 32.0
contact_force_min_n = 10.0
[solver]
starts = 1
)";

Solved solved(const char* scene) {
    Solved result = solved_from(SceneText::parse(scene));
    EXPECT_TRUE(result.outcome.refusal.empty()) << result.outcome.refusal;
    EXPECT_TRUE(result.motion.has_value());
    return result;
}

void expect_broken(const Finding& finding) {
    ASSERT_TRUE(finding.has_value());
    EXPECT_FALSE(finding->empty());
}

TEST(SoakChecks, TrueResultsPassAllOfThem) {
    for (const char* scene : {motion_scene, cam_scene}) {
        const Solved result = solved(scene);
        int cases = 0;
        for (const Check& check : checks()) {
            const Finding finding = check.of(result);
            EXPECT_EQ(finding.value_or(""), "") << check.name;
            cases += finding ? 1 : 0;
        }
        EXPECT_GE(cases, 10);
    }
}

TEST(SoakChecks, WrongPeaksAndObjectivesAreNoticed) {
    Solved result = solved(motion_scene);
    result.outcome.peaks["jerk"] *= 1 + 1e-6;
    expect_broken(check_peaks(result));
    *result.outcome.objective *= 1 + 1e-6;
    expect_broken(check_objective(result));
}

TEST(SoakChecks, MovedControlPointsViolateConditions) {
    Solved result = solved(motion_scene);
    result.outcome.spline->coefficients[4] += 1e-6;
    read_motion(result);
    expect_broken(check_peaks(result));
    expect_broken(check_conditions(result));
}

TEST(SoakChecks, FindViolatedPointsCapsAndEnds) {
    const Solved result = solved(motion_scene);
    Solved missed = result;
    *missed.numbers.via[0].value[0] += 1e-6;
    expect_broken(check_conditions(missed));
    Solved passed = result;
    passed.numbers.caps[1]->value = 0.999999 * static_cast<double>(passed.figures.peak[1]);
    expect_broken(check_caps(passed));
    Solved torn = result;
    torn.motion->pieces[3].y[2] += 1e-3;
    expect_broken(check_joints(torn));
}

TEST(SoakChecks, WrongBoundsAndProofsAreNoticed) {
    const Solved result = solved(motion_scene);
    ASSERT_TRUE(result.outcome.proof.has_value());
    Solved above = result;
    above.outcome.lower = *above.outcome.objective + 1e-6;
    expect_broken(check_bound(above));
    Solved open = result;
    open.outcome.lower = *open.outcome.objective - 1e-6;
    expect_broken(check_bound(open));
    Solved bent = result;
    *bent.outcome.proof->bound += 1e-9;
    expect_broken(check_proof(bent));
}

TEST(Polynomial, FindsRootsAndPeaks) {
    // (u − 1/4)(u − 1/2)(u − 3/4)
    const Polynomial cubic = {-3.0L / 32, 11.0L / 16, -1.5L, 1.0L};
    const std::vector<long double> roots = roots_within(cubic, 0, 1);
    ASSERT_EQ(roots.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(static_cast<double>(roots[k]), 0.25 * (static_cast<double>(k) + 1.0), 1e-15);
    EXPECT_NEAR(static_cast<double>(largest_magnitude(cubic, 0, 1)), 3.0 / 32, 1e-18);
    EXPECT_NEAR(static_cast<double>(largest_magnitude({0.0L, 4.0L, -4.0L}, 0, 1)), 1.0, 1e-15);
}

/// A dip between two samples below a broad one that a limit holds near 0.
TEST(CamSurvey, FindsNarrowMinimumNearZero) {
    Motion motion;
    motion.pieces.push_back({0, 1, {0, 0, 0.5}, {}});  // y = x²/2: y' tells the place
    Cam cam;
    cam.follower = "translating_knife";
    cam.base = 1.0;
    const CamSurvey survey(motion, cam);
    constexpr double place = 0.7063;
    EXPECT_NEAR(survey.least([](const CamPoint& p) {
        const double broad = 1e-4 + 10.0 * std::pow(p.velocity - 0.3, 2);
        return std::min(broad, 5e-5 + 3.0 * std::abs(p.velocity - place));
    }),
                5e-5, 1e-9);
}

TEST(SoakChecks, WrongCamsAreNoticed) {
    const Solved result = solved(cam_scene);
    for (const char* figure : {"pressure_angle_deg", "convex_radius_mm", "regularity", "forces.torque_nm",
                               "forces.hertz_pressure_mpa"}) {
        Solved wrong = result;
        ASSERT_TRUE(wrong.outcome.cam.contains(figure)) << figure;
        wrong.outcome.cam[figure] *= 1 + 1e-4;
        expect_broken(check_cam_figures(wrong));
    }
    for (const char* limit : {"pressure_angle", "torque_max", "hertz_pressure_max"}) {
        Solved passed = result;
        passed.numbers.limits[limit] = 0.01;
        expect_broken(check_cam_limits(passed));
    }
    for (const char* limit : {"contact_force_min", "cam_radius_min", "undercut_margin"}) {
        Solved passed = result;
        passed.numbers.limits[limit] = 1e4;
        expect_broken(check_cam_limits(passed));
    }
    Solved outside = result;
    outside.dimensions["base_radius"] = 0.041;
    expect_broken(check_dimensions(outside));
}

/// A least force of 0 is missed by what the largest force leaves of its digits, and by no more.
TEST(SoakChecks, ZeroForceLimitScalesWithForce) {
    Solved result = solved(cam_scene);
    const double largest = result.outcome.cam.at("forces.largest_force_n");
    ASSERT_GT(largest, 10.0);
    bool found = false;
    for (PublishedLimit& limit : result.outcome.limits) {
        if (limit.key != "limits.contact_force_min_n") continue;
        found = true;
        limit.limit = 0.0;
        limit.worst = -1e-10 * largest;
        EXPECT_EQ(check_reported_limits(result).value_or("none"), "");
        limit.worst = -1e-5 * largest;
        expect_broken(check_reported_limits(result));
    }
    EXPECT_TRUE(found);
}

/// Its formulas pass through infinity; what is published is how far it turns.
TEST(SoakChecks, ReversingFaceIsJudgedByRotation) {
    const Solved result = solved(R"(
[motion]
type = "RR"
lift_deg = 23.3
rise_deg = 40.3
return_deg = 36.7
[spline]
segments = 8
[objective]
acceleration = 1.0
[cam]
type = "disk"
follower = "oscillating_flat"
center_distance_mm = 244.7
base_radius_mm = 96.9
[limits]
pressure_angle_deg = 2.6
)");
    EXPECT_EQ(check_cam_figures(result).value_or("none"), "");
    Solved wrong = result;
    ASSERT_LT(wrong.outcome.cam.at("regularity"), 0.0);
    wrong.outcome.cam["regularity"] *= 1 + 1e-4;
    expect_broken(check_cam_figures(wrong));
    wrong = result;
    wrong.outcome.cam["contact_offset_mm"] = 300.0;
    expect_broken(check_cam_figures(wrong));
    wrong = result;
    wrong.numbers.limits["undercut_margin"] = 0.0;
    expect_broken(check_cam_limits(wrong));
}

TEST(SoakChecks, MissingNumbersAndTimeoutsAreFound) {
    const Solved result = solved(motion_scene);
    Solved missing = result;
    missing.outcome.lower.reset();
    expect_broken(check_json(missing));
    Solved broken = result;
    broken.outcome.repeatable += R"("jerk":nan)";
    expect_broken(check_json(broken));
    Solved late = result;
    late.outcome.processor_seconds = 1.2 * late.numbers.max_seconds + 1.0;
    expect_broken(check_time(late));
}

TEST(SoakAgreement, WorseAndContradictingAnswersAreNoticed) {
    const Outcome one = solved(motion_scene).outcome;
    Outcome worse = one;
    *worse.objective += 1e-4;
    *worse.lower += 1e-4;
    EXPECT_EQ(never_worse(one, worse).value_or("none"), "");
    expect_broken(never_worse(worse, one));
    Outcome none = one;
    none.verdict = "infeasible";
    expect_broken(same_answer(none, one));
    none.verdict = "failed";
    expect_broken(same_answer(one, none));
}

/// A trial whose every other solve says what it is told to.
class RepeatedTrial final : public Trial {
 public:
    RepeatedTrial(Solved first, Solved again) : first_(std::move(first)), again_(std::move(again)) {}
    [[nodiscard]] const Solved& base() const override { return first_; }
    Draw& draw() override { return draw_; }
    Solved solve(const SceneText&) override { return again_; }

 private:
    Solved first_, again_;
    Draw draw_{1, 1};
};

TEST(SoakAgreement, TimedOutRepetitionMayDiffer) {
    Solved one = solved(motion_scene);
    one.outcome.wall_seconds = 0.0;
    Solved other = one;
    other.outcome.repeatable += " ";
    RepeatedTrial silent(one, other);
    expect_broken(compare_repeated(silent));
    other.outcome.unsettled = {"spline.segments"};
    RepeatedTrial told(one, other);
    EXPECT_FALSE(compare_repeated(told).has_value());
    RepeatedTrial same(one, one);
    EXPECT_EQ(compare_repeated(same).value_or("none"), "");
}

/// How long the search takes is the machine's: of times that grow by a half one ends it.
TEST(SoakAgreement, TimeoutIsReadFromResult) {
    for (double seconds = 0.002; seconds < 10.0; seconds *= 1.5) {
        const Solved hurried = solved_from(SceneText::parse(fmt::format(R"([motion]
type = "RR"
rise_deg = 163.9
return_deg = 112.2
[spline]
degree = 5
breakpoints = [0.0, 1.1874, 1.6845637583892619]
continuity = 4
[objective]
jerk = 1.0
[limits]
velocity = 1.61
[solver]
max_seconds = {}
)",
                                                                        seconds)));
        if (hurried.outcome.unsettled.empty()) continue;
        EXPECT_EQ(hurried.outcome.verdict, "infeasible") << hurried.outcome.refusal;
        return;
    }
    FAIL() << "no time ended the search";
}

TEST(SoakChecks, InfeasibleNeedsSomeProof) {
    Solved claimed = solved(motion_scene);
    claimed.outcome.verdict = "infeasible";
    expect_broken(check_infeasibility(claimed));  // it has a motion
    claimed.outcome.spline.reset();
    expect_broken(check_infeasibility(claimed));  // by a bound of the objective
    claimed.outcome.proof.reset();
    expect_broken(check_infeasibility(claimed));
    claimed.outcome.proof_kind = "boxes";
    expect_broken(check_infeasibility(claimed));  // boxes without their steps
    claimed.outcome.has_box_proof = true;
    EXPECT_EQ(check_infeasibility(claimed).value_or("none"), "");
}

TEST(SoakLaws, HaveTheFiguresOfTheHandbooks) {
    const auto sine = law_figures("modified_sine");
    EXPECT_NEAR(sine.at("velocity"), 1.759603385953771, 1e-12);
    EXPECT_NEAR(sine.at("acceleration"), 5.527957070544091, 1e-12);
    EXPECT_NEAR(sine.at("jerk"), 69.46635729, 1e-7);
    EXPECT_NEAR(law_figures("polynomial_4567").at("acceleration"), 7.513188, 1e-6);
    for (const std::string& law : known_laws()) EXPECT_NEAR(law_at(law, 1.0, true)[0], 1.0, 1e-13) << law;
}

TEST(SoakScenes, AreReproducibleAndReadBackUnchanged) {
    for (int number = 0; number < 50; ++number) {
        Draw one(3, static_cast<std::uint64_t>(number));
        Draw other(3, static_cast<std::uint64_t>(number));
        const std::string scene = drawn_cam_scene(one, {}).text();
        EXPECT_EQ(scene, drawn_cam_scene(other, {}).text());
        EXPECT_EQ(scene, SceneText::parse(scene).text());
    }
}

/// Two workers were killed at once, in the middle of quick solves, when the machine had stood still.
TEST(SoakWorkers, PausedMachineIsNotHangingWorker) {
    const Patience::Clock::time_point begin{};
    Patience patience(begin);
    patience.look(begin + std::chrono::milliseconds(400));
    EXPECT_EQ(patience.waited(), std::chrono::milliseconds(400));
    patience.look(begin + std::chrono::hours(1));
    EXPECT_EQ(patience.waited(), std::chrono::milliseconds(1400));
    for (int k = 1; k <= 100; ++k)
        patience.look(begin + std::chrono::hours(1) + k * std::chrono::milliseconds(100));
    EXPECT_EQ(patience.waited(), std::chrono::milliseconds(11400));
}

TEST(SoakWorkers, CrashesAndHangsCountOnce) {
    std::multiset<std::string> faults;
    std::multiset<std::string> lines;
    const Worker worker{[](int number, const std::function<void(const std::string&)>& tell) {
                            tell("begun\n");
                            if (number == 1) ::raise(SIGKILL);
                            while (number == 2) ::pause();
                        },
                        [&](int, const std::string& line) { lines.insert(line); },
                        [&](int, const std::string& fault) { faults.insert(fault); }};
    run_in_processes(4, 2, 0.5, worker);
    EXPECT_EQ(lines.count("begun"), 4U);
    EXPECT_EQ(faults, (std::multiset<std::string>{"", "", "worker died: signal 9", "hung and was killed"}));
}

}  // namespace checks_test
}  // namespace camopt::soak

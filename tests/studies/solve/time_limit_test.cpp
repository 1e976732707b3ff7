// SPDX-License-Identifier: MIT
// solver.max_seconds is the time of everything: search, proof, tie-break, explanation.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/counting_clock.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace camopt {
namespace time_limit_test {

using namespace testing_support;

struct Case {
    std::string name, scene;
    std::vector<std::string> settings;
    std::string solver = "auto";
    friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

Scene scene_of(const Case& one) {
    return scene_named(one.scene).with_all(one.settings).set("solver.name", one.solver);
}

bool tells_of_the_time(const Solution& solution) {
    return std::ranges::any_of(solution.notes, [](const std::string& note) {
        return note.find("the time (solver.max_seconds") != std::string::npos;
    });
}

// The clock is asked at every iteration, and some ten nested searches may each ask once more on their way
// out.
constexpr long most_asked_late = 60;

class TimeLimit : public testing::TestWithParam<Case> {
 protected:
    void SetUp() override {
        if (!is_available(GetParam().solver))
            GTEST_SKIP() << GetParam().solver << " is not part of this build";
    }
};

TEST_P(TimeLimit, HoldsAtEveryStage) {
    Scene scene = scene_of(GetParam());
    scene.solver.max_seconds = 1e12;
    scene.solver.explain_seconds = 1e11;  // far above what is read: max_seconds governs when it is hurried
    CountingClock whole;
    const Solution unhurried = solve(scene, whole.control());
    EXPECT_FALSE(tells_of_the_time(unhurried));
    EXPECT_GE(whole.readings, unhurried.solver.iterations) << "an iteration that does not ask";
    for (const double part : {0.0, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95}) {
        scene.solver.max_seconds = std::max(1.0, std::floor(part * static_cast<double>(whole.readings)));
        CountingClock clock;
        const Solution hurried = solve(scene, clock.control());
        EXPECT_LE(static_cast<double>(clock.readings), scene.solver.max_seconds + most_asked_late)
            << part << " of " << whole.readings;
        EXPECT_TRUE(tells_of_the_time(hurried)) << part << " of " << whole.readings;
        const Certificate& certificate = hurried.certificate;
        EXPECT_EQ(hurried.motion == nullptr,
                  certificate.verdict == Verdict::failed || certificate.verdict == Verdict::infeasible);
        if (certificate.verdict == Verdict::failed) {
            EXPECT_EQ(certificate.reason, "time_limit") << part;
            EXPECT_FALSE(certificate.gap);
        }
        if (hurried.motion && certificate.lower_bound) {
            EXPECT_TRUE(std::isfinite(*certificate.lower_bound)) << part;
            EXPECT_LE(*certificate.lower_bound, certificate.objective * (1.0 + 1e-7)) << part;
        }
    }
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"tie_break", "drd_cubic_12", {}},
        {"elastic_search", "drd_cubic_12", {"limits.velocity=1.55"}},
        {"infeasible", "infeasible_velocity_cap", {}},
        {"infeasible_cam", "cam_infeasible", {"spline.segments=8"}},
        {"in_vain", "cam_infeasible", {"spline.segments=6", "limits.cam_radius_min_mm=8", "solver.starts=2"}},
        {"starts", "cam_undercut", {"spline.segments=8", "solver.starts=3"}},
        {"starts_structured", "cam_undercut", {"spline.segments=8", "solver.starts=2"}, "structured"},
        {"free_breakpoints", "drd_free_knots", {"spline.segments=5", "solver.starts=2"}},
        {"ipopt", "drd_cubic_12", {}, "ipopt"},
        {"slsqp", "drd_cubic_8", {}, "nlopt.slsqp"},
        {"cobyla", "drd_cubic_4", {}, "nlopt.cobyla"},
        {"ccsaq", "drd_cubic_4", {}, "nlopt.ccsaq"},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, TimeLimit, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

/// One test by the machine's clock, generous: many times the limit are wrong on every machine. The search
/// ends early; the explanation after it must not start a second time limit.
TEST(TimeLimit, IncludesExplanation) {
    Scene scene = scene_of({"", "cam_infeasible", {"limits.cam_radius_min_mm=8", "spline.segments=24"}});
    scene.solver.max_seconds = 0.3;
    const Stopwatch watch;
    const Solution solution = solve(scene);
    EXPECT_LT(watch.seconds(), 1.5);
    EXPECT_FALSE(solution.motion);
}

/// What the clock ended before anything was found was no search in vain.
TEST(TimeLimit, TimeoutIsNotInfeasibilityOfDisplacements) {
    Scene scene = program({spline(60, 1.0), spline(60), spline(60, 0.25)}, 40);
    scene.motion.closed = false;
    scene.objective = {};
    scene.objective.velocity = scene.objective.jerk = 1.0;
    scene.solver.max_seconds = 1e-3;
    const Solution solution = solve(scene);
    EXPECT_FALSE(solution.motion);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "time_limit");
    EXPECT_TRUE(tells_of_the_time(solution));
}

TEST(Interrupted, BeforeAnythingWasFoundDeliversNoMotion) {
    for (const char* solver : {"structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"}) {
        if (!is_available(solver)) continue;
        SolveControl control;
        control.stop_requested = [] { return true; };
        for (const char* scene : {"drd_cubic_12", "cam_undercut", "drd_free_knots"}) {
            if (scene == std::string("drd_free_knots") && solver != std::string("structured")) continue;
            const Solution solution = solve(scene_of({"", scene, {}, solver}), control);
            EXPECT_FALSE(solution.motion) << solver << ' ' << scene;
            EXPECT_EQ(solution.certificate.verdict, Verdict::failed) << solver << ' ' << scene;
            EXPECT_EQ(solution.certificate.reason, "interrupted") << solver << ' ' << scene;
            EXPECT_EQ(solution.solver.termination, Termination::interrupted) << solver << ' ' << scene;
        }
    }
}

TEST(Interrupted, UnsuccessfulSearchReportsInterruption) {
    Scene scene = scene_of({"", "cam_undercut", {"limits.cam_radius_min_mm=200", "spline.segments=8"}});
    CountingClock clock;
    int polls = 0;
    SolveControl control;
    control.stop_requested = [&] { return ++polls > 40; };
    const Solution solution = solve(scene, control);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    EXPECT_LE(polls, 40 + most_asked_late);
}

}  // namespace time_limit_test
}  // namespace camopt

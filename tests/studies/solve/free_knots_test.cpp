// SPDX-License-Identifier: MIT
// Scenes with free breakpoints against the lower bound for every curve and against fixed breakpoints.
#include "solvers/structured/structured_solver.hpp"
#include "studies/search/free_knot_descent.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace free_knots_test {

using namespace testing_support;

Scene scene_of(MotionType type, int degree, int segments) {
    Scene scene = paper_objective(type, degree, segments);
    scene.spline.free_knots = true;
    scene.solver.starts = 1;
    return scene;
}

Scene fixed(Scene scene) {
    scene.spline.free_knots = false;
    return scene;
}

void expect_ascending(const Solution& solution) {
    ASSERT_TRUE(solution.curve);
    const std::vector<double>& points = solution.curve->space().breakpoints();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_GT(points[i + 1], points[i]);
    EXPECT_EQ(points.front(), 0.0);
    EXPECT_NEAR(points.back(), solution.scene.motion.length(), 1e-12);
    EXPECT_EQ(solution.design.names.front(), "x[1]");
    EXPECT_EQ(solution.design.values[0], points[1]);
}

TEST(FreeKnotSolve, SevenSegmentsReachTheLimit) {
    const Solution solution = solve(scene_of(MotionType::drd, 3, 7));
    EXPECT_NEAR(solution.certificate.objective, 0.9371963699, 1e-7);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::any_curve_limit);
    EXPECT_EQ(solution.solver.starts, 1);
    EXPECT_NEAR(solution.peaks.velocity.value, 1.7455851, 1e-3);  // the cost is flat there
    expect_ascending(solution);
    // τ = A/J and V/A of the double-S.
    EXPECT_NEAR(solution.curve->space().breakpoints()[1], 5.2837114 / 54.609086, 1e-4);
    EXPECT_NEAR(solution.curve->space().breakpoints()[2], 1.7455851 / 5.2837114, 1e-4);
}

/// The switching points of the limit curve are the breakpoints: two solves of a small program, no search.
TEST(FreeKnotSolve, LimitCurveNeedsNoSearch) {
    struct Case {
        MotionType type;
        int segments;
        double back;  ///< return / rise
        bool symmetric;
    };
    for (const Case& one : {Case{MotionType::drd, 7, 1.0, false}, Case{MotionType::drd, 10, 1.0, false},
                            Case{MotionType::drd, 12, 1.0, true}, Case{MotionType::rr, 16, 1.0, false},
                            Case{MotionType::rr, 15, 1.0, true}, Case{MotionType::rr, 13, 0.6, false},
                            Case{MotionType::rr, 20, 3.0, false}}) {
        Scene scene = scene_of(one.type, 3, one.segments);
        scene.motion.symmetric = one.symmetric;
        scene.motion.rise = 1.0;
        if (one.type == MotionType::rr) scene.motion.return_angle = one.back * scene.motion.rise;
        const Solution solution = solve(scene);
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << one.segments << ' ' << one.back;
        EXPECT_EQ(solution.certificate.proof_kind, ProofKind::any_curve_limit);
        EXPECT_NEAR(solution.certificate.objective, solution.any_curve_limit->objective, 1e-8);
        EXPECT_LE(solution.solver.iterations, 60) << one.segments << ' ' << one.back;
        EXPECT_EQ(solution.curve->space().segments(), one.segments);
        expect_ascending(solution);
        if (one.back == 1.0 && one.type == MotionType::rr) {
            EXPECT_NEAR(solution.certificate.objective, 0.8521595, 1e-7);
        }
    }
}

TEST(FreeKnotSolve, NeverWorseThanFixedOnes) {
    for (const MotionType type : {MotionType::drd, MotionType::rr}) {
        for (const int degree : {3, 5}) {
            const Scene scene = scene_of(type, degree, 6);
            const Solution free = solve(scene);
            const Solution uniform = solve(fixed(scene));
            EXPECT_LT(free.certificate.objective, uniform.certificate.objective - 1e-4) << degree;
            EXPECT_LE(free.certificate.worst_violation, 1e-9);
            EXPECT_GE(free.certificate.objective, free.any_curve_limit->objective - 1e-9);
            expect_ascending(free);
        }
    }
}

TEST(FreeKnotSolve, FourSegmentsReportLocalOptimum) {
    const Solution solution = solve(scene_of(MotionType::drd, 3, 4));
    EXPECT_NEAR(solution.certificate.objective, 1.0444566874, 1e-6);
    EXPECT_NE(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.certificate.lower_bound);
    EXPECT_NEAR(*solution.certificate.lower_bound, 0.9371963699, 1e-9);
    EXPECT_FALSE(solution.certificate.proof);
}

TEST(FreeKnotSolve, SymmetricMotionsStaySymmetric) {
    Scene scene = scene_of(MotionType::drd, 3, 7);
    scene.motion.symmetric = true;
    const Solution solution = solve(scene);
    EXPECT_NEAR(solution.certificate.objective, 0.9371963699, 1e-7);
    const std::vector<double>& points = solution.curve->space().breakpoints();
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(points[i] + points[points.size() - 1 - i], 1.0, 1e-12);
}

TEST(FreeKnotSolve, CapsAreSatisfied) {
    Scene scene = scene_of(MotionType::drd, 3, 7);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.6);
    const Solution solution = solve(scene);
    EXPECT_LE(solution.peaks.velocity.value, 1.6 + 1e-8);
    ASSERT_TRUE(solution.any_curve_limit);
    EXPECT_NEAR(solution.certificate.objective, solution.any_curve_limit->objective, 1e-6);
}

TEST(FreeKnotSolve, FreeBreakpointsSatisfyTighterLimits) {
    Scene scene = scene_of(MotionType::drd, 3, 7);
    scene.limits.jerk = normalised_limit("limits.jerk", 33.0);
    ASSERT_EQ(solve(fixed(scene)).certificate.verdict, Verdict::infeasible);
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion);
    EXPECT_LE(solution.peaks.jerk.value, 33.0 * (1.0 + 1e-8));
}

TEST(FreeKnotSolve, ExactPointsAreSatisfied) {
    Scene scene = scene_of(MotionType::drd, 3, 8);
    scene.motion.via.push_back({0.3, 0.25, {}, {}});
    const Solution free = solve(scene);
    const Solution uniform = solve(fixed(scene));
    EXPECT_LT(free.certificate.objective, uniform.certificate.objective);
    EXPECT_NEAR(free.motion->at(0.3).derivative[0], 0.25, 1e-10);
}

TEST(FreeKnotSolve, CoalescingBreakpointsStayApart) {
    Scene scene = scene_of(MotionType::drd, 3, 7);
    scene.objective.velocity = scene.objective.jerk = 0.0;  // bang-bang acceleration, A = 4, is best
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion);
    EXPECT_GT(solution.peaks.acceleration.value, 4.0);
    EXPECT_LT(solution.peaks.acceleration.value, 4.2);
    const std::vector<double>& points = solution.curve->space().breakpoints();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        EXPECT_GE(points[i + 1] - points[i], 0.01 / 7.0 * (1.0 - 1e-9));
}

/// All breakpoints crowded in the middle, the optimum far off.
TEST(FreeKnotDescent, LeavesCrowdedBreakpoints) {
    for (const int segments : {5, 7, 8}) {
        Scene scene;
        scene.objective.acceleration = 1.0;
        std::vector<double> crowded{0.0};
        for (int i = 1; i < segments; ++i) crowded.push_back(0.5 + 0.02 * (i - 0.5 * segments));
        crowded.push_back(1.0);
        const MovingBreakpoints breakpoints(scene, reference_peaks(scene), {}, crowded);
        FreeKnotOptions options;
        options.exchange.backend.max_seconds = 60.0;
        const FreeKnotResult result = descend(breakpoints, nullptr, *make_structured_solver(), options, {});
        EXPECT_NEAR(result.found.objective, 0.726, 1e-3) << segments;
    }
}

TEST(MovingBreakpoints, SymmetricOnesMoveInPairs) {
    for (const int segments : {6, 7}) {
        Scene scene = paper_objective(MotionType::drd, 3, segments);
        scene.motion.symmetric = true;
        const MovingBreakpoints breakpoints(scene, reference_peaks(scene), {}, start_breakpoints(scene));
        ASSERT_EQ(breakpoints.size(), (segments - 1) / 2);
        Eigen::VectorXd moves = Eigen::VectorXd::LinSpaced(breakpoints.size(), 0.1, 0.3);
        const std::vector<double> points = breakpoints.points(moves);
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_NEAR(points[i] + points[points.size() - 1 - i], 1.0, 1e-15);
        EXPECT_NEAR(points[1], 1.1 / segments, 1e-15);
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(moves.size());
        const Eigen::VectorXd room = breakpoints.room(still) + breakpoints.room_slope() * moves;
        EXPECT_LT((breakpoints.room(moves) - room).lpNorm<Eigen::Infinity>(), 1e-14);
        EXPECT_NEAR(breakpoints.room(still)[0], 0.99, 1e-14);
    }
}

/// The ends of a region are breakpoints that stay, and the others stay outside it.
TEST(FreeKnotSolve, RegionsStayStraight) {
    const TestScene scene =
        scene_named("drd_constant_velocity").with("spline.segments = 7", "solver.starts = 1");
    const Solution fixed_ones = solve(scene), free = solve(scene.with("spline.knots = free"));
    ASSERT_TRUE(free.motion);
    EXPECT_LT(free.certificate.objective, fixed_ones.certificate.objective - 1e-3);
    const std::vector<double>& points = free.curve->space().breakpoints();
    EXPECT_EQ(points.size(), fixed_ones.curve->space().breakpoints().size());
    for (const double end : {0.4, 0.6})
        EXPECT_TRUE(std::ranges::any_of(points, [&](double at) { return std::abs(at - end) < 1e-12; }));
    for (const double at : {0.42, 0.5, 0.58}) EXPECT_NEAR(free.motion->at(at).derivative[2], 0.0, 1e-8);
}

/// Every kind of scene has free breakpoints: with rules that the search knows nothing of, in all spline
/// segments of a program, next to other numbers that are searched.
struct Pair {
    const char* name;
    const char* scene;
    std::vector<std::string> settings = {};
    double gain = 1e-3;  ///< of the objective on uniform breakpoints, relative
};

class FreeKnotPairs : public testing::TestWithParam<Pair> {};

TEST_P(FreeKnotPairs, ImproveOnFixedOnes) {
    const Pair& pair = GetParam();
    const TestScene scene = scene_named(pair.scene)
                                .with("spline.segments = 6", "solver.starts = 1", "solver.max_seconds = 20",
                                      "solver.explain_seconds = 0.001")
                                .with_all(pair.settings);
    const Solution uniform = solve(scene), free = solve(scene.with("spline.knots = free"));
    ASSERT_TRUE(free.motion);
    if (uniform.motion) {
        const double objective = uniform.certificate.objective;
        EXPECT_LE(free.certificate.objective, objective - pair.gain * std::abs(objective) + 1e-9);
    }
    EXPECT_LE(free.certificate.worst_violation, free.scene.solver.tolerance);
    EXPECT_TRUE(free.certificate.verdict == Verdict::local || free.certificate.verdict == Verdict::feasible);
    EXPECT_FALSE(free.certificate.proof);
    EXPECT_TRUE(free.scene.spline.free_knots);
    EXPECT_NE(std::ranges::find(free.design.names, "x[1]"), free.design.names.end());
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, FreeKnotPairs,
    testing::Values(Pair{"program", "cam_drdrd"}, Pair{"law", "cam_laws_and_splines"},
                    Pair{"region", "drd_constant_velocity"}, Pair{"program_set_points", "pusher_set_points"},
                    Pair{"corridor", "corridors", {}, 0.0}, Pair{"sided_limit", "sided_program"},
                    Pair{"moving_end",
                         "49_moving_start",
                         {"limits.velocity_mm_s = 2000", "limits.jerk_m_s3 = 20000",
                          "limits.acceleration_m_s2 = 400"}},
                    Pair{"area", "valve_lobe"}, Pair{"response", "elastic_slide"},
                    Pair{"motor", "servo_slide"}, Pair{"motor_program", "servo_there_and_back"},
                    Pair{"harmonics", "surge_valve", {"limits.spring_harmonic_um = 100"}},
                    Pair{"angles", "program_constant_velocity"}, Pair{"closed", "ring_of_two_splines"},
                    Pair{"relative", "rotary_knife"}, Pair{"repeat", "repeat_refused_breakpoints"},
                    Pair{"free_displacement", "lifter_free_velocity", {}, 0.0},
                    Pair{"cam_of_any_radius", "cam_smallest"}),
    [](const auto& one) { return std::string(one.param.name); });

/// What the search found is lost where it is stopped before the solve on the breakpoints found: the motion on
/// the first ones is delivered then, and is no local optimum of free ones.
TEST(FreeKnotSolve, InterruptedSolveClaimsNoOptimum) {
    Scene scene = scene_of(MotionType::drd, 3, 6);
    scene.solver.starts.reset();
    const double at_start = solve(fixed(scene)).certificate.objective;
    int stopped = 0;
    for (double most = 100.0; most < 1e4; most *= 1.5) {
        int polls = 0;
        SolveControl control;
        control.stop_requested = [&] { return ++polls > most; };
        const Certificate certificate = solve(scene, control).certificate;
        if (polls <= most) break;
        ++stopped;
        if (certificate.objective < at_start - 1e-6) continue;
        EXPECT_EQ(certificate.verdict, Verdict::feasible) << most;
        EXPECT_EQ(certificate.reason, Reason::interrupted) << most;
    }
    EXPECT_GT(stopped, 5);
}

/// Promised for a move as large as the motion, not for one as short as the step: on uniform breakpoints, 15 %
/// from the optimum, it is no small number.
TEST(FreeKnotDescent, StationarityIgnoresStepLength) {
    const Scene scene = scene_of(MotionType::drd, 3, 6);
    FreeKnotOptions options;
    for (int most = 5; most < 200; ++most) {
        const MovingBreakpoints breakpoints(scene, reference_peaks(scene), {}, start_breakpoints(scene));
        int polls = 0;
        SolveControl control;
        control.stop_requested = [&] { return ++polls > most; };
        const FreeKnotResult result =
            descend(breakpoints, nullptr, *make_structured_solver(), options, control);
        if (!std::isfinite(result.stationarity)) continue;
        EXPECT_GT(result.stationarity, 0.02);
        return;
    }
    ADD_FAILURE() << "no step was judged";
}

}  // namespace free_knots_test
}  // namespace camopt

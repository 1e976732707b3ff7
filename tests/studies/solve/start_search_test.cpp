// SPDX-License-Identifier: MIT
// Searches from several starts: the structured solver needs few passes where rules are not convex, and does
// not find the same minimum twice.
#include "studies/search/start_search.hpp"

#include "objectives/scene_model.hpp"
#include "scene/written_limits.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/search/stroke_excursions.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace start_search_test {

using namespace testing_support;

constexpr int starts = 8;
constexpr unsigned seed = 1;

/// Its cam may be no sharper than 5 mm: a rule that is not convex, and bites.
Scene sharp_cam(int segments) {
    return pressure_angle_scene(30, segments)
        .with("motion.lift_mm = 10", "motion.rise_deg = 45", "cam.roller_radius_mm = 9",
              "limits.cam_radius_min_mm = 5");
}

struct Searched {
    int starts, rounds, passes;
    double objective;
};

Searched searched(const Scene& scene, int end, const SolveControl& control = {}) {
    const auto solver = make_structured_solver();
    const ExchangeOptions exchange;
    const JudgeOptions judge{1e-8};
    StartSearch search(CamProblem(scene_model(scene, DesignKind::states, reference_peaks(scene))), *solver,
                       exchange, judge, control);
    search.run(0, end, seed, {});
    EXPECT_TRUE(search.found());
    return {search.ran(), search.totals().rounds, search.totals().iterations, search.best().found.objective};
}

/// The convexified Hessian held steps to rows that were not active: up to 200 passes a grid, all of one
/// length.
TEST(StartSearch, LeavesRowsThatAreNotActive) {
    for (const int segments : {12, 24}) {
        const Searched first = searched(sharp_cam(segments), 1);
        EXPECT_LE(first.passes, 60) << segments;
        const Certificate proved = solve(sharp_cam(segments)).certificate;
        EXPECT_EQ(proved.verdict, Verdict::optimal);
        EXPECT_NEAR(first.objective, proved.objective, 1e-7);
    }
}

/// All eight lead to the same minimum: seven end beside it, before their last digits.
TEST(StartSearch, StopsNearKnownMinimum) {
    const Scene scene = sharp_cam(24);
    const Searched first = searched(scene, 1), all = searched(scene, starts);
    EXPECT_EQ(all.starts, starts);
    EXPECT_NEAR(all.objective, first.objective, 1e-8);
    EXPECT_GT(all.passes, first.passes);
    EXPECT_LE(all.passes - first.passes, 5 * (starts - 1));
}

/// The limit on searches in vain strikes while the first start has just found a motion within the limits:
/// that one goes on to its end, and the others are begun.
TEST(StartSearch, FoundPointIsReported) {
    const Scene scene = sharp_cam(12);
    const double tolerance = ExchangeOptions().tolerance;
    SolveControl control;
    double now = 0.0;
    control.in_vain = Deadline::after(1.0, [&now] { return now; });
    control.progress = [&](const Progress& progress) {
        if (progress.violation && *progress.violation <= tolerance) now = 2.0;
    };
    const Searched struck = searched(scene, 3, control);
    EXPECT_TRUE(control.in_vain.passed()) << "nothing was shown";
    EXPECT_EQ(struck.starts, 3);
    EXPECT_NEAR(struck.objective, searched(scene, 3).objective, 1e-8);
}

/// A backend that never finds a point.
class IdleSolver final : public Solver {
 public:
    std::string_view name() const override { return "idle"; }
    BackendResult minimize(const Nlp&, const Eigen::VectorXd&, const BackendOptions&,
                           const SolveControl&) const override {
        BackendResult result;
        result.termination = Termination::numerical_failure;
        return result;
    }
};

TEST(StartSearch, NextSolverFollowsFailedOne) {
    const Scene scene = with_written_limits(sharp_cam(12));
    PosedScene posed(scene);
    const SolveControl control;
    KnownSolutions none;
    SolvePlan plan = plan_of(posed);
    plan.proof = ProofKind::none;
    plan.starts = 2;
    plan.next_solver.clear();
    const StartsResult alone = solve_from_starts({posed, plan, control, none}, posed.model, IdleSolver());
    EXPECT_FALSE(alone.next_solver_ran);
    EXPECT_EQ(alone.result.certificate.reason, Reason::no_feasible_point);
    plan.next_solver = "structured";
    const StartsResult found = solve_from_starts({posed, plan, control, none}, posed.model, IdleSolver());
    EXPECT_TRUE(found.next_solver_ran && found.found_by_next);
    EXPECT_EQ(found.starts, plan.starts);
    EXPECT_NEAR(found.result.certificate.objective, searched(scene, 1).objective, 1e-7);
}

/// Its relaxation settles it; the rules of its strokes follow.
TEST(StartSearch, RelaxationThatLeavesStrokesEndsSolve) {
    const Scene scene = with_written_limits(scene_named("cam_conjugate"));
    PosedScene posed(scene);
    const SolvePlan plan = plan_of(posed);
    const SolveControl control;
    KnownSolutions none;
    bool leaves_strokes = false;
    const StartsResult ended =
        solve_from_starts({posed, plan, control, none, &leaves_strokes}, posed.model, IdleSolver());
    EXPECT_TRUE(leaves_strokes);
    EXPECT_EQ(ended.starts, 0);
    EXPECT_EQ(ended.result.x.size(), 0);
    const Solution held = solve(scene);
    EXPECT_EQ(held.certificate.verdict, Verdict::optimal);
    EXPECT_LT(*ended.result.certificate.lower_bound, held.certificate.objective);
    EXPECT_FALSE(leaves_its_strokes(held));
}

/// Boxes are halved in an order that a last digit of the motion at hand could change.
TEST(StartSearch, LastDigitsDoNotChangeBound) {
    const Certificate usual = solve(scene_named("drd_torque")).certificate;
    const Certificate loose = solve(scene_named("drd_torque").with("solver.tolerance = 1e-8")).certificate;
    EXPECT_NE(usual.objective, loose.objective);
    EXPECT_NEAR(usual.objective, loose.objective, 1e-7);
    EXPECT_EQ(usual.verdict, Verdict::optimal);
    EXPECT_EQ(usual.lower_bound, loose.lower_bound);
}

TEST(StartSearch, SearchesOnceFromAStart) {
    const Scene scene = sharp_cam(12);
    CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const ExchangeResult direct =
        minimize_by_exchange(problem, *make_structured_solver(), problem.start(), {}, {});
    const Searched once = searched(scene, 1);
    EXPECT_EQ(once.rounds, direct.rounds);
    EXPECT_EQ(once.passes, direct.iterations);
}

}  // namespace start_search_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Motions that are proved optimal for other weights without a solve.
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace camopt {
namespace proved_optima_test {

using namespace testing_support;

Scene weighted(const std::array<double, 3>& weights, int segments = 12) {
    return with_weights(paper_objective(MotionType::drd, 3, segments), weights);
}

Solution neighbour(const Scene& scene, KnownSolutions& known) {
    Solution solution = solve_without_explaining(scene, {}, &known);
    ++known.number;
    return solution;
}

/// The claim holds without its claimant: the bound follows from the stored numbers, and the cold solve
/// agrees.
TEST(ProvedOptima, WholeLatticeEqualsColdSolves) {
    const SweepAxis lattice = simplex_weights(12);
    KnownSolutions known;
    int reused = 0;
    for (int row = 0; row < lattice.points(); ++row) {
        SCOPED_TRACE(row);
        const auto point = lattice.point(row);
        const Scene scene = weighted({point[0], point[1], point[2]});
        const Solution found = neighbour(scene, known);
        const Certificate& certificate = found.certificate;
        EXPECT_EQ(certificate.verdict, Verdict::optimal);
        if (!found.solver.proved_from) continue;
        ++reused;
        EXPECT_LT(*found.solver.proved_from, row);
        ASSERT_TRUE(certificate.proof && certificate.lower_bound);
        EXPECT_EQ(recomputed_bound(*certificate.proof), *certificate.lower_bound);
        EXPECT_LE(*certificate.gap, 1e-9);
        EXPECT_EQ(found.scene.objective.velocity, point[0]);
        if (reused % 8 != 0) continue;
        const Solution cold = solve(scene);
        EXPECT_NEAR(certificate.objective, cold.certificate.objective, 1e-9);
        EXPECT_NEAR(*certificate.lower_bound, *cold.certificate.lower_bound, 2e-9);
        EXPECT_NEAR(found.any_curve_limit->objective, cold.any_curve_limit->objective, 1e-12);
        EXPECT_NEAR(found.peaks.jerk.value, cold.peaks.jerk.value, 1e-6 * cold.peaks.jerk.value);
        EXPECT_NEAR(found.peaks.rms_jerk, cold.peaks.rms_jerk, 1e-3 * cold.peaks.rms_jerk)
            << "another optimum";
    }
    EXPECT_GT(reused, lattice.points() / 3);
}

/// Of limits along a range many need no solve: motion and bound follow from a neighbour's rows.
void expect_limits_proved(Scene scene, int rows, const std::function<void(Scene&, double part)>& set) {
    KnownSolutions known;
    int reused = 0;
    for (int row = 0; row < rows; ++row) {
        SCOPED_TRACE(row);
        set(scene, static_cast<double>(row) / (rows - 1));
        const Solution found = neighbour(scene, known);
        const Certificate& certificate = found.certificate;
        EXPECT_EQ(certificate.verdict, Verdict::optimal);
        if (!found.solver.proved_from) continue;
        ++reused;
        ASSERT_TRUE(certificate.proof && certificate.lower_bound);
        EXPECT_EQ(recomputed_bound(*certificate.proof), *certificate.lower_bound);
        EXPECT_LE(*certificate.gap, 1e-8);
        EXPECT_LE(certificate.worst_violation, 1e-9);
        if (reused % 4 != 0) continue;
        const Solution cold = solve(scene);
        EXPECT_NEAR(certificate.objective, cold.certificate.objective, 1e-8);
        EXPECT_NEAR(*certificate.lower_bound, *cold.certificate.lower_bound, 1e-8);
        EXPECT_EQ(found.scene.motion.lift, scene.motion.lift);
        ASSERT_EQ(found.constraints.size(), cold.constraints.size());
        for (std::size_t k = 0; k < cold.constraints.size(); ++k) {
            EXPECT_EQ(found.constraints[k].limit, cold.constraints[k].limit);
            EXPECT_EQ(found.constraints[k].active, cold.constraints[k].active);
        }
        EXPECT_EQ(found.any_curve_limit.has_value(), cold.any_curve_limit.has_value());
        EXPECT_NEAR(found.peaks.jerk.value, cold.peaks.jerk.value, 1e-6 * cold.peaks.jerk.value);
        EXPECT_NEAR(found.peaks.rms_jerk, cold.peaks.rms_jerk, 1e-3 * cold.peaks.rms_jerk)
            << "another optimum";
    }
    EXPECT_GT(reused, rows / 3);
}

TEST(ProvedOptima, VelocityLimitsEqualColdSolves) {
    const Scene scene = weighted({0.4, 0.4, 0.2});
    expect_limits_proved(scene, 60,
                         [](Scene& one, double part) { one.limits.velocity = PeakLimit{1.6 + 0.4 * part}; });
}

TEST(ProvedOptima, LiftSweepEqualsColdSolves) {
    const Scene scene = scene_named("drd_physical_limits");
    expect_limits_proved(scene, 40, [&scene](Scene& one, double part) {
        one = scene;
        one.motion.lift *= 1.0 + 0.05 * part;
        for (std::optional<PeakLimit>* const limit : {&one.limits.velocity, &one.limits.acceleration})
            *limit = PeakLimit{0.0, (*limit)->key, (*limit)->given, (*limit)->unit};
    });
}

/// The rows that carry multipliers differ: nothing is proved from the neighbour.
TEST(ProvedOptima, FarLimitIsSolved) {
    KnownSolutions known;
    Scene scene = weighted({0.4, 0.4, 0.2});
    scene.limits.velocity = PeakLimit{1.5};
    EXPECT_FALSE(neighbour(scene, known).solver.proved_from);
    scene.limits.velocity = PeakLimit{2.5};
    const Solution far = neighbour(scene, known);
    EXPECT_FALSE(far.solver.proved_from);
    EXPECT_NEAR(far.certificate.objective, solve(scene).certificate.objective, 1e-8);
}

TEST(ProvedOptima, FarWeightsAreSolved) {
    KnownSolutions known;
    EXPECT_FALSE(neighbour(weighted({0.4, 0.4, 0.2}), known).solver.proved_from);
    EXPECT_FALSE(neighbour(weighted({0.01, 0.01, 0.98}), known).solver.proved_from);
    const Solution again = neighbour(weighted({0.4, 0.4, 0.2}), known);
    EXPECT_EQ(again.solver.proved_from, 0) << "of two known optima the right one";
}

/// Only weights > 0 of the same terms may differ.
TEST(ProvedOptima, OtherScenesAreSolved) {
    KnownSolutions known;
    const std::array<double, 3> weights = {0.4, 0.4, 0.2};
    (void)neighbour(weighted(weights), known);
    EXPECT_TRUE(neighbour(weighted(weights), known).solver.proved_from);
    EXPECT_FALSE(neighbour(weighted({0.0, 0.4, 0.2}), known).solver.proved_from)
        << "more motions are optimal";
    EXPECT_FALSE(neighbour(weighted(weights, 13), known).solver.proved_from);
    (void)neighbour(weighted(weights), known);
    Scene limited = weighted(weights);
    limited.limits.velocity = PeakLimit{1.7};
    EXPECT_FALSE(neighbour(limited, known).solver.proved_from);
    Scene smooth = weighted(weights);
    smooth.objective.rms_jerk = 0.1;
    smooth.objective.reference.rms_jerk = 50.0;
    EXPECT_FALSE(neighbour(smooth, known).solver.proved_from);
    EXPECT_FALSE(neighbour(smooth, known).solver.proved_from) << "its optimum moves with every weight";
}

}  // namespace proved_optima_test
}  // namespace camopt

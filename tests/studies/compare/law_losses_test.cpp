// SPDX-License-Identifier: MIT
#include "studies/compare/law_losses.hpp"

#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {
namespace law_losses_test {

using namespace testing_support;

const Scene drd_24 = paper_objective(MotionType::drd, 3, 24);

/// The largest least row of all mixes in steps of 1 / count.
double best_of_lattice(const std::vector<std::array<double, 3>>& rows, int count) {
    double best = 0.0;
    for (int i = 0; i <= count; ++i) {
        for (int j = 0; i + j <= count; ++j) {
            double least = infinity;
            for (const auto& row : rows)
                least = std::min(least, (i * row[0] + j * row[1] + (count - i - j) * row[2]) / count);
            best = std::max(best, least);
        }
    }
    return best;
}

TEST(MatrixGame, KnownGames) {
    // Rows as planes over the simplex: matching pennies in three columns has the value 1/3.
    const std::vector<std::array<double, 3>> identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const GameValue value = solve_game(identity);
    EXPECT_NEAR(value.value, 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(value.mix[2], 1.0 / 3.0, 1e-12);
    const std::vector<std::array<double, 3>> one = {{1, 3, 2}};
    EXPECT_NEAR(solve_game(one).value, 3.0, 1e-12);
    EXPECT_NEAR(solve_game(one).mix[1], 1.0, 1e-12);
}

TEST(MatrixGame, NoLatticeMixIsBetter) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0.2, 3.0);
    for (int game = 0; game < 20; ++game) {
        std::vector<std::array<double, 3>> rows(8);
        for (auto& row : rows)
            for (double& entry : row) entry = number(random);
        const GameValue value = solve_game(rows);
        const double best = best_of_lattice(rows, 60);
        EXPECT_GE(value.value, best - 1e-12);
        EXPECT_LE(value.value, best + 0.1);
        EXPECT_GE(value.bound, value.value - 1e-13);
        EXPECT_LE(value.bound, value.value + 1e-12);
        EXPECT_NEAR(solve_game_by_cuts(rows).value, value.value, 1e-11);
    }
}

TEST(MatrixGame, NearlyParallelFacesGiveNoValue) {
    // Games of a trade-off surface with thin triangles: a determinant rounds to more than nothing where the
    // pivot is zero, and the corner was NaN with the value infinity; the cuts went on for ever.
    using Rows = std::vector<std::array<double, 3>>;
    const std::vector<Rows> games = {
        {{0x1.c3599094f8f5p-3, 0x1.4f2dfd2ee1364p-3, 0x1.8906cp-37},
         {0x1.413d8p-36, 0x1.59a76d18e4cfcp+2, 0x1.aa277b46f2d72p+0},
         {0x1.364d936579c8cp-3, 0x1.52998f71eee5ep-2, 0x1.9ce18037bb47p-7},
         {0x1.79c29d2d7c81p-3, 0x1.e0e8f0d636344p-3, 0x1.14f4b8500b3cp-10},
         {0x1.c359909350d88p-3, 0x1.4f2dfd30ec878p-3, 0x1.636p-43}},
        {{0x1.3d45c9982c405p-4, 0x1.364d936582b48p-3, 0x1.0774p-40},
         {0x1.23344e4fb0bb3p+2, 0x1.413d8p-36, 0x1.2d1b27eba0412p+0},
         {0x1.67ba36ecca045p-3, 0x1.e5b7b4de9167p-4, 0x1.351abec99fd4p-8},
         {0x1.3d45c99a458fp-4, 0x1.364d9365189d4p-3, 0x1.37bap-40}},
        {{0x1.b4115a990abdp-12, 0x1.7e2ba2e11d978p-10, 0x1.b014991d8p-26},
         {0x1.21525e02c5fbcp-8, 0x1.1dd0168p-32, 0x1.9961de3d95fcp-12},
         {0x1.bb2844921351p-12, 0x1.7d40c2dc1de74p-10, 0x1.aa081358p-31}},
    };
    for (const Rows& rows : games) {
        const GameValue value = solve_game(rows);
        const double best = best_of_lattice(rows, 400);
        ASSERT_TRUE(std::isfinite(value.mix[0] + value.mix[1] + value.mix[2]));
        EXPECT_GE(value.value, best - 1e-12);
        EXPECT_LE(value.value, best + 0.01);
        EXPECT_NEAR(value.bound, value.value, 1e-12);
        EXPECT_NEAR(solve_game_by_cuts(rows).value, value.value, 1e-12);
    }
}

class LawLossesOfDrd : public testing::Test {
 protected:
    static const LawLosses& losses() {
        static const LawLosses found = law_losses(drd_24);
        return found;
    }
    static const LawLoss& law(const std::string& key) {
        return *std::ranges::find(losses().laws, key, &LawLoss::key);
    }
};

TEST_F(LawLossesOfDrd, CoverFinitePeakLaws) {
    EXPECT_TRUE(losses().complete);
    EXPECT_EQ(std::ranges::find(losses().laws, "parabolic", &LawLoss::key), losses().laws.end());
    for (const char* key : {"modified_sine", "cycloidal", "polynomial_345", "mcv_50"})
        EXPECT_NE(std::ranges::find(losses().laws, key, &LawLoss::key), losses().laws.end());
    for (const LawLoss& loss : losses().laws) {
        ASSERT_TRUE(loss.closest) << loss.key;
        EXPECT_TRUE(loss.closest->settled) << loss.key;
        EXPECT_NEAR(loss.closest->weights[0] + loss.closest->weights[1] + loss.closest->weights[2], 1.0,
                    1e-12);
    }
}

TEST_F(LawLossesOfDrd, WeightsAreOptimal) {
    for (int i = 0; i <= 4; ++i) {
        for (int j = 0; i + j <= 4; ++j) {
            const Scene scene = with_weights(drd_24, {i / 4.0, j / 4.0, (4 - i - j) / 4.0});
            const double optimum = solve(scene).certificate.objective;
            for (const LawLoss& loss : losses().laws) {
                const double of_law = scene.objective.velocity * loss.peaks[0] / 1.76 +
                                      scene.objective.acceleration * loss.peaks[1] / 5.53 +
                                      scene.objective.jerk * loss.peaks[2] / 69.0;
                EXPECT_GE(100.0 * (of_law / optimum - 1.0), loss.closest->loss_percent - 1e-3) << loss.key;
            }
        }
    }
}

/// Some motion has all three peaks at θ of the law's: solved with these three as limits (and a hair more).
TEST_F(LawLossesOfDrd, LeastLossLowersPeaks) {
    for (const char* key : {"modified_sine", "cycloidal", "modified_trapezoid"}) {
        const LawLoss& loss = law(key);
        const double part = 1.0 / (1.0 + loss.closest->loss_percent / 100.0);
        for (const double slack : {1e-4, -1e-4}) {
            Scene scene = drd_24;
            scene.limits.velocity = PeakLimit((part + slack) * loss.peaks[0]);
            scene.limits.acceleration = PeakLimit((part + slack) * loss.peaks[1]);
            scene.limits.jerk = PeakLimit((part + slack) * loss.peaks[2]);
            EXPECT_EQ(solve(scene).certificate.verdict, slack > 0.0 ? Verdict::optimal : Verdict::infeasible)
                << key;
        }
    }
}

// Without splines the modified sine has 42 % more jerk than its V and A need, 3-4-5 47 %, the modified
// trapezoid and the cycloid 14 %; splines of 24 segments come near that from below.
TEST_F(LawLossesOfDrd, LeastJerkUsesPeaks) {
    const auto more_jerk = [&](const char* key) {
        return 100.0 * (law(key).peaks[2] / *law(key).least[2] - 1.0);
    };
    EXPECT_NEAR(more_jerk("modified_sine"), 42.0, 6.0);
    EXPECT_LE(more_jerk("modified_sine"), 42.5);
    EXPECT_NEAR(more_jerk("polynomial_345"), 47.0, 6.0);
    EXPECT_NEAR(more_jerk("cycloidal"), 14.0, 4.0);
    for (const LawLoss& loss : losses().laws) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (loss.least[i] && loss.closest->loss_percent > 0.0) {
                EXPECT_LE(*loss.least[i], loss.peaks[i] + 1e-9);
            }
        }
    }
}

TEST_F(LawLossesOfDrd, MatchTheComparison) {
    const Comparison comparison = compare(drd_24);
    for (const ComparisonRow& row : comparison.rows) {
        const auto found = std::ranges::find(losses().laws, row.key, &LawLoss::key);
        if (found == losses().laws.end()) continue;
        EXPECT_NEAR(*found->loss_percent, *row.loss_percent, 1e-6);
        EXPECT_LE(found->closest->loss_percent, *row.loss_percent + 1e-4);
    }
}

TEST_F(LawLossesOfDrd, KnownMotionsSaveSolves) {
    std::vector<PeakTriple> known;
    for (int i = 1; i <= 8; ++i) {
        for (int j = 1; i + j <= 9; ++j) {
            const Peaks peaks = solve(with_weights(drd_24, {i / 10.0, j / 10.0, (10 - i - j) / 10.0})).peaks;
            known.push_back({peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value});
        }
    }
    const LawLosses again = law_losses(drd_24, {}, known);
    EXPECT_LT(again.solves, losses().solves);
    for (const LawLoss& loss : again.laws)
        EXPECT_NEAR(loss.closest->loss_percent, law(loss.key).closest->loss_percent, 5e-4) << loss.key;
}

TEST(LawLosses, StoppedTheyAreIncomplete) {
    const SolveControl control{[] { return true; }, {}};
    EXPECT_FALSE(law_losses(paper_objective(MotionType::drd, 3, 12), control).complete);
}

/// A search that is stopped delivers the best that it saw and does not call it proved.
TEST(LawLosses, WhatIsStoppedIsUnsettled) {
    const Scene scene = paper_objective(MotionType::drd, 3, 8);
    const LawLosses whole = law_losses(scene, {});
    int unsettled = 0;
    bool complete = false;
    for (double most = 50.0; !complete; most *= 1.12) {
        int polls = 0;
        SolveControl control;
        control.stop_requested = [&] { return ++polls > most; };
        const LawLosses losses = law_losses(scene, control);
        complete = losses.complete;
        for (const LawLoss& loss : losses.laws) {
            if (!loss.closest || loss.closest->settled) continue;
            ++unsettled;
            const PeakTriple& weights = loss.closest->weights;
            EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-12);
            const auto settled = std::ranges::find(whole.laws, loss.key, &LawLoss::key);
            EXPECT_GE(loss.closest->loss_percent, settled->closest->loss_percent - 1e-3) << loss.key;
        }
    }
    EXPECT_GT(unsettled, 0);
}

}  // namespace law_losses_test
}  // namespace camopt

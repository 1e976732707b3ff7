// SPDX-License-Identifier: MIT
// Bounds over boxes: they meet the optimum, pass no motion, and what they follow from can be added up again.
#include "studies/bound/box_bound.hpp"

#include "core/errors.hpp"
#include "objectives/scene_model.hpp"
#include "studies/bound/bounder.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

namespace camopt {
namespace box_bound_test {

using namespace testing_support;
using enum DimensionIndex;

struct RollerCase {
    double lift, rise, base, roller, angle, radius;
    int segments;
    double optimum;
};

/// docs/method.md: radius limits that a local search cannot show to be kept best.
const RollerCase roller_cases[] = {{15, 50, 22, 8, 34, 7, 14, 1.588796},
                                   {20, 60, 26, 10, 35, 13, 16, 1.077772},
                                   {10, 45, 20, 9, 30, 5, 16, 1.253867}};

TestScene roller_scene(const RollerCase& which) {
    return pressure_angle_scene(which.base + 10.0, which.segments)
        .set("motion.lift_mm", which.lift)
        .set("motion.rise_deg", which.rise)
        .set("cam.roller_radius_mm", which.roller)
        .set("limits.pressure_angle_deg", which.angle)
        .set("limits.cam_radius_min_mm", which.radius);
}

CamModel model_of(const Scene& scene) {
    return scene_model(scene, DesignKind::coefficients, reference_peaks(scene));
}

// docs/method.md and docs/cams.md say so of every kind of cam.
TEST(BoxBound, BoundsEveryLimitOfEveryCam) {
    for (const char* const name : {"cam_arm_flat", "cam_conjugate", "cam_forces", "cam_grooved", "tappet_75",
                                   "inverse_feeder", "barrel_smallest", "ocrf_indexing", "cylinder_slide"}) {
        const Scene scene = scene_named(name);
        int limits = 0;
        for (const PlacedRule& rule : model_of(scene).rules) {
            if (rule->linear() || rule->whole()) continue;
            ++limits;
            EXPECT_TRUE(box_bound::can_be_bounded(*rule)) << name;
        }
        if (std::string_view(name) != "cam_forces") {
            EXPECT_GT(limits, 0) << name;
        }
    }
}

TEST(BoxBound, ClosesTheGapOfRollerCams) {
    for (const RollerCase& which : roller_cases) {
        const Solution solution = solve(roller_scene(which));
        const Certificate& certificate = solution.certificate;
        EXPECT_EQ(certificate.verdict, Verdict::optimal) << which.optimum;
        EXPECT_NEAR(certificate.objective, which.optimum, 2e-6);
        ASSERT_TRUE(certificate.lower_bound && certificate.gap && certificate.box_proof);
        EXPECT_LE(*certificate.gap, 1e-4);
        EXPECT_EQ(certificate.proof_kind, ProofKind::boxes);
        EXPECT_GE(std::min(recomputed_bound(*certificate.box_proof), certificate.objective),
                  *certificate.lower_bound - 1e-12);
    }
}

TEST(BoxBound, IsBelowEveryMotion) {
    const RollerCase& which = roller_cases[0];
    const CamModel model = model_of(roller_scene(which));
    for (const double more : {1e-6, 1e-3, 0.1}) {
        BoxBoundOptions options;
        options.most_parts = 4;
        const auto bound = bound_over_boxes(model, which.optimum * (1.0 + more), options, {});
        ASSERT_TRUE(bound);
        EXPECT_LE(bound->bound, which.optimum + 1e-6) << more;
        EXPECT_GT(bound->bound, 1.2) << more;  // the bound without the rule: 1.0587
        EXPECT_FALSE(bound->infeasible);
    }
}

TEST(BoxBound, CountsWeightOfFixedDimension) {
    const RollerCase& which = roller_cases[0];
    constexpr double weight = 0.5;
    Scene scene = roller_scene(which);
    scene.objective.dimensions[static_cast<std::size_t>(base_radius)] = weight;
    const double given = weight * which.base / which.lift;
    BoxBoundOptions options;  // of the first relaxation alone: a box that is empty says nothing of the weight
    options.most_passes = options.most_parts = 0;
    const auto bound = bound_over_boxes(model_of(scene), which.optimum + given, options, {});
    const auto without = bound_over_boxes(model_of(roller_scene(which)), which.optimum, options, {});
    ASSERT_TRUE(bound && without);
    EXPECT_LT(without->bound, which.optimum - 1e-3);
    EXPECT_NEAR(bound->bound, without->bound + given, 1e-6);
}

TEST(BoxBound, SmallerGapTakesMorePasses) {
    const Solution solution = solve(roller_scene(roller_cases[1]).with("solver.gap = 1e-6"));
    ASSERT_TRUE(solution.certificate.gap);
    EXPECT_LE(*solution.certificate.gap, 1e-6);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
}

TEST(BoxBound, ProvesRadiusLimitInfeasible) {
    const Solution solution =
        solve_without_explaining(roller_scene(roller_cases[0]).with("limits.cam_radius_min_mm = 14"), {});
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.certificate.reason, Reason::limits_contradict);
    EXPECT_FALSE(solution.motion);
    ASSERT_TRUE(solution.certificate.box_proof);
    EXPECT_EQ(recomputed_bound(*solution.certificate.box_proof), infinity);
}

TEST(BoxBound, CorruptedProofIsRefusedOrWeaker) {
    const RollerCase& which = roller_cases[2];
    const auto bound = bound_over_boxes(model_of(roller_scene(which)), which.optimum, {}, {});
    ASSERT_TRUE(bound && bound->proof);
    const BoxProof& proof = *bound->proof;
    ASSERT_GE(std::min(recomputed_bound(proof), which.optimum + 1e-6), bound->bound);
    std::mt19937 random(3);
    int refused = 0, less = 0;
    for (int trial = 0; trial < 200; ++trial) {
        BoxProof spoiled = proof;
        const std::size_t at = random() % spoiled.steps.size();
        BoxStep& step = spoiled.steps[at];
        if (step.kind != BoxStep::Kind::derived) {
            BoxPart& part = spoiled.parts.front();
            part.multipliers[random() % part.multipliers.size()].second *= 1.01;
        } else if (random() % 2 == 0 && !step.multipliers.empty()) {
            step.multipliers[random() % step.multipliers.size()].second *= random() % 2 == 0 ? 0.9 : 1.1;
        } else {
            step.side -= 1e-6 * std::max(1.0, std::abs(step.side));
        }
        try {
            if (recomputed_bound(spoiled) < recomputed_bound(proof)) ++less;
        } catch (const ModelError&) {
            ++refused;
        }
    }
    EXPECT_GE(refused + less, 190);
    EXPECT_GT(refused, 0);
    EXPECT_GT(less, 0);
}

TEST(BoxBound, BoundsBothSignsOfTorque) {
    const Solution solution = solve(scene_named("drd_torque").with("spline.segments = 10"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.certificate.box_proof);
    EXPECT_GE(solution.certificate.box_proof->parts.size(), 1u);
}

}  // namespace box_bound_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// A law, a solver and a kind of cam of the program's own, named by scenes as if they had always been there. A
// program of its own: what is added stays.
#include "motions/laws/law_catalogue.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_spec.hpp"
#include "solvers/registry.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_run.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <thread>

namespace camopt {
namespace open_registries_test {

using namespace testing_support;

/// y = 3 x² − 2 x³, or what is asked for.
class Smoothstep final : public Law {
 public:
    explicit Smoothstep(const std::string& key, double slip = 0.0) : Law(info(key)), slip_(slip) {}
    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, 1.0}; }

 private:
    static LawInfo info(const std::string& key) {
        LawInfo info;
        info.key = key;
        info.title = "Smoothstep";
        info.source = "this test";
        info.continuity = 1;
        return info;
    }
    [[nodiscard]] LawDerivatives evaluate(double x, Side) const override {
        return {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) + slip_ * x * (1.0 - x), 6.0 - 12.0 * x, -12.0,
                0.0};
    }
    double slip_;
};

LawMaker smoothstep(const std::string& key, double slip = 0.0) {
    return [key, slip]() -> std::unique_ptr<Law> { return std::make_unique<Smoothstep>(key, slip); };
}

TestScene rise() {
    return scene_named("drd_cubic_12").with("motion.lift_mm = 10", "motion.rise_deg = 120");
}

TEST(OwnLaw, WorksAsReferenceComparisonAndSegment) {
    const std::span<const LawInfo> before = law_catalogue();
    add_law(smoothstep("smoothstep"));
    EXPECT_EQ(law_catalogue().size(), before.size() + 1);
    EXPECT_EQ(before.front().key, "parabolic");  // what was handed out stays
    EXPECT_NEAR(make_law("smoothstep")->peaks().velocity.value, 1.5, 1e-12);

    const Scene scene =
        rise().with("objective = { velocity = 0.5, acceleration = 0.5, reference = 'smoothstep' }");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective,
                0.5 * solution.peaks.velocity.value / 1.5 + 0.5 * solution.peaks.acceleration.value / 6.0,
                1e-9);
    const Comparison comparison = compare(scene);
    const auto row = std::ranges::find(comparison.rows, std::string("smoothstep"), &ComparisonRow::key);
    ASSERT_NE(row, comparison.rows.end());
    EXPECT_NEAR(row->objective, 1.0, 1e-9);

    const Solution turn =
        solve(rise().with("motion = { type = 'program', lift_mm = 10, segments = ["
                          "{ kind = 'law', law = 'smoothstep', angle_deg = 90, to_mm = 10 }, { kind = "
                          "'dwell', angle_deg = 90 },"
                          "{ kind = 'spline', angle_deg = 180, to_mm = 0 }] }",
                          "spline = { segments = 8 }", "objective = { acceleration = 1 }"));
    ASSERT_TRUE(turn.motion) << turn.certificate.reason;
    EXPECT_NEAR(turn.motion->at(0.25).derivative[0], 0.5, 1e-12);  // x: in units of the spline's angle
}

void expect_law_refused(const LawMaker& make, const std::string& part) {
    const std::string said = refusal([&] { add_law(make); });
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

TEST(OwnLaw, OneThatIsNoneIsRefused) {
    const std::size_t before = law_catalogue().size();
    expect_law_refused(smoothstep("modified_sine"), "found the key \"modified_sine\", which another law has");
    expect_law_refused(smoothstep("Smooth Step"),
                       "found this key; allowed: lower case letters, digits and _");
    expect_law_refused(smoothstep("slipped", 0.1), "found y that grows by");
    expect_law_refused({}, "found an empty function");
    EXPECT_EQ(law_catalogue().size(), before);
}

/// Counts and hands on.
class Counted final : public Solver {
 public:
    explicit Counted(std::atomic<int>& calls) : calls_(calls) {}
    [[nodiscard]] std::string_view name() const override { return "counted"; }
    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override {
        ++calls_;
        return make_solver("structured")->minimize(problem, start, options, control);
    }

 private:
    std::atomic<int>& calls_;
};

TEST(OwnSolver, IsSelectedByNameAndCertified) {
    static std::atomic<int> calls{0};
    SolverEntry entry;
    entry.name = "counted";
    entry.method = "counts, and hands on";
    entry.gives_multipliers = true;
    const SolverMaker make = []() -> std::unique_ptr<Solver> { return std::make_unique<Counted>(calls); };
    add_solver(entry, make);
    const Solution own = solve(rise().with("solver.name = counted"));
    const Solution built_in = solve(rise());
    EXPECT_GT(calls, 0);
    EXPECT_EQ(own.solver.name, "counted");
    EXPECT_EQ(own.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(own.certificate.objective, built_in.certificate.objective, 1e-8);
    EXPECT_THROW(add_solver(entry, make), InputError);  // taken
    entry.name = "other";
    EXPECT_THROW(add_solver(entry, make), InputError);  // not what it calls itself
    entry.name = "auto";
    EXPECT_THROW(add_solver(entry, make), InputError);
    EXPECT_THROW(add_solver(entry, {}), InputError);
}

TEST(OwnCamKind, IsReadAndSolved) {
    CamKind kind = *cam_kind("remote");
    kind.type = "rocking";
    kind.rows.clear();  // its keys are those of the kind it was made from
    for (CamVariant& variant : kind.variants)
        variant.spec = [spec = variant.spec] {
            CamSpec own = spec();
            own.type = "rocking";
            return own;
        };
    kind.formulas = [](const CamSpec& spec) -> std::shared_ptr<const CamMechanism> {
        CamSpec same = spec;
        same.type = remote_type;
        return std::make_shared<RemoteCam>(same);
    };
    const TestScene built_in = scene_named("lever_alone"), own = built_in.with("cam.type = rocking");
    EXPECT_THROW((void)own.read(), InputError);
    add_cam_kind(kind);
    const Solution found = solve(own), expected = solve(built_in);
    ASSERT_TRUE(expected.motion) << expected.certificate.reason;
    ASSERT_TRUE(found.motion) << found.certificate.reason;
    EXPECT_EQ(found.certificate.objective, expected.certificate.objective);
    ASSERT_TRUE(found.cam);
    EXPECT_EQ(found.constraints.front().worst, expected.constraints.front().worst);
    EXPECT_THROW(add_cam_kind(kind), InputError);  // taken
    kind.type = "another";
    kind.formulas = {};
    EXPECT_THROW(add_cam_kind(kind), InputError);
}

TEST(OpenRegistries, ReadersSeeCompleteListsDuringAdds) {
    const std::size_t before = law_catalogue().size();
    std::atomic<bool> done{false};
    std::thread reader([&] {
        while (!done)
            for (const LawInfo& law : law_catalogue()) ASSERT_FALSE(law.key.empty());
    });
    for (int k = 0; k < 50; ++k) add_law(smoothstep("smoothstep_" + std::to_string(k)));
    done = true;
    reader.join();
    EXPECT_EQ(law_catalogue().size(), before + 50);
    EXPECT_EQ(make_law("smoothstep_49")->key(), "smoothstep_49");
}

TEST(SceneSweep, IsWhatSingleSolvesGive) {
    const Scene scene = rise().with("objective = { velocity = 1, jerk = 0.2 }");
    const std::vector<double> values = {0.0, 0.1, 0.5, 2.0};
    int told = 0;
    const std::vector<SweptScene> rows = sweep(
        scene, values, [](Scene& one, double weight) { one.objective.jerk = weight; }, {},
        [&](const SweptScene&) { ++told; });
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(told, 4);
    for (const SweptScene& row : rows) {
        Scene one = scene;
        one.objective.jerk = row.value;
        EXPECT_NEAR(row.solution.certificate.objective, solve(one).certificate.objective, 1e-8);
        EXPECT_EQ(row.solution.certificate.verdict, Verdict::optimal);
    }
    SolveControl control;
    int asked = 0;
    control.stop_requested = [&] { return told >= 6 && ++asked > 0; };
    const std::vector<SweptScene> stopped = sweep(
        scene, values, [](Scene& one, double weight) { one.objective.jerk = weight; }, control,
        [&](const SweptScene&) { ++told; });
    EXPECT_EQ(stopped.size(), 2U);
}

}  // namespace open_registries_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Harmonics of the lift that excite the return spring: as figures, and as a limit.
#include "core/units.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/result_json.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace spring_surge_test {

using namespace testing_support;

constexpr double pi = std::numbers::pi;

const TestScene valve = scene_named("surge_valve"), program = scene_named("surge_program");

/// m, by the trapezoidal rule over the revolution: exact up to harmonics around the number of samples.
double sampled_amplitude(const Solution& solution, int order) {
    const MotionChain turn = solution.whole_turn();
    constexpr int samples = 8192;
    double cosine = 0.0, sine = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double angle = 2.0 * pi * i / samples;
        const double y = turn.at(angle / solution.scene.motion.unit_angle()).derivative[0];
        cosine += y * std::cos(order * angle);
        sine += y * std::sin(order * angle);
    }
    return solution.scene.motion.lift * 2.0 / samples * std::hypot(cosine, sine);
}

void expect_sampled_amplitudes(const Solution& solution) {
    for (const SurgeReport::Harmonic& one : solution.surge->harmonics)
        EXPECT_NEAR(one.amplitude, sampled_amplitude(solution, one.order), 1e-9 * solution.scene.motion.lift)
            << one.order;
}

// A cycloidal rise over half a revolution and its mirror image: c_k = 16 / (π² k² |4 − k²|) for odd k, else
// 0.
TEST(SpringSurge, CycloidalLawHasKnownHarmonics) {
    const Solution solution = optimum_of(scene_named("surge_cycloids"));
    const SurgeReport& surge = *solution.surge;
    EXPECT_NEAR(surge.frequency_ratio, 7.2, 1e-12);
    ASSERT_EQ(surge.harmonics.size(), 20U);
    for (const SurgeReport::Harmonic& one : surge.harmonics) {
        const double k = one.order;
        const double exact = one.order % 2 == 0 ? 0.0 : 16.0 / (pi * pi * k * k * std::abs(4.0 - k * k));
        EXPECT_NEAR(one.amplitude, 0.01 * exact, 1e-14) << one.order;
        EXPECT_NEAR(one.resonant_speed, 2.0 * pi * 72.0 / k, 1e-10);
        EXPECT_EQ(one.near, one.order >= 6 && one.order <= 8);
        EXPECT_FALSE(one.limited);
    }
}

TEST(SpringSurge, HarmonicsAreThoseOfSamples) {
    expect_sampled_amplitudes(optimum_of(valve));
    expect_sampled_amplitudes(optimum_of(program));
}

// Reference numbers: the same model with one quadratic row a² + b² <= level² a harmonic.
TEST(SpringSurge, LimitIsActiveAndProved) {
    const Solution free = optimum_of(valve);
    EXPECT_NEAR(free.certificate.objective, 0.790388172, 1e-8);
    EXPECT_GT(free.surge->harmonics[6].amplitude, 61e-6);
    const Solution limited = optimum_of(valve.with("limits.spring_harmonic_um = 60"));
    EXPECT_NEAR(limited.certificate.objective, 0.87434991, 1e-7);
    ASSERT_EQ(limited.constraints.size(), 1U);
    const ConstraintReport& reached = limited.constraints.front();
    EXPECT_EQ(reached.key, "limits.spring_harmonic_um");
    EXPECT_NEAR(reached.worst, 60.0, 60.0 * 1e-6);  // the tie-break may leave so much
    EXPECT_TRUE(reached.active);
    EXPECT_EQ(limited.certificate.verified, std::vector<std::string>{"limits.spring_harmonic_um"});
    for (const SurgeReport::Harmonic& one : limited.surge->harmonics) {
        EXPECT_EQ(one.limited, one.order >= 7 && one.order <= 9);
        if (one.limited) {
            EXPECT_LE(sampled_amplitude(limited, one.order), 60e-6 * (1.0 + 1e-8));
        }
    }
}

TEST(SpringSurge, LimitIncludesLawAndDwells) {
    const Solution free = optimum_of(program);
    EXPECT_GT(free.surge->harmonics[2].amplitude, 1.01e-3);
    const Solution limited = optimum_of(program.with("limits.spring_harmonic_mm = 1"));
    EXPECT_NEAR(limited.certificate.objective, 0.8015956976, 1e-6);
    EXPECT_NEAR(sampled_amplitude(limited, 3), 1e-3, 1e-9);
    expect_sampled_amplitudes(limited);
}

TEST(SpringSurge, ImpossibleLimitIsProvedInfeasible) {
    const Solution none = solve(valve.with("limits = { spring_harmonics = 1, spring_harmonic_um = 10 }",
                                           "solver.explain_seconds = 0"));
    EXPECT_EQ(none.certificate.verdict, Verdict::infeasible);
    EXPECT_FALSE(none.surge);
    EXPECT_TRUE(std::ranges::any_of(none.conflict, [](const ConflictReport& one) {
        return one.key == "limits.spring_harmonic_um" && one.remark == "harmonic 1";
    }));
}

TEST(SpringSurge, PrescribedMotionIsHeldAgainstLimit) {
    const TestScene laws =
        scene_named("surge_cycloids")
            .with("forces.spring_frequency_hz = 50", "limits.spring_harmonics = { min = 5, max = 6 }");
    const auto verdict = [&](int limit) {
        return solve(laws.set("limits.spring_harmonic_um", limit)).certificate.verdict;
    };
    // c_5 = 16 / (525 π²) of 10 mm: 30.878 µm.
    EXPECT_EQ(verdict(31), Verdict::optimal);
    EXPECT_EQ(verdict(30), Verdict::infeasible);
}

TEST(SpringSurge, OneRuleForEveryLimitedHarmonic) {
    const auto model_of = [](const Scene& scene) {
        return scene_model(scene, DesignKind::states, reference_peaks(scene));
    };
    const std::size_t free = model_of(program).rules.size();
    const CamModel model = model_of(
        program.with("limits = { spring_harmonic_um = 900, spring_harmonics = { min = 2, max = 6 } }"));
    ASSERT_EQ(model.rules.size(), free + 5);
    // Its row in the direction of a motion is what the motion gives.
    const CamProblem problem(model);
    const Eigen::VectorXd x = problem.start(), design = problem.design_values(x);
    for (std::size_t r = free; r < model.rules.size(); ++r) {
        const WholeMotionRule& rule = *model.rules[r]->whole();
        EXPECT_TRUE(rule.linear());
        const WholeMotionRule::Place place = rule.maxima(problem.motion(x), {}).front();
        const AffineRow row = rule.row(model.design, 0.0, Side::right, place.setting);
        double value = row.offset;
        for (std::size_t k = 0; k < row.columns.size(); ++k) value += row.weights[k] * design[row.columns[k]];
        EXPECT_NEAR(value, place.where.value, 1e-12) << rule.remark(place.setting);
    }
    EXPECT_EQ(model_of(valve).rules.size() + 3,
              model_of(valve.with("limits.spring_harmonic_in = 0.002")).rules.size());
}

TEST(SpringSurge, AppearsInEveryOutput) {
    const Solution solution = optimum_of(valve.with("limits.spring_harmonic_um = 60"));
    const auto json = nlohmann::json::parse(result_json(solution))["surge"];
    EXPECT_NEAR(json["spring_frequency_hz"].get<double>(), 400.0, 1e-9);
    EXPECT_NEAR(json["frequency_ratio"].get<double>(), 8.0, 1e-12);
    ASSERT_EQ(json["harmonics"].size(), 20U);
    const auto& seventh = json["harmonics"][6];
    EXPECT_EQ(seventh["order"], 7);
    EXPECT_NEAR(seventh["amplitude_mm"].get<double>(), 0.06, 1e-7);
    EXPECT_NEAR(seventh["resonant_speed_rpm"].get<double>(), 24000.0 / 7.0, 1e-8);
    EXPECT_EQ(seventh["near"], true);
    EXPECT_EQ(seventh["limited"], true);
    EXPECT_NE(report_markdown(solution).find("## Spring surge"), std::string::npos);
    EXPECT_NE(summary_text(solution).find("spring surge: natural frequency of the spring 400 Hz"),
              std::string::npos);
    const std::string picture = surge_svg(View(solution));
    EXPECT_NE(picture.find("limit 60"), std::string::npos);
}

TEST(SpringSurge, SceneWithoutFrequencyHasNone) {
    const Solution solution =
        solve(valve.with("forces = { mass_kg = 0.1, spring_rate_n_mm = 30, preload_n = 250 }"));
    EXPECT_FALSE(solution.surge);
    EXPECT_EQ(result_json(solution).find("\"surge\""), std::string::npos);
    EXPECT_EQ(report_markdown(solution).find("Spring surge"), std::string::npos);
}

}  // namespace spring_surge_test
}  // namespace camopt

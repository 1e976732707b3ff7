// SPDX-License-Identifier: MIT
// The reference optima: linear programs solved independently (HiGHS with exchange), to nine digits.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace exact_optima_test {

using testing_support::is_available;
using testing_support::paper_objective;

struct Optimum {
    MotionType type;
    int degree, segments;
    double objective;
    double digits;  ///< relative accuracy of the printed figure
    int rest = 2;
};

constexpr MotionType drd = MotionType::drd;
constexpr MotionType rr = MotionType::rr;

const std::vector<Optimum>& optima() {
    static const std::vector<Optimum> table = {
        {drd, 3, 4, 1.125961, 5e-7},
        {drd, 3, 6, 0.992889664, 1e-9},
        {drd, 3, 8, 0.963991515, 1e-9},
        {drd, 3, 10, 0.941666978, 1e-9},
        {drd, 3, 12, 0.940489277, 1e-9},
        {drd, 3, 14, 0.950998, 1e-6},
        {drd, 3, 16, 0.947449535, 1e-9},
        {drd, 3, 32, 0.938020776, 1e-9},
        {drd, 3, 64, 0.937411870, 1e-9},
        {drd, 5, 8, 0.981910672, 1.1e-8},
        {drd, 5, 12, 0.957101375, 1.1e-8},
        {drd, 5, 16, 0.953251487, 1.1e-8},
        {drd, 5, 24, 0.946894763, 1.1e-8},
        {drd, 5, 32, 0.940832852, 1.1e-8},
        {drd, 5, 64, 0.938201615, 1.1e-8},
        {rr, 3, 16, 0.864227617, 1e-9},
        {rr, 3, 24, 0.856144381, 1e-9},
        {rr, 3, 32, 0.855556437, 1e-9},
        {rr, 3, 64, 0.853505489, 1e-9},
        {rr, 3, 96, 0.852675861, 1e-9},
        // Of an output whose cam is s = y + y'' / w²: its s'' is continuous.
        {drd, 5, 24, 1.0882080541, 2e-8, 4},
        // HiGHS on the splines of tests/certificates/bounds_lp_test.py.
        {drd, 7, 8, 0.98192029, 2e-8},
        {drd, 7, 12, 0.95444375, 2e-8},
        {drd, 7, 24, 0.94644640, 2e-8},
        {drd, 7, 12, 1.00038047, 2e-8, 3},
        {drd, 7, 12, 1.06949248, 2e-8, 4},
        {drd, 7, 12, 1.22522232, 2e-8, 5},
        {drd, 7, 12, 1.66806501, 2e-8, 6},
        {drd, 7, 24, 1.01122006, 2e-8, 4},
        {rr, 7, 16, 0.87143853, 2e-8},
        {rr, 7, 16, 0.94007774, 2e-8, 4},
    };
    return table;
}

std::string name_of_case(const Optimum& optimum) {
    return std::string(name_of(optimum.type)) + "_degree" + std::to_string(optimum.degree) + "_n" +
           std::to_string(optimum.segments) + "_rest" + std::to_string(optimum.rest);
}

class ExactOptima : public testing::TestWithParam<std::string> {};

TEST_P(ExactOptima, AreFoundAndProved) {
    if (!is_available(GetParam())) GTEST_SKIP() << GetParam() << " is not part of this build";
    const bool sequential = GetParam() == "nlopt.slsqp";
    const double accuracy = sequential ? 1e-6 : 2e-8;
    for (const Optimum& optimum : optima()) {
        if (sequential && optimum.segments > 20) continue;  // dense and O(n³): promised to n = 20
        SCOPED_TRACE(name_of_case(optimum));
        Scene scene = paper_objective(optimum.type, optimum.degree, optimum.segments);
        scene.spline.rest = optimum.rest;
        scene.solver.name = GetParam();
        const Solution solution = solve(scene);
        ASSERT_TRUE(solution.curve) << solution.certificate.reason;
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
        const double allowed = (accuracy + optimum.digits) * optimum.objective;
        EXPECT_NEAR(solution.certificate.objective, optimum.objective, allowed);
        ASSERT_TRUE(solution.certificate.gap);
        EXPECT_LE(*solution.certificate.gap, 1e-7);
        EXPECT_LE(*solution.certificate.lower_bound, optimum.objective * (1.0 + optimum.digits));
        EXPECT_GE(solution.certificate.objective, optimum.objective * (1.0 - optimum.digits));
        EXPECT_LE(solution.certificate.worst_violation, 1e-9);
        EXPECT_EQ(solution.evaluations.profile_points, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, ExactOptima, testing::Values("auto", "structured", "ipopt", "nlopt.slsqp"),
                         [](const auto& backend) {
                             std::string name = backend.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

TEST(ExactOptima, DesignVectorsShareSepticOptimum) {
    for (const int rest : {2, 4}) {
        std::vector<double> found;
        for (const DesignKind kind : {DesignKind::states, DesignKind::coefficients, DesignKind::ordinates}) {
            Scene scene = paper_objective(drd, 7, 12);
            scene.spline.rest = rest;
            scene.spline.design = kind;
            const Solution solution = solve(scene);
            EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << name_of(kind);
            found.push_back(solution.certificate.objective);
        }
        EXPECT_NEAR(found[1], found[0], 1e-9 * found[0]) << rest;
        EXPECT_NEAR(found[2], found[0], 1e-9 * found[0]) << rest;
    }
}

TEST(ExactOptima, LongCurvesNeedFewIterations) {
    // Steps alone leave a dual residual of 1e-9 here, from a warm start and from a cold one: it is removed
    // from the multipliers at once. The spaces are nested, and no curve is below the limit of any curve.
    double before = 0.9371969945;  // of 1024 segments
    for (const int segments : {2048, 4096}) {
        const Solution solution = solve(paper_objective(drd, 3, segments));
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
        EXPECT_LT(solution.certificate.objective, before);
        EXPECT_GT(solution.certificate.objective, 0.93719636987);
        ASSERT_TRUE(solution.certificate.gap);
        EXPECT_LE(*solution.certificate.gap, 2e-8);
        EXPECT_LE(solution.solver.iterations, 45) << segments;
        before = solution.certificate.objective;
    }
}

TEST(ExactOptima, ShortSplinePeaksMatchClosedForm) {
    struct Row {
        int segments;
        double velocity, acceleration, jerk;
    };
    for (const Row& row : {Row{4, 2.0, 8.0, 32.0}, Row{6, 2.0, 6.0, 36.0}, Row{8, 2.0, 16.0 / 3, 128.0 / 3},
                           Row{10, 5.0 / 3, 50.0 / 9, 500.0 / 9}, Row{12, 12.0 / 7, 36.0 / 7, 432.0 / 7}}) {
        const Solution solution = solve(paper_objective(drd, 3, row.segments));
        EXPECT_NEAR(solution.peaks.velocity.value, row.velocity, 1e-6) << row.segments;
        EXPECT_NEAR(solution.peaks.acceleration.value, row.acceleration, 1e-6) << row.segments;
        EXPECT_NEAR(solution.peaks.jerk.value, row.jerk, 1e-5) << row.segments;
    }
}

TEST(ExactOptima, TheThreeDesignVectorsAgree) {
    struct Row {
        int segments;
        double accuracy;
    };
    for (const Row& row : {Row{12, 1e-9}, Row{64, 1e-8}}) {
        for (const int degree : {3, 5}) {
            std::vector<double> objectives;
            for (const DesignKind kind :
                 {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
                Scene scene = paper_objective(drd, degree, row.segments);
                scene.spline.design = kind;
                const Solution solution = solve(scene);
                ASSERT_EQ(solution.certificate.verdict, Verdict::optimal)
                    << name_of(kind) << " degree " << degree << " n " << row.segments << ' '
                    << solution.certificate.reason;
                objectives.push_back(solution.certificate.objective);
            }
            const auto [least, most] = std::ranges::minmax(objectives);
            EXPECT_LE(most - least, row.accuracy) << "degree " << degree << " n " << row.segments;
        }
    }
}

TEST(ExactOptima, PeaksBetweenSamplesTakeFewRounds) {
    // Here the best velocity peaks inside a segment: halving the distance of rows took 7 to 9 rounds.
    for (const int segments : {20, 32}) {
        const Solution solution = solve(paper_objective(drd, 3, segments));
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
        EXPECT_GT(solution.solver.exchange_rounds, 1) << segments;
        EXPECT_LE(solution.solver.exchange_rounds, 4) << segments;
    }
}

TEST(ExactOptima, LongSplinesAreSolvedInStages) {
    // Rounds that all run to the tolerance took 38 iterations.
    const Solution solution = solve(paper_objective(drd, 3, 256));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_LE(solution.certificate.gap.value_or(1.0), 1e-9);
    EXPECT_LE(solution.solver.iterations, 30);
}

TEST(ExactOptima, PhasesArePartsOfTheWhole) {
    const Solution solution = solve(paper_objective(drd, 3, 12));
    double sum = 0.0;
    for (const PhaseRow& phase : phase_rows) {
        EXPECT_GT(solution.phases.*phase.seconds, 0.0) << phase.name;
        sum += solution.phases.*phase.seconds;
    }
    EXPECT_LE(sum, solution.seconds_total);
    EXPECT_EQ(solution.family, nullptr);
}

TEST(ExactOptima, SymmetryCostsNothingWithoutGeometry) {
    for (const MotionType type : {drd, rr}) {
        Scene scene = paper_objective(type, 3, 16);
        const double free = solve(scene).certificate.objective;
        scene.motion.symmetric = true;
        const Solution symmetric = solve(scene);
        EXPECT_NEAR(symmetric.certificate.objective, free, 2e-9);
        const double length = scene.motion.length();
        for (const double x : {0.1, 0.37, 0.49}) {
            const double left = symmetric.curve->at(x).derivative[0];
            const double right = symmetric.curve->at(length - x).derivative[0];
            EXPECT_NEAR(type == drd ? left + right : left - right + 1.0, 1.0, 1e-9);
        }
    }
}

}  // namespace exact_optima_test
}  // namespace camopt

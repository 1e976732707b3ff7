// SPDX-License-Identifier: MIT
// The proof recomputed from certificate.json alone, by code that knows the file's recipe and nothing of the
// library.
#include "report/json/certificate_json.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace camopt {
namespace certificate_recomputed_test {

using nlohmann::json;
using testing_support::normalised_limit;
using testing_support::paper_objective;

/// constant − Σ m_i b_i + Σ_j min(r_j lower_j, r_j upper_j), r_j = cost_j + Σ_i m_i G_ij.
long double recomputed(const json& proof) {
    std::vector<long double> reduced;
    for (const json& cost : proof["cost"]) reduced.push_back(cost.get<double>());
    long double bound = proof["constant"].get<double>();
    for (const json& row : proof["rows"]) {
        const long double multiplier = row["multiplier"].get<double>();
        bound -= multiplier * row[multiplier > 0 ? "upper" : "lower"].get<double>();
        for (std::size_t k = 0; k < row["indices"].size(); ++k) {
            reduced[row["indices"][k].get<int>()] += multiplier * row["values"][k].get<double>();
        }
    }
    for (std::size_t j = 0; j < reduced.size(); ++j) {
        if (reduced[j] == 0) continue;
        const json& side = proof["box"][reduced[j] > 0 ? "lower" : "upper"][j];
        if (side.is_null()) return -INFINITY;
        bound += reduced[j] * side.get<double>();
    }
    return bound;
}

void expect_proved(const Solution& solution) {
    const json file = json::parse(certificate_json(solution.certificate));
    ASSERT_EQ(file["verdict"], "optimal");
    const long double bound = recomputed(file["proof"]);
    const double objective = file["objective"];
    EXPECT_GE(bound, file["proof"]["bound"].get<double>());  // the stored bound is rounded outward
    EXPECT_LE(bound, objective + 1e-12);
    EXPECT_LE((objective - bound) / std::max(1.0, objective), 1e-7);
    EXPECT_DOUBLE_EQ(file["lower_bound"], file["proof"]["bound"]);
}

TEST(CertificateFile, ProvesEveryReferenceOptimum) {
    for (const int degree : {3, 5}) {
        for (const int segments : {4, 6, 8, 10, 12, 16, 24, 32, 64}) {
            SCOPED_TRACE(std::to_string(degree) + " n " + std::to_string(segments));
            expect_proved(solve(paper_objective(MotionType::drd, degree, segments)));
        }
    }
    for (const int segments : {16, 24, 32, 64, 96}) {
        SCOPED_TRACE("RR n " + std::to_string(segments));
        expect_proved(solve(paper_objective(MotionType::rr, 3, segments)));
    }
}

TEST(CertificateFile, ProvesEveryDesignVectorAndTerm) {
    for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
        Scene scene = paper_objective(MotionType::drd, 3, 12);
        scene.spline.design = kind;
        scene.limits.velocity = normalised_limit("limits.velocity", 1.65);
        expect_proved(solve(scene));
        scene.objective.reference = {};
        scene.objective.rms_jerk = 0.3;
        scene.objective.rms_acceleration = 0.2;
        expect_proved(solve(scene));
        scene.objective = {};
        scene.objective.rms_jerk = 1.0;
        expect_proved(solve(scene));
    }
}

/// A cap on jerk at (or by a hair below) the least jerk there is.
Scene capped_at_optimum(DesignKind kind, double factor) {
    Scene scene;
    scene.motion.rise = 1.7589951739541236;
    scene.spline.segments = 23;
    scene.spline.design = kind;
    scene.objective.jerk = 0.25946764130575101;
    scene.objective.reference.numeric = true;
    scene.objective.reference.jerk = 69.5;
    scene.limits.jerk = normalised_limit("limits.jerk", 32.187830655880568 * factor);
    return scene;
}

TEST(CertificateFile, TightLimitsKeepBoundBelowObjective) {
    int proved = 0;
    for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
        for (const double factor : {1.0, 1.0 - 1e-10, 1.0 - 5e-10, 1.0 + 1e-10}) {
            SCOPED_TRACE(std::string(name_of(kind)) + " " + std::to_string((factor - 1.0) * 1e10));
            const Solution solution = solve(capped_at_optimum(kind, factor));
            const json file = json::parse(certificate_json(solution.certificate));
            if (file["verdict"] ==
                "infeasible") {  // true of a cap below the least possible, where it is proved
                EXPECT_LT(factor, 1.0);
                EXPECT_GT(recomputed(file["proof"]), 0.0);
                ++proved;
                continue;
            }
            ASSERT_NEAR(file["objective"].get<double>(), 0.120168353, 1e-8);
            if (file["lower_bound"].is_null()) {
                EXPECT_NE(file["verdict"], "optimal");
                continue;
            }
            const double objective = file["objective"], bound = file["lower_bound"];
            EXPECT_LE(bound, objective + 1e-9);
            EXPECT_GE(recomputed(file["proof"]), bound);
            EXPECT_EQ(file["verdict"], "optimal");
            EXPECT_LE(objective - bound, 1e-7);
            ++proved;
        }
    }
    EXPECT_GE(proved, 9);
}

TEST(CertificateFile, ProvesInfeasibility) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.limits.velocity = normalised_limit("limits.velocity", 0.9);
    const json file = json::parse(certificate_json(solve(scene).certificate));
    EXPECT_EQ(file["verdict"], "infeasible");
    EXPECT_EQ(file["proof"]["statement"], "least_common_violation");
    EXPECT_GT(recomputed(file["proof"]), 0.05);
}

TEST(CertificateFile, AnyMultipliersGiveValidLowerBound) {
    const Solution solution = solve(paper_objective(MotionType::drd, 3, 12));
    json proof = json::parse(certificate_json(solution.certificate))["proof"];
    for (std::size_t i = 0; i < proof["rows"].size(); ++i) {
        const double multiplier = proof["rows"][i]["multiplier"];
        proof["rows"][i]["multiplier"] = multiplier * (i % 2 == 0 ? 1.001 : 0.999);
    }
    EXPECT_LE(recomputed(proof), 0.940489277 + 1e-9);
}

}  // namespace certificate_recomputed_test
}  // namespace camopt

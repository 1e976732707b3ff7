// SPDX-License-Identifier: MIT
// The optimised scene of an inverse cam, rebuilt from the delivered motion alone: rocker, pin and body from
// positions with own formulas, the guide's tangent and curvature by differences.
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/inverse/inverse_forward.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>

namespace camopt {

namespace inverse_scene_test {

using Point = std::complex<double>;
using units::degree;

constexpr int fine = 20000;
constexpr double step = 1e-4;  // of the rise, for differences

/// The scene's numbers once more, in inches; the place of the roller in the body at x of the rise.
Point guide_at(const std::function<double(double)>& lift, double x) {
    const Point pivot(18.3756, 0.93306);
    const Point along = std::polar(1.0, std::atan2(-0.655 + lift(x) - pivot.imag(), 4.0));
    const double foot = (std::conj(along) * pivot).real();
    // Of the two pins on the rocker's line the one near the body's x axis: between body and rocker.
    const double reach = foot - std::sqrt(foot * foot - std::norm(pivot) + 15.0 * 15.0);
    const double body = std::arg(pivot - reach * along) - 9.0 * degree;
    const double root = std::sqrt(3.0 - 1.5) + std::sqrt(13.982 - 1.5) * x * 143.3 / 220.4651163;
    return std::polar(1.5 + root * root, -body);
}

struct Rebuilt {
    double pressure_angle = 0.0;  ///< the largest, deg
    double at = 0.0;              ///< there, of the rise
    double regularity = 1.0;      ///< the least of both walls
};

Rebuilt rebuilt(const std::function<double(double)>& lift) {
    Rebuilt result;
    for (int i = 0; i <= fine; ++i) {
        // Differences stay within the rise.
        const double x = std::clamp(static_cast<double>(i) / fine, 2.0 * step, 1.0 - 2.0 * step);
        const auto at = [&](int k) { return guide_at(lift, x + k * step); };
        const Point here = at(0), l = at(-1), ll = at(-2), r = at(1), rr = at(2);
        const Point first = (8.0 * (r - l) - (rr - ll)) / (12.0 * step);
        const Point second = (16.0 * (r + l) - (rr + ll) - 30.0 * here) / (12.0 * step * step);
        const double angle = std::abs(std::arg(std::conj(here) * first)) / degree;
        if (angle > result.pressure_angle) {
            result.pressure_angle = angle;
            result.at = x;
        }
        const double curvature = (std::conj(first) * second).imag() / std::pow(std::abs(first), 3);
        result.regularity = std::min(result.regularity, 1.0 - 0.5 * std::abs(curvature));
    }
    return result;
}

TEST(InverseScene, ForwardModelConfirmsTenDegrees) {
    const Scene scene = testing_support::scene_named("inverse_feeder");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion) << "no motion within 10 deg was found";
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::boxes);
    const Motion& motion = *solution.motion;
    EXPECT_NEAR(motion.at(0.0).derivative[0], 0.0, 1e-9);
    EXPECT_NEAR(motion.at(1.0, Side::left).derivative[0], 1.0, 1e-9);
    const Rebuilt best = rebuilt([&](double x) { return 2.694 * motion.at(x).derivative[0]; });
    RecordProperty("pressure_angle_deg", std::to_string(best.pressure_angle));
    RecordProperty("at", std::to_string(best.at));
    EXPECT_LE(best.pressure_angle, 10.0 + 1e-6);
    EXPECT_GT(best.pressure_angle, 10.0 - 1e-4) << "the limit does not bite: not what was asked for";
    EXPECT_GT(best.regularity, 0.9);
    const auto margin = std::ranges::find(solution.constraints, "undercut_margin", &ConstraintReport::name);
    ASSERT_NE(margin, solution.constraints.end());
    EXPECT_NEAR(margin->worst, best.regularity, 1e-5);
    const ForwardCheckReport check = check_guide(solution);
    EXPECT_LT(check.relative, 1e-9);
    EXPECT_GT(check.points, 4000);
    // The modified sine in the same machine breaks the limit, and so does the best motion without it.
    const auto law = make_law("modified_sine");
    EXPECT_GT(rebuilt([&](double x) { return 2.694 * law->at(x).derivative[0]; }).pressure_angle, 10.1);
    Scene without = scene;
    without.limits.pressure_angle.reset();
    const Solution loose = solve(without);
    ASSERT_TRUE(loose.motion);
    EXPECT_GT(rebuilt([&](double x) { return 2.694 * loose.motion->at(x).derivative[0]; }).pressure_angle,
              10.1);
    EXPECT_LT(loose.certificate.objective, solution.certificate.objective);
}

}  // namespace inverse_scene_test

}  // namespace camopt

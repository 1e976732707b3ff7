// SPDX-License-Identifier: MIT
// Laws with unequal parts against the symmetric law they come from: peaks, joint, continuity, refusals.
#include "core/errors.hpp"
#include "motions/laws/harmonic_law.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt {
namespace asymmetric_laws_test {

/// The laws of the catalogue that make_asymmetric takes, with the highest continuous derivative of the
/// outcome: y''(1/2) != 0 leaves y', y'''(1/2) != 0 leaves y'', and a constant velocity in the middle
/// everything.
struct Symmetric {
    const char* key;
    int continuity;
};

const Symmetric kSymmetric[] = {
    {"parabolic", 1},       {"simple_harmonic", 1},  {"cycloidal", 2},        {"polynomial_345", 2},
    {"polynomial_4567", 2}, {"polynomial_56789", 2}, {"modified_sine", 2},    {"modified_trapezoid", 2},
    {"mcv_50", 2},          {"mcv_33", 2},           {"mcv_20", 2},           {"cycloidal_cv50", 2},
    {"gutman_13", 2},       {"freudenstein_13", 2},  {"freudenstein_135", 2},
};

class AsymmetricTest : public ::testing::TestWithParam<Symmetric> {};

TEST_P(AsymmetricTest, PeaksMatchStretchedParts) {
    for (const double split : {0.1, 0.4, 0.7}) {
        const auto base = make_law(GetParam().key);
        const auto law = make_asymmetric(make_law(GetParam().key), split);
        const double narrow = 2.0 * std::min(split, 1.0 - split);
        const Peaks of_base = base->peaks(), of_law = law->peaks();
        const auto near = [](double found, double expected) {
            EXPECT_NEAR(found, expected, 1e-11 * expected);
        };
        near(of_law.velocity.value, of_base.velocity.value);
        near(of_law.acceleration.value, of_base.acceleration.value / narrow);
        near(of_law.torque.value, of_base.torque.value / narrow);
        near(of_law.rms_velocity, of_base.rms_velocity);
        near(of_law.rms_acceleration, of_base.rms_acceleration / std::sqrt(4.0 * split * (1.0 - split)));
        if (std::isinf(of_base.jerk.value)) {
            EXPECT_EQ(of_law.jerk.value, std::numeric_limits<double>::infinity());
        } else {
            near(of_law.jerk.value, of_base.jerk.value / (narrow * narrow));
        }
    }
}

TEST_P(AsymmetricTest, PartsMeetAtTheSplit) {
    for (const double split : {0.01, 0.3, 0.4, 0.99}) {
        const auto base = make_law(GetParam().key);
        const auto law = make_asymmetric(make_law(GetParam().key), split);
        const LawDerivatives left = law->derivatives(split, Side::left), right = law->derivatives(split);
        EXPECT_NEAR(left[0], split, 1e-14);
        EXPECT_NEAR(right[0], split, 1e-14);
        EXPECT_NEAR(left[1], base->at(0.5).derivative[1], 1e-13);
        EXPECT_NEAR(right[1], left[1], 1e-13);
        EXPECT_NEAR(left[2] * 2.0 * split, base->derivatives(0.5, Side::left)[2], 1e-11);
        EXPECT_NEAR(right[2] * 2.0 * (1.0 - split), base->derivatives(0.5)[2], 1e-11);
    }
}

/// As in the test of the catalogue, for laws that are not in it.
TEST_P(AsymmetricTest, ContinuityMatchesStatedOrder) {
    for (const double split : {0.3, 0.45}) {
        const auto law = make_asymmetric(make_law(GetParam().key), split);
        int continuous = 4;
        for (const double x : law->breakpoints()) {
            const LawDerivatives left = law->derivatives(x, Side::left), right = law->derivatives(x);
            for (int r = 4; r >= 0; --r) {
                const auto i = static_cast<std::size_t>(r);
                double jump = right[i] - left[i];
                if (x == 0.0) jump = right[i];
                if (x == 1.0) jump = left[i] - (r == 0 ? 1.0 : 0.0);
                if (std::abs(jump) > 1e-8) continuous = std::min(continuous, r - 1);
            }
        }
        EXPECT_EQ(continuous, GetParam().continuity) << "split " << split;
        EXPECT_EQ(law->continuity(), continuous) << "split " << split;
    }
}

TEST_P(AsymmetricTest, HalvesGiveTheLawItself) {
    const auto base = make_law(GetParam().key);
    const auto law = make_asymmetric(make_law(GetParam().key), 0.5);
    EXPECT_EQ(law->continuity(), base->continuity());
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        for (std::size_t r = 0; r < 5; ++r) {
            EXPECT_NEAR(law->derivatives(x)[r], base->derivatives(x)[r], 1e-12 * std::pow(20.0, r)) << x;
        }
    }
}

/// Exchanging the parts turns the motion round: y(x; m) = 1 - y(1 - x; 1 - m).
TEST_P(AsymmetricTest, ExchangedPartsTurnTheMotionRound) {
    const auto law = make_asymmetric(make_law(GetParam().key), 0.35);
    const auto turned = make_asymmetric(make_law(GetParam().key), 0.65);
    for (int i = 0; i <= 997; ++i) {
        const double x = i / 997.0;
        const LawDerivatives y = law->derivatives(x), z = turned->derivatives(1.0 - x, Side::left);
        EXPECT_NEAR(y[0] + z[0], 1.0, 1e-13);
        EXPECT_NEAR(y[1], z[1], 1e-12);
        EXPECT_NEAR(y[2], -z[2], 1e-10);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, AsymmetricTest, ::testing::ValuesIn(kSymmetric),
                         [](const auto& instance) { return std::string(instance.param.key); });

TEST(AsymmetricLaws, HoldEveryBreakpointOfTheBase) {
    const auto law = make_asymmetric(make_law("modified_trapezoid", std::array{0.125}), 0.4);
    const auto places = law->breakpoints();
    const double expected[] = {0.0, 0.1, 0.3, 0.4, 0.55, 0.85, 1.0};
    ASSERT_EQ(places.size(), std::size(expected));
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(places[i], expected[i], 1e-15);
    EXPECT_EQ(places.front(), 0.0);
    EXPECT_EQ(places.back(), 1.0);
}

TEST(AsymmetricLaws, ReportTheirParameters) {
    const LawInfo info = make_asymmetric(make_law("modified_sine", std::array{0.1}), 0.3)->info();
    EXPECT_EQ(info.key, "asymmetric_modified_sine");
    EXPECT_EQ(info.title, "Modified sine, split 0.3/0.7");
    ASSERT_EQ(info.parameters.size(), 2u);
    EXPECT_EQ(info.parameters[0].value, 0.1);
    EXPECT_EQ(info.parameters[1].name, "split");
    EXPECT_EQ(info.parameters[1].value, 0.3);
    EXPECT_EQ(make_law("asymmetric_modified_sine")->info().parameters.back().value, 0.4);
}

TEST(AsymmetricLaws, NarrowPiecesStayFinite) {
    EXPECT_TRUE(std::isfinite(
        make_asymmetric(make_law("modified_sine", std::array{kNarrowestPiece}), 0.01)->peaks().jerk.value));
}

std::string refusal(std::unique_ptr<Law> law, double split) {
    return testing_support::refusal([&] { (void)make_asymmetric(std::move(law), split); });
}

TEST(AsymmetricLaws, RefusalsNameFoundAndAllowed) {
    EXPECT_EQ(refusal(make_law("cycloidal"), 0.0),
              "asymmetric_cycloidal: split = 0 found, allowed 0.01 <= split <= 0.99");
    EXPECT_NE(refusal(make_law("cycloidal"), std::nan("")), "no refusal");
    EXPECT_NE(refusal(nullptr, 0.4), "no refusal");
    // Antisymmetric, but it sets out downwards: y''' = -60 at x = 0.
    LawInfo info;
    info.key = "dips";
    info.continuity = 2;
    auto dips = std::make_unique<PolynomialLaw>(
        info, std::vector<double>{0.0, 0.0, 0.0, -10.0, 85.0, -174.0, 140.0, -40.0});
    EXPECT_TRUE(refusal(std::move(dips), 0.4).starts_with("asymmetric law: dips found"));
    for (const char* key : {"double_harmonic", "one_dwell_cycloidal", "one_dwell_polynomial_345",
                            "asymmetric_cycloidal", "asymmetric_parabolic"}) {
        const std::string text = refusal(make_law(key), 0.4);
        EXPECT_TRUE(text.starts_with(std::string("asymmetric law: ") + key + " found, allowed a rise"))
            << text;
    }
}

}  // namespace asymmetric_laws_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// One mass against published shapes of the response, chains against themselves, steady states against turns.
#include "core/errors.hpp"
#include "train_case.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace elastic_train_test {

struct PublishedRow {
    const char* law;
    double ratio, damping, residual, deflection, acceleration;
};

// From rest. z'' + 2 ζ w z' + w² z = −y'', w = 2π ratio: residual, largest |z|, largest |x''|. Computed by
// quadrature of the convolution; the acceleration of the fifth row from its closed form (particular
// polynomial and decaying vibration, 400,000 samples).
constexpr PublishedRow published[] = {
    {"cycloidal", 1.5, 0.0, 0.1697652726, 0.20182046, 17.9269930},
    {"cycloidal", 2.5, 0.05, 0.0176562072, 0.03893278, 9.6237141},
    {"parabolic", 1.5, 0.0, 0.0900632743, 0.14572544, 12.9442719},
    {"polynomial_345", 2.5, 0.0, 0.0294556876, 0.04073101, 10.0499747},
    {"polynomial_4567", 7.3, 0.05, 0.0001754341, 0.00375904, 7.9102903},
    {"modified_sine", 4.0, 0.0, 0.0053342777, 0.01526017, 9.6391611},
    {"modified_sine", 7.3, 0.05, 0.0008626698, 0.00336322, 7.0839136},
};

TEST(ElasticTrain, RespondsAsPublished) {
    for (const PublishedRow& row : published) {
        const RiseFigures found = rise_figures(one_mass(row.ratio, row.damping), row.law);
        EXPECT_NEAR(found.residual, row.residual, 6e-11) << row.law;
        EXPECT_NEAR(found.deflection, row.deflection, 6e-9) << row.law;
        EXPECT_NEAR(found.acceleration, row.acceleration, 6e-8) << row.law;
    }
}

TEST(ElasticTrain, DoesNotRingAtKnownRatios) {
    for (const double ratio : {2.0, 3.0, 4.0, 9.0, 17.0, 40.0})
        EXPECT_LT(rise_figures(one_mass(ratio, 0.0), "cycloidal").residual, 1e-12) << ratio;
    for (const double ratio : {2.0, 4.0, 6.0, 20.0})
        EXPECT_LT(rise_figures(one_mass(ratio, 0.0), "parabolic").residual, 1e-12) << ratio;
    EXPECT_GT(rise_figures(one_mass(2.5, 0.0), "cycloidal").residual, 1e-3);
}

/// Two equal masses on equal springs are two trains of one mass on their own: √((3 ± √5) / 2) times the
/// frequency of one of them.
TEST(ElasticTrain, ChainsHaveTheirOwnFrequencies) {
    DynamicsSpec spec;
    spec.mass = 1.0;
    spec.stiffness = 100.0;
    spec.stages = {{1.0, 100.0, 0.0}};
    const std::vector<double> found = train_formulas(spec)->natural_frequencies();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0], 10.0 * std::sqrt(0.5 * (3.0 - std::sqrt(5.0))), 1e-12);
    EXPECT_NEAR(found[1], 10.0 * std::sqrt(0.5 * (3.0 + std::sqrt(5.0))), 1e-12);
}

/// A second mass on a spring that hardly gives moves with the first: one mass of both.
TEST(ElasticTrain, AStiffStageIsRigid) {
    DynamicsSpec chain = one_mass(0.0, 0.0);
    chain.natural_frequency.reset();
    chain.mass = 1.0;
    const double w = 2.0 * std::numbers::pi * 2.5;
    chain.stiffness = 1e6 * w * w;
    chain.stages = {{1.5, 2.5 * w * w, 0.0}};
    const RiseFigures whole = rise_figures(one_mass(2.5, 0.0), "polynomial_345");
    const RiseFigures split = rise_figures(chain, "polynomial_345");
    EXPECT_NEAR(split.residual, whole.residual, 1e-5);
    EXPECT_NEAR(split.deflection, whole.deflection, 1e-5);
}

/// At rest the springs carry the preload and what the return spring has gained: force and place are static.
TEST(ElasticTrain, RestsWhereTheSpringsBalance) {
    DynamicsSpec spec = one_mass(30.0, 0.9);
    spec.return_stiffness = 400.0;
    spec.preload = 50.0;
    const auto formulas = train_formulas(spec);
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const double own = spec.output().stiffness;
    const double force = train->contact_force().motion[0] + train->contact_force().constant;  // y = 1, X = 0
    // F = k (y − x), k_r x + P = F.
    const double place = (own - spec.preload) / (own + spec.return_stiffness);
    EXPECT_NEAR(force, own * (1.0 - place), 1e-9 * force);
    EXPECT_NEAR(train->deflection().motion[0], own / (own + spec.return_stiffness) - 1.0, 1e-12);
}

/// Every turn the same: after 200 turns from rest a damped train is where steady_start says.
TEST(ElasticTrain, RevolutionsConvergeToSteadyState) {
    for (const int stages : {0, 1, 3}) {
        DynamicsSpec spec = one_mass(3.3, 0.03);
        for (int i = 0; i < stages; ++i) spec.stages.push_back({1.0 + i, 3000.0 * (i + 1), 4.0});
        const auto formulas = train_formulas(spec);
        const auto train = formulas->at(1.0, 1.0, 1.0);
        std::vector<SlopePiece> turn = formulas->pieces(*make_law("cycloidal"));
        turn.push_back({1.0, 0.5, 1.0, Eigen::VectorXd::Zero(1)});
        const auto back = formulas->pieces(*make_law("polynomial_345"));
        for (SlopePiece piece : back) {
            piece.begin += 1.5;
            piece.displacement = 1.0 - piece.displacement;
            piece.slope = -piece.slope;
            turn.push_back(piece);
        }
        turn.push_back({2.5, 0.7, 0.0, Eigen::VectorXd::Zero(1)});
        Eigen::VectorXd state = Eigen::VectorXd::Zero(train->states());
        for (int k = 0; k < 200; ++k) state = train->states_along(turn, state, 0.0).back();
        const Eigen::VectorXd steady = train->steady_start(turn);
        EXPECT_LT((state - steady).norm(), 1e-10 * std::max(1e-3, steady.norm())) << stages;
    }
}

/// The inside of a piece, by Taylor steps, is what an exponential over a part of it gives.
TEST(ElasticTrain, MaximaAreReached) {
    const DynamicsSpec spec = one_mass(7.3, 0.05);
    const auto formulas = train_formulas(spec);
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const auto pieces = formulas->pieces(*make_law("polynomial_345"));
    ASSERT_EQ(pieces.size(), 1U);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(2);
    const auto maxima = train->maxima(train->acceleration(), 1.0, rest, pieces[0], 0.0);
    ASSERT_FALSE(maxima.empty());
    double largest = 0.0;
    for (const Extremum& one : maxima) {
        const Eigen::VectorXd state = train->state_inside(rest, pieces[0], one.at);
        double slope = 0.0;
        for (Eigen::Index k = pieces[0].slope.size(); k-- > 0;) slope = slope * one.at + pieces[0].slope[k];
        const double value = train->acceleration().state.dot(state) + train->acceleration().motion[1] * slope;
        EXPECT_NEAR(value, one.value, 1e-11);
        largest = std::max(largest, one.value);
    }
    for (int k = 0; k <= 2000; ++k) {
        const Eigen::VectorXd state = train->state_inside(rest, pieces[0], k / 2000.0);
        EXPECT_LE(train->acceleration().state.dot(state), largest + 1e-9);
    }
}

/// y' = 100 x up to 0.01, constant beyond, evaluated as a spline across the end of a closed program: at x
/// plus the program's length.
class ShiftedRamp final : public Motion {
 public:
    [[nodiscard]] double begin() const override { return 0.0; }
    [[nodiscard]] double end() const override { return length; }
    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, knee, length}; }
    [[nodiscard]] MotionPoint at(double x, Side side) const override {
        const volatile double shifted = x + length;
        const double t = shifted - length;
        if (x < knee || (x == knee && side == Side::left)) return {x, {50.0 * t * t, 100.0 * t, 100.0, 0.0}};
        return {x, {50.0 * knee * knee + 100.0 * knee * (t - knee), 100.0 * knee, 0.0, 0.0}};
    }

 private:
    static constexpr double knee = 0.01, length = 8.1818181818181817;
};

TEST(ElasticTrain, ShiftedSplineIsNotRefused) {
    EXPECT_EQ(train_formulas(one_mass(2.0, 0.0))->pieces(ShiftedRamp()).size(), 2U);
}

TEST(ElasticTrain, RefusesWhatIsNoTrain) {
    DynamicsSpec spec = one_mass(2.0, 0.0);
    spec.stages.assign(4, {1.0, 1.0, 0.0});
    EXPECT_THROW(static_cast<void>(train_formulas(spec)), InputError);
    spec.stages.assign(1, {1.0, 0.0, 0.0});
    EXPECT_THROW(static_cast<void>(train_formulas(spec)), InputError);
}

}  // namespace elastic_train_test
}  // namespace camopt

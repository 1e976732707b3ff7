// SPDX-License-Identifier: MIT
// The pieces that laws are put together from, away from x = 0 too.
#include "motions/laws/harmonic_law.hpp"

#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace harmonic_law_test {

using std::numbers::pi;
using testing_support::refusal;

LawInfo info() {
    LawInfo own;
    own.key = "pieces";
    return own;
}

/// Acceleration 2 sin over the first part, back to rest over the second, which begins at 0.4: both half sines
/// hold the same area, 2 · height · width / π.
HarmonicLaw two_half_sines() {
    return HarmonicLaw(info(), {half_sine(0.0, 0.4, 3.0), half_sine(0.4, 1.0, -2.0)});
}

TEST(HarmonicLaw, ShiftedHalfSineIsHalfSine) {
    const HarmonicLaw law = two_half_sines();
    const double top = law.at(0.7).derivative[2];  // the middle of the second
    EXPECT_LT(top, 0.0);
    for (const double part : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
        const double x = 0.4 + 0.6 * part;
        EXPECT_NEAR(law.at(x, part < 1.0 ? Side::right : Side::left).derivative[2], top * std::sin(pi * part),
                    1e-13);
        EXPECT_NEAR(law.at(0.4 * part, part < 1.0 ? Side::right : Side::left).derivative[2],
                    -1.5 * top * std::sin(pi * part), 1e-13);
    }
    EXPECT_NEAR(law.at(1.0).derivative[0], 1.0, 1e-15);
    EXPECT_NEAR(law.at(1.0).derivative[1], 0.0, 1e-14);
    // All the velocity is made by the first: y'(0.4) = 2 · (1.5 |top|) · 0.4 / π.
    EXPECT_NEAR(law.at(0.4).derivative[1], 2.0 * 1.5 * -top * 0.4 / pi, 1e-14);
}

TEST(HarmonicLaw, PieceShapeIsIndependentOfStart) {
    const double begin = 0.3, end = 0.55, height = -1.7, width = end - begin;
    const auto value = [&](const AccelerationPiece& piece, double part) {
        double sum = piece.constant;
        for (const HarmonicTerm& term : piece.terms)
            sum += term.sine * std::sin(term.frequency * part * width) +
                   term.cosine * std::cos(term.frequency * part * width);
        return sum;
    };
    for (const double part : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        EXPECT_EQ(value(zero_piece(begin, end), part), 0.0);
        EXPECT_EQ(value(constant_piece(begin, end, height), part), height);
        EXPECT_NEAR(value(quarter_sine_up(begin, end, height), part), height * std::sin(0.5 * pi * part),
                    1e-15);
        EXPECT_NEAR(value(quarter_cosine_down(begin, end, height), part), height * std::cos(0.5 * pi * part),
                    1e-15);
        EXPECT_NEAR(value(half_cosine(begin, end, height), part), height * std::cos(pi * part), 1e-15);
        EXPECT_NEAR(value(half_sine(begin, end, height), part), height * std::sin(pi * part), 1e-15);
    }
}

TEST(HarmonicLaw, RefusesPiecesNotFormingRise) {
    EXPECT_EQ(refusal<ModelError>([] {
                  HarmonicLaw(info(), {half_sine(0.0, 0.4, 1.0), half_sine(0.5, 1.0, -0.8)});
              }),
              "pieces: a piece [0.5, 1] follows x = 0.4");
    EXPECT_EQ(refusal<ModelError>([] { HarmonicLaw(info(), {half_cosine(0.0, 0.9, 1.0)}); }),
              "pieces: the pieces end at x = 0.9, not 1");
    EXPECT_NE(refusal<ModelError>([] {
                  HarmonicLaw(info(), {half_sine(0.0, 1.0, 1.0)});
              }).find("not at rest above 0"),
              std::string::npos);
}

}  // namespace harmonic_law_test
}  // namespace camopt

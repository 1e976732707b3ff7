// SPDX-License-Identifier: MIT
// Laws given by the shape of their acceleration: pieces made of a straight line, sines and cosines.
//
//   on [begin, end], with t = x - begin:
//   y''(x) ∝ constant + slope · t + Σ sine · sin(frequency t) + cosine · cos(frequency t)
//
// The pieces cover [0, 1] without gaps. They are integrated in closed form from y(0) = y'(0) = 0 and scaled
// so that y(1) = 1. Shapes need not be normalised; their sign is that of the acceleration. No units. Errors:
// pieces that do not cover [0, 1] in order, or whose motion does not rise and come to rest at x = 1, throw
// ModelError.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

struct HarmonicTerm {
    double frequency = 0.0;  ///< rad per unit of x, > 0
    double sine = 0.0;
    double cosine = 0.0;
};

struct AccelerationPiece {
    double begin = 0.0;
    double end = 0.0;
    double constant = 0.0;
    std::vector<HarmonicTerm> terms = {};
    double slope = 0.0;
};

/// Shapes that compose the classical laws, of height `height` (signed).
[[nodiscard]] AccelerationPiece zero_piece(double begin, double end);
[[nodiscard]] AccelerationPiece constant_piece(double begin, double end, double height);
/// Straight from one height to another.
[[nodiscard]] AccelerationPiece ramp_piece(double begin, double end, double from, double to);
/// From 0 up to the height.
[[nodiscard]] AccelerationPiece quarter_sine_up(double begin, double end, double height);
/// From the height down to 0.
[[nodiscard]] AccelerationPiece quarter_cosine_down(double begin, double end, double height);
/// From the height through 0 at the middle to minus the height.
[[nodiscard]] AccelerationPiece half_cosine(double begin, double end, double height);
/// From 0 over the height back to 0.
[[nodiscard]] AccelerationPiece half_sine(double begin, double end, double height);

class HarmonicLaw : public Law {
 public:
    HarmonicLaw(LawInfo info, std::vector<AccelerationPiece> shape);

    [[nodiscard]] std::vector<double> breakpoints() const override;
    [[nodiscard]] std::optional<std::array<Interval, 5>> ranges(const Interval& x) const override;

 private:
    struct Piece {
        AccelerationPiece acceleration;
        double velocity = 0.0;      ///< of the straight part of y at the piece's begin
        double displacement = 0.0;  ///< the same
    };

    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override;
    template <class T>
    [[nodiscard]] static std::array<T, 5> evaluate(const Piece& piece, const T& x);

    std::vector<Piece> pieces_;
};

// Polynomial laws. The lower half is expanded about x = 0 and the upper one about x = 1, so no digits are
// lost at either end:
//
//   y(x) = Σ from_below[k] x^k on [0, 1/2],   y(x) = Σ from_top[k] (1 - x)^k on [1/2, 1].
//
// Both are the same polynomial; an antisymmetric one, y(x) + y(1 - x) = 1, is given by from_below alone.
// No units. Errors: expansions that do not meet at x = 1/2 in y … y'''' throw ModelError.
class PolynomialLaw : public Law {
 public:
    /// Antisymmetric.
    PolynomialLaw(LawInfo info, const std::vector<double>& from_below);
    PolynomialLaw(LawInfo info, std::vector<double> from_below, std::vector<double> from_top);

    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, 1.0}; }
    [[nodiscard]] std::optional<std::array<Interval, 5>> ranges(const Interval& x) const override;

 private:
    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override;

    std::vector<double> from_below_, from_top_;
};

}  // namespace camopt

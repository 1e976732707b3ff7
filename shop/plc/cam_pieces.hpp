// SPDX-License-Identifier: MIT
// An electronic cam as polynomials between master positions, and the one that comes closest to a motion.
//
// Units as in MasterCurve. A piece of degree 5 has the s, s', s'' of the motion at both ends, one of
// degree 3 its s, s': where the motion is a polynomial of no higher degree, the piece is that polynomial.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_chain.hpp"

namespace camopt {

/// As a REAL of IEC 61131-3, a float32, holds it.
[[nodiscard]] inline double as_real(double value) {
    return static_cast<double>(static_cast<float>(value));
}

struct MasterStretch {
    double from = 0.0, to = 0.0;  ///< deg
};

// A delivered motion as an electronic cam sees it: the slave over the master, one revolution, dwells too.
//
// Master θ in degrees from 0; slave s in mm, of a swinging output in degrees; derivatives by the degree:
// dʳs/dθʳ in mm/degʳ (deg/degʳ). At a joint each side has its own value.
class MasterCurve {
 public:
    /// turn: Solution::master_turn.
    MasterCurve(MotionChain turn, const MotionSpec& motion);

    [[nodiscard]] double end() const { return breakpoints_.back(); }  ///< deg; one revolution is 360 exactly
    /// Ascending, deg, from 0 to the end.
    [[nodiscard]] const std::vector<double>& breakpoints() const { return breakpoints_; }

    /// s, s', s'', s''' at the angle; finite.
    [[nodiscard]] std::array<double, 4> at(double theta, Side side) const;

    /// c_k of s(θ + t) = Σ c_k t^k on the stretch at that side of the angle; empty where the motion is no
    /// polynomial there (a law).
    [[nodiscard]] std::vector<double> polynomial(double theta, Side side) const;

    /// Enclosures of s to s'''' along a stretch of a law between two breakpoints.
    [[nodiscard]] std::array<Interval, 5> ranges(const MasterStretch& stretch) const;

    [[nodiscard]] double lift() const { return lift_; }  ///< mm or deg
    /// The least and the largest that the scene gives, mm or deg.
    [[nodiscard]] std::pair<double, double> displacements() const { return displacements_; }
    [[nodiscard]] bool swings() const { return swings_; }
    [[nodiscard]] const char* slave_unit() const { return swings_ ? "deg" : "mm"; }
    [[nodiscard]] double degrees_per_x() const { return degrees_per_x_; }
    /// The slave at the end less the slave at 0: 0 where the cam closes.
    [[nodiscard]] double travel() const { return at(end(), Side::left)[0] - at(0.0, Side::right)[0]; }
    [[nodiscard]] bool closes() const;
    /// deg of the master, where the motion begins.
    [[nodiscard]] double phase() const { return phase_; }

 private:
    /// x, and the breakpoint itself where the angle is one but for rounding.
    [[nodiscard]] double place(double theta) const;

    MotionChain turn_;
    double lift_ = 1.0, degrees_per_x_ = 1.0, phase_ = 0.0;
    bool swings_ = false;
    std::pair<double, double> displacements_;
    std::vector<double> breakpoints_, places_;  ///< deg, and x of each
};

struct PolynomialPiece {
    double begin = 0.0, end = 0.0;
    std::vector<double> coefficients;  ///< c_k: s = Σ c_k (θ − begin)^k

    [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
};

/// The derivative of that order.
[[nodiscard]] double value_of(const PolynomialPiece& piece, double theta, int order = 0);
/// c_k about another angle: s(θ + t) = Σ c_k t^k.
[[nodiscard]] std::vector<double> polynomial_about(const PolynomialPiece& piece, double theta);

/// States at an end: s, s', s'', s'''.
struct EndState {
    double theta = 0.0, s = 0.0, v = 0.0, a = 0.0, j = 0.0;
};
[[nodiscard]] PolynomialPiece line_between(const EndState& from, const EndState& to);     ///< s
[[nodiscard]] PolynomialPiece cubic_between(const EndState& from, const EndState& to);    ///< s and v
[[nodiscard]] PolynomialPiece quintic_between(const EndState& from, const EndState& to);  ///< s, v and a
[[nodiscard]] PolynomialPiece septic_between(const EndState& from, const EndState& to);   ///< and j

struct FitOptions {
    int degree = 5;                      ///< 1, 3, 5, 6 or 7
    std::optional<int> points = {};      ///< evenly over the turn, ends included; none: the breakpoints
    int most = 1000;                     ///< pieces
    double (*master)(double) = nullptr;  ///< to the next master position the controller can hold; none: all
};

/// Without `points` the breakpoints of the motion are joints; a stretch on which the motion is not such a
/// polynomial is halved until s is within 1e-8 of the lift, or until there are `most` pieces.
[[nodiscard]] std::vector<PolynomialPiece> fitted_pieces(const MasterCurve& curve, const FitOptions& options);

// How far an electronic cam is from the motion it stands for: over one revolution, not at samples.
//
// On a stretch where the motion is a polynomial the difference is one, and its greatest magnitude is found
// from the sign changes of its derivative. On a stretch of a law it is bounded by enclosures, at most a
// fiftieth above the truth. What rounding may hide is added. Units as in MasterCurve.

struct CamDifference {
    double value = 0.0;  ///< magnitude
    double at = 0.0;     ///< deg
};

/// Largest |motion − piece| of the derivative of that order (0 … 3) on a stretch. Without a breakpoint of the
/// motion inside, but where stretches between them are looked at one after another. `known`: what need not be
/// exceeded; a smaller difference is any bound below it.
[[nodiscard]] CamDifference largest_difference(const MasterCurve& curve, const PolynomialPiece& piece,
                                               const MasterStretch& stretch, int order, double known = 0.0);

/// Of the first `orders` of s, s', s'', s''' over the turn. Throws InputError where the pieces leave a gap,
/// overlap, or do not go from 0 to the end.
[[nodiscard]] std::array<CamDifference, 4> cam_loss(const MasterCurve& curve,
                                                    const std::vector<PolynomialPiece>& pieces,
                                                    int orders = 4);

/// Largest |s|, |s'|, |s''|, |s'''| of the motion itself.
[[nodiscard]] std::array<CamDifference, 4> cam_peaks(const MasterCurve& curve);

}  // namespace camopt

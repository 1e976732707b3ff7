// SPDX-License-Identifier: MIT
// An electronic cam as polynomials between master positions, and the one that comes closest to a motion.
//
// Units as in master_curve.hpp. A piece of degree 5 has the s, s', s'' of the motion at both ends, one of
// degree 3 its s, s': where the motion is a polynomial of no higher degree, the piece is that polynomial.
#pragma once

#include "output/plc/master_curve.hpp"

#include <optional>
#include <vector>

namespace camopt {

struct CamPiece {
    double begin = 0.0, end = 0.0;
    std::vector<double> coefficients;  ///< c_k: s = Σ c_k (θ − begin)^k

    [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
};

/// The derivative of that order.
[[nodiscard]] double value_of(const CamPiece& piece, double theta, int order = 0);
/// c_k about another angle: s(θ + t) = Σ c_k t^k.
[[nodiscard]] std::vector<double> polynomial_about(const CamPiece& piece, double theta);

/// States at an end: s, s', s''.
struct EndState {
    double theta = 0.0, s = 0.0, v = 0.0, a = 0.0;
};
[[nodiscard]] CamPiece cubic_between(const EndState& from, const EndState& to);    ///< s and v
[[nodiscard]] CamPiece quintic_between(const EndState& from, const EndState& to);  ///< s, v and a

struct FitOptions {
    int degree = 5;                      ///< 3 or 5
    std::optional<int> points = {};      ///< evenly over the turn, ends included; none: the breakpoints
    int most = 1000;                     ///< pieces
    double (*master)(double) = nullptr;  ///< to the next master position the controller can hold; none: all
};

/// Without `points` the breakpoints of the motion are joints; a stretch on which the motion is not such a
/// polynomial is halved until s is within 1e-8 of the lift, or until there are `most` pieces.
[[nodiscard]] std::vector<CamPiece> fitted_pieces(const MasterCurve& curve, const FitOptions& options);

}  // namespace camopt

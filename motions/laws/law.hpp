// SPDX-License-Identifier: MIT
// The classical motion laws: a rise of 1 over 0 <= x <= 1 with closed-form derivatives and exact peaks.
//
//   y(0) = 0, y(1) = 1, y'(0) = y'(1) = 0;  x = cam angle / rise angle, y = displacement / lift, ' is d/dx.
//
// A law lies between two dwells (`TopEnd::dwell`), except those for cams with one dwell (the double
// harmonic and its like): at their top the return follows at once and mirrors the rise, y(1 + t) = y(1 - t)
// (`TopEnd::turning_point`). What lies outside counts: a jump of y'' at x = 0 or at a dwell's end is an
// impulse of the jerk.
//
// Impulses: `at` gives the finite one-sided values of y'''; `peaks` count an impulse as infinity, and then
// the mean square of y''' is infinite. Peaks hold magnitudes; `at` of one is the first place it is reached.
// Errors: x outside [0, 1], an unknown key and a parameter out of range throw InputError. Source: each
// LawInfo names its own; the peaks are those of the formulas, found to rounding error.
#pragma once

#include "core/motion.hpp"

namespace camopt {

/// What follows the law at x = 1.
enum class TopEnd { dwell, turning_point };

/// A free parameter of a law's shape, in units of the rise.
struct LawParameter {
    std::string name;
    double value = 0.0;
};

struct LawInfo {
    std::string key;     ///< as in scenes
    std::string title;   ///< for reports
    std::string source;  ///< who described it
    /// Highest derivative (up to 4) that is continuous everywhere, the joints at x = 0 and x = 1 included.
    int continuity = 0;
    TopEnd top = TopEnd::dwell;
    /// Its ends rest (y' = 0). Laws with moving ends occur only in programs, between splines.
    bool rests = true;
    std::vector<LawParameter> parameters;
};

/// y, y', y'', y''', y'''' at one x.
using LawDerivatives = std::array<double, 5>;

class Law : public Motion {
 public:
    [[nodiscard]] double begin() const final { return 0.0; }
    [[nodiscard]] double end() const final { return 1.0; }
    /// At x = 0 and x = 1 both sides mean the limit from inside.
    [[nodiscard]] MotionPoint at(double x, Side side = Side::right) const final;
    /// As `at`, with the fourth derivative.
    [[nodiscard]] LawDerivatives derivatives(double x, Side side = Side::right) const;

    [[nodiscard]] const LawInfo& info() const { return info_; }
    [[nodiscard]] const std::string& key() const { return info_.key; }
    [[nodiscard]] const std::string& title() const { return info_.title; }
    [[nodiscard]] int continuity() const { return info_.continuity; }

    /// Computed at each call, about 0.1 ms.
    [[nodiscard]] Peaks peaks() const;

 protected:
    explicit Law(LawInfo info);

 private:
    /// x lies in [0, 1]; the formula left (right) of it where `side` says so.
    [[nodiscard]] virtual LawDerivatives evaluate(double x, Side side) const = 0;

    LawInfo info_;
};

// Exact peaks of a law: every stationary point of y', y'', y''' and y'·y'' on every piece, and its ends.
//
// A piece is divided into cells far shorter than the shortest wave of any law of the catalogue; in a cell
// where the function's derivative (closed form) changes sign it is bisected down to neighbouring doubles. The
// peak's value is then exact to round-off. Mean squares: five-point Gauss quadrature per cell, exact to
// round-off for such analytic pieces. Normalised quantities, no units; signs and impulses as above.

/// Inside the law's pieces only: impulses at its ends are omitted.
[[nodiscard]] Peaks find_peaks_without_impulses(const Law& law);

}  // namespace camopt

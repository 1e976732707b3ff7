// SPDX-License-Identifier: MIT
// Laws made from other laws: with unequal parts, and run through backwards.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

// Rises with unequal acceleration and deceleration parts, made from an antisymmetric law f.
//
//   x <= m:  y = 2m f(u),                    u = x / (2m)                  acceleration part
//   x >= m:  y = 1 - 2(1 - m) (1 - f(u)),    u = 1 - (1 - x) / (2(1 - m))  deceleration part
//
// The acceleration part takes the share m (`split`) of the rise and of the lift. y' is that of f with the x
// of each part stretched, so it is continuous and V stays; A and J of the parts are those of f over 2m and
// (2m)², over 2(1 - m) and (2(1 - m))². At x = m y'' is continuous where f''(1/2) = 0, and jumps from
// f''(1/2-)/(2m) to f''(1/2+)/(2(1-m)) otherwise; derivative r >= 3 is continuous there only where
// f^(r)(1/2) = 0, as with a part of constant velocity in the middle. `continuity` says what holds. m = 1/2
// gives f.
//
// f must be a rise between dwells with f(x) + f(1 - x) = 1 and f'' >= 0 on [0, 1/2]. Errors: a null or
// unsuitable law, and a split outside [kNarrowestPart, 1 - kNarrowestPart]: InputError. Standard
// construction.

/// A narrower part multiplies the jerk by more than 2500: practically a jump.
inline constexpr double kNarrowestPart = 0.01;

class AsymmetricLaw : public Law {
 public:
    AsymmetricLaw(std::unique_ptr<Law> base, double split);

    [[nodiscard]] std::vector<double> breakpoints() const override;
    [[nodiscard]] std::optional<std::array<Interval, 5>> ranges(const Interval& x) const override;

 private:
    /// A piece of y with the piece [base_begin, base_end] of f that it is made of.
    struct Piece {
        double begin, end, base_begin, base_end;
    };

    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override;
    [[nodiscard]] static bool accelerates(const Piece& piece) { return piece.base_end <= 0.5; }
    [[nodiscard]] double stretch_of(const Piece& piece) const {
        return 2.0 * (accelerates(piece) ? split_ : 1.0 - split_);
    }
    /// The x of f that x is made of.
    [[nodiscard]] double base_place(const Piece& piece, double x) const;
    /// y, y', … of those of f.
    template <class T>
    [[nodiscard]] std::array<T, 5> of_base(const Piece& piece, std::array<T, 5> y) const;

    std::unique_ptr<Law> base_;
    double split_;
    std::vector<Piece> pieces_;
};

/// Key "asymmetric_" + the law's, its parameters and "split".
[[nodiscard]] std::unique_ptr<Law> make_asymmetric(std::unique_ptr<Law> law, double split);

/// y(x) = 1 − f(1 − x): the law run through from its end to its begin. Of a law that turns back at its top,
/// the stroke that follows the turning point. Its key is that of f after kReversed.
[[nodiscard]] std::unique_ptr<Law> make_reversed(std::shared_ptr<const Law> law);
inline constexpr std::string_view kReversed = "reversed_";

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The catalogue of the classical laws, and the factories of those with a free shape parameter, with unequal
// parts, and for cams with one dwell.
//
// Parameters are in units of the rise (x). Errors: InputError naming what
// was found and what is allowed. Sources: H. A. Rothbart, Cams (1956); R. L. Norton, Cam Design and
// Manufacturing Handbook; VDI 2143; the single laws name theirs in LawInfo::source. Definitions are in
// law_catalogue.cpp, one function a law.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

/// Pieces narrower than this are indistinguishable from jumps in double precision; parameters keep this
/// distance.
inline constexpr double kNarrowestPiece = 1e-9;
/// The share of the acceleration part in the asymmetric laws of the catalogue: a softer, longer deceleration,
/// which the return spring has to supply. A choice of this catalogue; other splits by make_asymmetric.
inline constexpr double kCatalogueSplit = 0.4;

/// Every law that make_law knows, with its parameters: the classical ones, then those added. A returned list
/// remains valid when another law is added.
[[nodiscard]] std::span<const LawInfo> law_catalogue();

/// Makes a law; called from several threads at once.
using LawMaker = std::function<std::unique_ptr<Law>()>;

/// Adds a law of the program to the catalogue permanently: scenes name it by its key, tables and comparisons
/// list it. Its formula is validated first: the ends of a rise, and each derivative against the integral of
/// the next between its breakpoints. Throws InputError if it is invalid, and for a key that is taken or not a
/// plain name (lower case letters, digits, _).
void add_law(const LawMaker& make);

/// The law with its customary parameters.
[[nodiscard]] std::unique_ptr<Law> make_law(std::string_view key);

/// y'': quarter sine over [0, Ta], half cosine over [Ta, 1 - Ta], quarter sine over [1 - Ta, 1].
/// kNarrowestPiece
/// <= Ta <= 1/4: towards 0 it becomes simple harmonic, at 1/4 it is cycloidal. Customary: 1/8.
[[nodiscard]] std::unique_ptr<Law> make_modified_sine(double ta);

/// y'': quarter sine over [0, Ta], constant to 1/2 - Ta, quarter cosine to 0 at 1/2, then antisymmetric.
/// kNarrowestPiece <= Ta <= 1/4: towards 0 it becomes parabolic, at 1/4 it is cycloidal. Customary: 1/8.
[[nodiscard]] std::unique_ptr<Law> make_modified_trapezoid(double ta);

/// y'': quarter sine over [0, a], quarter cosine down to 0 at b, zero to 1 - b, then antisymmetric. 0 < a < b
/// < 1/2, each piece at least kNarrowestPiece wide. The velocity is constant over the part 1 - 2b.
[[nodiscard]] std::unique_ptr<Law> make_modified_constant_velocity(double a, double b);

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

// Laws for cams with one dwell: a rise whose return follows at once and mirrors it (TopEnd::turning_point).
//
// At x = 0 a dwell ends, so y = y' = y'' = 0. At the top y' = y''' = 0 and y'' < 0: the acceleration
// continues smoothly into the return and does not return to zero there, as it must in a law between dwells.
// All are C2, limited only by the jump of y''' at x = 0 unless stated otherwise. x in units of the rise.
// Errors: a parameter out of range is an InputError. Standard constructions: the conditions under which each
// is unique are given with it. The double harmonic is in law_catalogue.cpp.

/// y'': quarter sine up over [0, Ta], quarter cosine down to 0 at b, quarter sine down over [b, 1] to the
/// top. Rest at the top and continuous y''' at b require b = 1/(2 - Ta) and a deceleration 1/(1 - Ta) times
/// the acceleration. kNarrowestPiece <= Ta <= 1 - √½: towards 0 it becomes simple harmonic, at 1 - √½ it is
/// the one-dwell cycloidal. Customary in the catalogue: 1/8, as for the law between dwells.
[[nodiscard]] std::unique_ptr<Law> make_one_dwell_modified_sine(double ta);

/// y'': half sine over [0, b], quarter sine down over [b, 1]. Rest at the top and continuous y''' at b
/// require b = 2 - √2 and a deceleration √2 times the acceleration.
[[nodiscard]] std::unique_ptr<Law> make_one_dwell_cycloidal();

/// y'': quarter sine up over [0, Ta], constant to b - Ta, half cosine down to minus that constant at b + Ta,
/// constant over the top. Rest at the top requires b = 1/2 + Ta (1/2 - 1/π). kNarrowestPiece <= Ta <= π/(3π +
/// 2), where the constant acceleration vanishes; towards 0 it becomes parabolic. Customary in the catalogue:
/// 1/8, as for the law between dwells.
[[nodiscard]] std::unique_ptr<Law> make_one_dwell_modified_trapezoid(double ta);

/// y = (20 x³ - 25 x⁴ + 8 x⁵)/3: the lowest degree with y = y' = y'' = 0 at 0, y = 1, y' = y''' = 0 at 1.
[[nodiscard]] std::unique_ptr<Law> make_one_dwell_polynomial_345();

/// y = 8 x³ - 12 x⁴ + 6 x⁵ - x⁶ = (1 - (1 - x)²)³: the lowest degree of a single polynomial over rise and
/// return, with y = y' = y'' = 0 at 0 and 2 and y = 1 at 1. In t = x/2: 64 (t³ - 3 t⁴ + 3 t⁵ - t⁶).
[[nodiscard]] std::unique_ptr<Law> make_one_dwell_polynomial_3456();

}  // namespace camopt

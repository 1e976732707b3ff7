// SPDX-License-Identifier: MIT
// The catalogue of the classical laws and the factories of those with a free shape parameter.
//
// Those with unequal parts are made by motions/laws/asymmetric_law.hpp, the one-dwell laws by
// motions/laws/one_dwell_laws.hpp. Parameters are in units of the rise (x). Errors: InputError naming what
// was found and what is allowed. Sources: H. A. Rothbart, Cams (1956); R. L. Norton, Cam Design and
// Manufacturing Handbook; VDI 2143; the single laws name theirs in LawInfo::source. Definitions are in
// law_catalogue.cpp, one function a law.
#pragma once

#include "motions/laws/law.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string_view>

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

}  // namespace camopt

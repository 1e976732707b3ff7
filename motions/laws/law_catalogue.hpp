// SPDX-License-Identifier: MIT
// The catalogue of the classical laws. A name is a key, or a key with numbers in place of its customary ones:
//
//   "modified_sine"   "modified_sine(Ta = 0.2)"   "scca(1, 2, 1, 0)"   "asymmetric_cycloidal(split = 0.3)"
//
// "reversed_" before a name runs through its law from the end to the begin (make_reversed).
// Numbers without a name are in the order of LawInfo::parameters; those left out are customary. Lengths of
// parts are by x, in units of the rise; of "scca" only their proportions count.
//
// Definitions, a row a law: law_catalogue.cpp; their shapes: law_families.hpp, derived_laws.hpp. Sources:
// H. A. Rothbart, Cams (1956); R. L. Norton, Cam Design and Manufacturing Handbook; VDI 2143; the single laws
// name theirs in LawInfo::source.
#pragma once

#include "motions/laws/derived_laws.hpp"
#include "motions/laws/law_families.hpp"

namespace camopt {

/// Every law that make_law knows, with its customary parameters: the classical ones, then those added. A
/// returned list remains valid when another law is added.
[[nodiscard]] std::span<const LawInfo> law_catalogue();

/// Makes a law; called from several threads at once.
using LawMaker = std::function<std::unique_ptr<Law>()>;

/// Adds a law of the program to the catalogue permanently: scenes name it by its key, tables and comparisons
/// list it. Its formula is validated first: the ends of a rise, and each derivative against the integral of
/// the next between its breakpoints. Throws InputError if it is invalid, and for a key that is taken or not a
/// plain name (lower case letters, digits, _).
void add_law(const LawMaker& make);

/// Throws InputError for an unknown key or parameter and for a number out of range.
[[nodiscard]] std::unique_ptr<Law> make_law(std::string_view name);
/// `parameters`: in the order of LawInfo::parameters, the rest customary.
[[nodiscard]] std::unique_ptr<Law> make_law(std::string_view key, std::span<const double> parameters);

/// The key of a name: "modified_sine" of "modified_sine(Ta = 0.2)".
[[nodiscard]] std::string_view law_key(std::string_view name);

/// The name that makes this law again: its key, with its numbers where one of them is not customary.
[[nodiscard]] std::string law_name(const LawInfo& law);

/// The polynomial of least degree between these ends of a stroke, as a law (key "polynomial").
[[nodiscard]] std::unique_ptr<Law> make_polynomial(const EndStates& ends);

}  // namespace camopt

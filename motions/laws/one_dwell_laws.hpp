// SPDX-License-Identifier: MIT
// Laws for cams with one dwell: a rise whose return follows at once and mirrors it (TopEnd::turning_point).
//
// At x = 0 a dwell ends, so y = y' = y'' = 0. At the top y' = y''' = 0 and y'' < 0: the acceleration
// continues smoothly into the return and does not return to zero there, as it must in a law between dwells.
// All are C2, limited only by the jump of y''' at x = 0 unless stated otherwise. x in units of the rise.
// Errors: a parameter out of range is an InputError. Standard constructions: the conditions under which each
// is unique are given with it. The double harmonic is in law_catalogue.cpp.
#pragma once

#include "motions/laws/law.hpp"

#include <memory>

namespace camopt {

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

// SPDX-License-Identifier: MIT
// Any motion as pieces on which y' is a polynomial.
//
// Between two breakpoints a quintic through y', y'', y''' of both ends is tried first: it is the slope of any
// spline up to degree 6 itself. Where it is not (harmonic laws, polynomials of higher degree) Chebyshev
// interpolants on halves, and halves of these, follow y' to rounding.
#pragma once

#include "scene/dynamics_spec.hpp"

#include <vector>

namespace camopt {

/// Throws InputError where y' is not finite, or no polynomial follows it (an infinite y'' at an end).
[[nodiscard]] std::vector<SlopePiece> slope_pieces(const Motion& motion);

}  // namespace camopt

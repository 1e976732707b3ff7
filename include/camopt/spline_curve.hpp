// SPDX-License-Identifier: MIT
// Piecewise polynomial motions y(x) of degree p with continuity C^k: on segment i, t = x − x_i, y = Σ
// a_{i,m} t^m. SplineCurve takes the coefficients as a matrix, one column a segment, one row a power; hands
// out its clamped B-spline form. No units. Outside the breakpoints: InputError.
#pragma once

#include "core/language.hpp"
#include "splines/curve.hpp"

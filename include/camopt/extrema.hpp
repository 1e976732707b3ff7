// SPDX-License-Identifier: MIT
// Exact extrema of piecewise polynomials and the peaks of a spline curve: every end of a segment from both
// sides, every stationary point inside. No sampling. No units.
#pragma once

#include "core/language.hpp"
#include "splines/extrema.hpp"

// SPDX-License-Identifier: MIT
// The optimization problem a backend sees:
//
//   min f(x)   subject to   x_L <= x <= x_U,   g_L <= g(x) <= g_U.
//
// x has `variables` entries, g `constraints` rows; missing bounds are ±infinity. L = σ f + λᵀ g, λ > 0 at an
// active upper bound. Derive from Nlp to bring a problem of your own; check_derivatives compares its
// derivatives with differences. An Nlp may keep work space between calls: one belongs to one thread at a
// time.
#pragma once

#include "core/derivative_check.hpp"
#include "core/language.hpp"
#include "core/nlp.hpp"

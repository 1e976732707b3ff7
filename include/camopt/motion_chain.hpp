// SPDX-License-Identifier: MIT
// Motions one after another as one Motion: a whole turn of dwells, laws and splines.
//
//   y(x) = y0 + y_scale · shape((x − x0) / x_scale) on each part.
#pragma once

#include "core/language.hpp"
#include "splines/motion_chain.hpp"

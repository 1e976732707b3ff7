// SPDX-License-Identifier: MIT
// The least prime radius with which any motion at all can keep a pressure angle:
//
//   s0 >= h / (exp(β tan φ) − 1) − σ e / tan φ   for a stroke of cam angle β, lift h, offset e.
//
// m, rad. Errors: InputError for numbers out of range.
#pragma once

#include "core/language.hpp"
#include "motions/bounds/smallest_cam.hpp"

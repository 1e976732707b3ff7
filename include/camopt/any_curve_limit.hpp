// SPDX-License-Identifier: MIT
// The limit that no curve can pass: any_curve_limit(input) is the least wV V + wA A + wJ J over all motions
// of bounded jerk, whatever their shape. Peaks without units. Errors: InputError for weights that are
// negative or all zero.
#pragma once

#include "core/language.hpp"
#include "motions/bounds/any_curve_limit.hpp"

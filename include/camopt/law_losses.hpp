// SPDX-License-Identifier: MIT
// Where each classical law lies above the trade-off of V, A and J of a scene: its least loss over all
// weights,
//
//   loss(w) = f_law(w) / f_optimum(w) − 1.
#pragma once

#include "core/language.hpp"
#include "studies/compare/law_losses.hpp"

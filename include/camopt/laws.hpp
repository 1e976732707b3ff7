// SPDX-License-Identifier: MIT
// The classical motion laws as Motions with closed-form derivatives and exact peaks: law_catalogue() lists
// them, make_law("modified_sine") makes one; the others take free parameters.
//
//   y(0) = 0, y(1) = 1, y'(0) = y'(1) = 0 on 0 <= x <= 1.
//
// Infinite peaks are impulses. Errors: InputError for an unknown key or a parameter out of range.
#pragma once

#include "core/language.hpp"
#include "motions/laws/asymmetric_law.hpp"
#include "motions/laws/harmonic_law.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "motions/laws/one_dwell_laws.hpp"

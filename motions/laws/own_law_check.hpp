// SPDX-License-Identifier: MIT
// Whether a law that a program brought is one.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

/// Throws InputError saying what does not hold: a plain key, the ends of a rise from standstill to
/// standstill, derivatives that belong together.
void check_own_law(const Law& law);

}  // namespace camopt

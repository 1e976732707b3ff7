// SPDX-License-Identifier: MIT
// Validation of a law that a program adds (law_catalogue.hpp).
#pragma once

namespace camopt {

class Law;

/// Throws InputError naming what does not hold: a plain key, the ends of a rise from rest to rest, consistent
/// derivatives.
void check_own_law(const Law& law);

}  // namespace camopt

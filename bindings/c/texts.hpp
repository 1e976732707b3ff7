// SPDX-License-Identifier: MIT
// Texts for C callers.
#pragma once

#include "bindings/c/camopt.h"

#include <string_view>

namespace camopt::c {

/// Throws Failure for a NULL, std::bad_alloc. name: of the argument.
void hand_out_text(std::string_view text, camopt_text* target, const char* name);

}  // namespace camopt::c

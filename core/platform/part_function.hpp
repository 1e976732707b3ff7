// SPDX-License-Identifier: MIT
// The function by which a part is reached, of linked parts (core/platform/parts.hpp) and of those in a file
// (part_files.hpp).
#pragma once

namespace camopt {

/// The one function that a part exports, camopt_part_NAME: its table; null for a camopt of another build.
using PartEntry = const void* (*)(const char* build);

}  // namespace camopt

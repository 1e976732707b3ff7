// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camopt {

/// Absolute path of the source tree. A function and not a macro: objects that do not contain the path are
/// shared by the compiler caches of all clones.
[[nodiscard]] std::string source_folder();

}  // namespace camopt

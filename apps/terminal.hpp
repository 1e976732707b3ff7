// SPDX-License-Identifier: MIT
// The one way to the terminal: what it would obey instead of showing is written out
// (core/text/printable.hpp).
#pragma once

#include <string_view>

namespace camopt::apps {

/// To standard output.
void print(std::string_view text);

/// To standard error.
void print_error(std::string_view text);

}  // namespace camopt::apps

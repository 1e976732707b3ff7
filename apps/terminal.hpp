// SPDX-License-Identifier: MIT
// The one way to the terminal: what it would obey instead of showing is written out
// (core/text/printable.hpp).
#pragma once

#include <string_view>

namespace camopt::apps {

/// To standard output, all of it. Throws std::system_error where it does not take the text (a full disk, a
/// closed pipe): a text that is cut short must not end in exit code 0.
void print(std::string_view text);

/// To standard error.
void print_error(std::string_view text);

}  // namespace camopt::apps

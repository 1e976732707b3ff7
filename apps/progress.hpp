// SPDX-License-Identifier: MIT
// One line of progress on the terminal, overwritten in place.
#pragma once

#include <functional>
#include <string_view>

namespace camopt::apps {

/// A callback that writes to stderr; empty where stderr is not a terminal.
[[nodiscard]] std::function<void(std::string_view)> terminal_progress();

/// Wipes the line, so that what follows starts clean.
void end_progress();

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// Overrides KEY=VALUE of the command line, applied to the parsed file before it is checked. An override
// replaces the key and every other way to say the same (lift_in for lift_mm, segments for breakpoints). KEY
// may lead into an array, counted from 0: motion.segments[1].to. Internal to input/.
#pragma once

#include "input/document.hpp"

#include <span>
#include <string>

namespace camopt::input {

/// Throws InputError "--set KEY=VALUE: …" for what is not KEY=VALUE or reaches into something that is no
/// table.
void apply_overrides(Node& root, std::span<const std::string> overrides);

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// A document written as TOML again: parse_document(document_text(root)) is the same tree but for its places.
// Comments and the layout of the file it came from are gone. Internal to input/.
#pragma once

#include "input/document/document.hpp"

#include <string>

namespace camopt::input {

/// The tables of the root as sections, everything in them on one line a key. Numbers in the fewest digits
/// that read back as the same double. Throws InputError for a date or time: no scene holds one.
[[nodiscard]] std::string document_text(const Node& root);

/// One value of it: 30.0, "DRD", [0.0, 0.5], {min = 20, max = 60}.
[[nodiscard]] std::string value_text(const Node& node);

}  // namespace camopt::input

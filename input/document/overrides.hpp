// SPDX-License-Identifier: MIT
// Overrides KEY=VALUE of the command line, applied to the parsed file before it is validated. An override
// replaces the key and all its synonyms (lift_in for lift_mm, segments for breakpoints). KEY may address an
// array entry, counted from 0: motion.segments[1].to. Internal to input/.
#pragma once

#include "input/document/document.hpp"

#include <span>
#include <string>
#include <string_view>

namespace camopt::input {

/// A key and its new value. The location of the value is that of the setting in error messages.
struct Setting {
    std::string key;
    Node value;
};

/// "KEY=VALUE", VALUE in TOML or a bare word. Throws InputError for other texts.
[[nodiscard]] Setting parsed_setting(std::string_view text, const Place& place);

/// Throws InputError for an invalid key or one that leads into something that is not a table.
void apply_setting(Node& root, const Setting& setting);

/// Removes the key and its synonyms. False: it was not there. Throws as apply_setting.
bool remove_setting(Node& root, std::string_view key, const Place& place);

/// Throws InputError "--set KEY=VALUE: …" for text that is not KEY=VALUE or leads into something that is not
/// a table.
void apply_overrides(Node& root, std::span<const std::string> overrides);

}  // namespace camopt::input

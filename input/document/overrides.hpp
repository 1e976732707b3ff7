// SPDX-License-Identifier: MIT
// Overrides KEY=VALUE of the command line, applied to the parsed file before it is checked. An override
// replaces the key and every other way to say the same (lift_in for lift_mm, segments for breakpoints). KEY
// may lead into an array, counted from 0: motion.segments[1].to. Internal to input/.
#pragma once

#include "input/document/document.hpp"

#include <span>
#include <string>
#include <string_view>

namespace camopt::input {

/// A key and what it is to be. The place of the value is that of the setting in error messages.
struct Setting {
    std::string key;
    Node value;
};

/// "KEY=VALUE", VALUE in TOML or a bare word. Throws InputError for what is not that.
[[nodiscard]] Setting parsed_setting(std::string_view text, const Place& place);

/// Throws InputError for what is no dotted key or reaches into something that is no table.
void apply_setting(Node& root, const Setting& setting);

/// Takes the key out, and every other way to say the same. False: it was not there. Throws as apply_setting.
bool remove_setting(Node& root, std::string_view key, const Place& place);

/// Throws InputError "--set KEY=VALUE: …" for what is not KEY=VALUE or reaches into something that is no
/// table.
void apply_overrides(Node& root, std::span<const std::string> overrides);

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// Validates a parsed scene file against the key table, in the order of the file: unknown keys, wrong types,
// values out of range, two spellings of a quantity, missing keys. Errors: InputError, UnavailableError.
// Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"

namespace camopt::input {

void check_keys(const SceneSource& source);

/// The same without missing keys: for a scene under construction.
void check_given_keys(const SceneSource& source);

/// Names, and the words around their list in an error message.
struct AllowedNames {
    const std::vector<std::string>& names;
    std::string_view before = {}, after = {};
};

/// Throws if the text is not one of the names.
void check_name(const SceneSource& source, const Given& given, const std::string& key,
                const AllowedNames& allowed);

}  // namespace camopt::input

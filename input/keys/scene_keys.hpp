// SPDX-License-Identifier: MIT
// Every key of a scene file, one row per key: type, units, range, default, meaning. The reader refuses keys
// without a row and validates every value against its row; docs/scene_file.md is generated from it.
#pragma once

#include "scene/key_row.hpp"

namespace camopt::input {

using camopt::Availability;
using camopt::KeyRow;
using camopt::KeyType;
using camopt::Spelling;

/// The table, in the order of the documentation.
[[nodiscard]] const std::vector<KeyRow>& scene_keys();

/// The keys of one kind of file.
using KeyRows = std::span<const KeyRow>;

/// The row of a name without its unit; null: the table has none.
[[nodiscard]] const KeyRow* find_row(std::string_view table, std::string_view name,
                                     KeyRows rows = scene_keys());

struct KeyMatch {
    const KeyRow* row = nullptr;
    const Spelling* spelling = nullptr;
};

/// The row and spelling of a written key; row == nullptr if the table has no such key.
[[nodiscard]] KeyMatch match_key(std::string_view table, std::string_view key, KeyRows rows = scene_keys());

/// A key of [motion] that motions of this type ("valve") cannot have: which can, as "allowed: only in …" goes
/// on. Empty: it can have the key.
[[nodiscard]] std::string_view motion_types_of(std::string_view key, std::string_view type);

/// "number or range": the type as the manual and the lists name it.
[[nodiscard]] std::string_view type_words(KeyType type);

/// Every key of a table in all its spellings, in order.
[[nodiscard]] std::vector<std::string> written_keys(std::string_view table, KeyRows rows = scene_keys());

/// The table as Markdown, one section per TOML table.
[[nodiscard]] std::string scene_keys_markdown();

}  // namespace camopt::input

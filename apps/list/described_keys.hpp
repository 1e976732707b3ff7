// SPDX-License-Identifier: MIT
// The keys of every kind of file as lists and the manual describe them.
#pragma once

#include "scene/key_row.hpp"

namespace camopt::apps {

struct DescribedKeys {
    std::string_view name;     ///< "scene"
    std::string_view heading;  ///< "KEYS OF A SCENE"
    std::span<const KeyRow> rows;
};

/// Scenes first.
[[nodiscard]] std::vector<DescribedKeys> described_keys();

/// "Top level", "[motion]".
[[nodiscard]] std::string table_heading(const KeyRow& row);

}  // namespace camopt::apps

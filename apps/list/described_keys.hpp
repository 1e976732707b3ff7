// SPDX-License-Identifier: MIT
// What `camopt list` knows: topics, and the keys of every kind of file, which the manual describes too.
#pragma once

#include "report/json/json_text.hpp"
#include "scene/key_row.hpp"

namespace camopt::apps {

struct DescribedKeys {
    std::string_view name;     ///< "scene"
    std::string_view heading;  ///< "KEYS OF A SCENE"
    std::span<const KeyRow> rows;
};

struct ListTopic {
    const char* name;  ///< "laws"
    std::string (*text)();
    Json (*json)();
};

/// Scenes first.
[[nodiscard]] std::vector<DescribedKeys> described_keys();

/// "Top level", "[motion]".
[[nodiscard]] std::string table_heading(const KeyRow& row);

}  // namespace camopt::apps

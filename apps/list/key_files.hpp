// SPDX-License-Identifier: MIT
// Every file whose keys are described by rows: for lists and the manual.
#pragma once

#include "scene/key_row.hpp"

namespace camopt::apps {

struct KeyFile {
    std::string_view name;     ///< "scene"
    std::string_view heading;  ///< "KEYS OF A SCENE"
    std::span<const KeyRow> rows;
};

/// Scenes first.
[[nodiscard]] std::vector<KeyFile> key_files();

/// "Top level", "[motion]".
[[nodiscard]] std::string table_heading(const KeyRow& row);

}  // namespace camopt::apps

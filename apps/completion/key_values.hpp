// SPDX-License-Identifier: MIT
// The values a key of a scene can have, where they can be listed.
#pragma once

#include "scene/key_row.hpp"

#include <string>
#include <vector>

namespace camopt::apps {

/// Laws and solvers by their names, true and false, words; empty where any text or number may stand.
[[nodiscard]] std::vector<std::string> values_of_key(const KeyRow& row);

/// "auto" and every solver this build has.
[[nodiscard]] std::vector<std::string> solver_words();

}  // namespace camopt::apps

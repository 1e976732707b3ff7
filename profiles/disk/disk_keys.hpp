// SPDX-License-Identifier: MIT
// The keys of a scene file that are for disk cams, and other words that users write for them.
#pragma once

#include "scene/cam_kind.hpp"

#include <vector>

namespace camopt {

/// Of [cam] and [drawing].
[[nodiscard]] std::vector<KeyRow> disk_rows();
/// Of the keys in [cam].
[[nodiscard]] std::vector<CamSynonym> disk_synonyms();
/// Of parts of the names of followers.
[[nodiscard]] std::vector<CamSynonym> follower_part_synonyms();

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A parsed document → validated Scene. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/scene_reader.hpp"

namespace camopt::input {

/// Checks keys, values and what must hold between them; throws InputError for the first fault.
[[nodiscard]] Scene read_document(const SceneSource& source, const KnownNames& known);

}  // namespace camopt::input

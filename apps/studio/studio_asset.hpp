// SPDX-License-Identifier: MIT
// The files under assets/, compiled in.
#pragma once

#include <string_view>

namespace camopt {

/// "studio.js". Throws ModelError for a name that is not there.
[[nodiscard]] std::string_view studio_asset(std::string_view name);

}  // namespace camopt

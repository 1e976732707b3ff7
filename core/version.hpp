// SPDX-License-Identifier: MIT
// The version of this camopt, as written into every result.
#pragma once

#include <string_view>

namespace camopt {

[[nodiscard]] std::string_view version();

}  // namespace camopt

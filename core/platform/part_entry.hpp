// SPDX-License-Identifier: MIT
// What the entry of a part returns: `table` to the camopt that it was built with, null to any other. For the
// sources of parts alone.
#pragma once

#include <string_view>

namespace camopt {

[[nodiscard]] inline const void* part_for(const char* build, const void* table) {
    return std::string_view(build) == CAMOPT_PART_BUILD ? table : nullptr;
}

}  // namespace camopt

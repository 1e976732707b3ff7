// SPDX-License-Identifier: MIT
// Private to output/page: the files under assets/ and vendor/, compiled in.
#pragma once

#include <string_view>

namespace camopt {

/// "assets/page.css". Throws ModelError for a name that is not there.
[[nodiscard]] std::string_view page_asset(std::string_view name);

}  // namespace camopt

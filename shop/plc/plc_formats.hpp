// SPDX-License-Identifier: MIT
// The table of controllers: one row a format. Lists, writers, readers and documents iterate over it. A new
// format is a template and a row.
#pragma once

#include "shop/plc/plc_format.hpp"

namespace camopt {

[[nodiscard]] const std::vector<PlcFormat>& plc_formats();
/// Throws InputError naming the keys there are.
[[nodiscard]] const PlcFormat& plc_format(std::string_view key);
[[nodiscard]] std::vector<std::string> plc_format_keys();

}  // namespace camopt

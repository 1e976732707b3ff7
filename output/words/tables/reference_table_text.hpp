// SPDX-License-Identifier: MIT
// The reference table for people: plain text for a terminal, and the same as a Markdown page.
//
// Peaks and objective are normalised, without units. A solve that is not proved optimal is said to be so in
// its own row and once more at the top. An infinite jerk is "∞". Nothing throws.
#pragma once

#include "studies/compare/reference_table.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string reference_table_text(const ReferenceTable& table);

[[nodiscard]] std::string reference_table_markdown(const ReferenceTable& table);

}  // namespace camopt

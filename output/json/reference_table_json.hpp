// SPDX-License-Identifier: MIT
// The reference table for programs: everything in it, as one JSON document.
//
// Numbers read back as the same double; what is infinite or absent is null, never NaN. "all_optimal" is true
// where every solve is proved; every solve carries its own verdict. Peaks are normalised. Nothing throws.
#pragma once

#include "studies/compare/reference_table.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string reference_table_json(const ReferenceTable& table);

}  // namespace camopt

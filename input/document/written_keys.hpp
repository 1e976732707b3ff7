// SPDX-License-Identifier: MIT
// The keys set in a scene file, with unit and meaning, for a complete report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camopt::input {

struct WrittenKey {
    std::string key;      ///< "motion.lift_mm", "motion.via[0].at"
    std::string value;    ///< in TOML: 30.0, "DRD", {min = 20, max = 60}
    std::string unit;     ///< "mm"; empty: dimensionless
    std::string meaning;  ///< of the key table; empty: an option of a solver
};

/// Every key with a value, in the order of the text, without the tables and arrays of tables that contain
/// others. Keys without a table row are listed too. Throws InputError for text that is not TOML.
[[nodiscard]] std::vector<WrittenKey> keys_written_in(std::string_view toml, std::string_view source_name);

}  // namespace camopt::input

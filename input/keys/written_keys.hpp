// SPDX-License-Identifier: MIT
// What a scene file sets, key by key, with unit and meaning: what a report lists so that it says everything.
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

/// Every key that holds a value, in the order of the text; the tables and arrays of tables that hold others
/// are not among them. Keys that no table row names are listed too. Throws InputError for text that is no
/// TOML.
[[nodiscard]] std::vector<WrittenKey> keys_written_in(std::string_view toml, std::string_view source_name);

}  // namespace camopt::input

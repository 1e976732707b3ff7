// SPDX-License-Identifier: MIT
// A CSV file of a measured motion: a line that names the columns, then rows of numbers.
//
// Columns are found by their names, whatever their order; others are left alone. They are parted by commas,
// semicolons or tabs, whichever the first line has; numbers have a decimal point whatever the locale. Empty
// lines and lines that begin with # are skipped. Internal to input/.
#pragma once

#include "scene/spellings.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace camopt::input {

struct MeasuredTable {
    std::string file;              ///< as messages name it
    std::string theta_key, s_key;  ///< "theta_deg", "s_mm"
    Spelling theta_unit, s_unit;
    std::vector<double> theta, s;  ///< as written
    std::vector<int> lines;        ///< of each row, from 1
};

/// Throws InputError "FILE:LINE: …" for columns that are missing, twice or in other units, cells that are no
/// finite number, angles that do not ascend, and files that cannot be read.
[[nodiscard]] MeasuredTable read_measured_table(const std::filesystem::path& file);
[[nodiscard]] MeasuredTable measured_table_of(std::string_view text, const std::string& name);

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// A CSV text as records of cells (RFC 4180, either line ending).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct CsvRecord {
    int line = 1;  ///< where it begins, from 1
    std::vector<std::string> cells;
};

/// Throws InputError "NAME:LINE: …" for a quote that does not end, or that ends within a cell.
[[nodiscard]] std::vector<CsvRecord> csv_records(std::string_view text, std::string_view name);

}  // namespace camopt

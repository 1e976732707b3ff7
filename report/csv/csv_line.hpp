// SPDX-License-Identifier: MIT
// One line of a CSV file, cell by cell (RFC 4180, line feed).
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

class CsvLine {
 public:
    /// Quoted where it holds a comma, a quote or a line break.
    CsvLine& words(std::string_view text);
    CsvLine& number(double value);  ///< reads back as the same double; empty where not finite
    CsvLine& number(const std::optional<double>& value) { return value ? number(*value) : blank(); }
    CsvLine& count(long value);
    CsvLine& blank(int cells = 1);

    /// With the line feed.
    [[nodiscard]] std::string finish() const { return text_ + "\n"; }

 private:
    void separate();

    std::string text_;
    bool first_ = true;
};

// A CSV text as records of cells (RFC 4180, either line ending).
struct CsvRecord {
    int line = 1;  ///< where it begins, from 1
    std::vector<std::string> cells;
};

/// Throws InputError "NAME:LINE: …" for a quote that does not end, or that ends within a cell.
[[nodiscard]] std::vector<CsvRecord> csv_records(std::string_view text, std::string_view name);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// One line of a CSV file, cell by cell (RFC 4180, line feed).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace camopt {

class CsvLine {
 public:
    /// Quoted where it holds a comma, a quote or a line break.
    CsvLine& words(std::string_view text);
    CsvLine& number(double value);  ///< reads back as the same double; empty where not finite
    CsvLine& number(const std::optional<double>& value);
    CsvLine& count(long value);
    CsvLine& blank(int cells = 1);

    /// With the line feed.
    [[nodiscard]] std::string finish() const { return text_ + "\n"; }

 private:
    void separate();

    std::string text_;
    bool first_ = true;
};

}  // namespace camopt

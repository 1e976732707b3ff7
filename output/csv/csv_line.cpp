// SPDX-License-Identifier: MIT
#include "output/csv/csv_line.hpp"

#include "output/words/number_text.hpp"

namespace camopt {

void CsvLine::separate() {
    if (!first_) text_ += ",";
    first_ = false;
}

CsvLine& CsvLine::words(std::string_view text) {
    separate();
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        text_ += text;
        return *this;
    }
    text_ += '"';
    for (const char letter : text) text_ += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    text_ += '"';
    return *this;
}

CsvLine& CsvLine::number(double value) {
    separate();
    text_ += round_trip_text(value);
    return *this;
}

CsvLine& CsvLine::number(const std::optional<double>& value) {
    return value ? number(*value) : blank();
}

CsvLine& CsvLine::count(long value) {
    separate();
    text_ += std::to_string(value);
    return *this;
}

CsvLine& CsvLine::blank(int cells) {
    for (int i = 0; i < cells; ++i) separate();
    return *this;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "report/csv/csv_line.hpp"

#include "core/errors.hpp"
#include "report/view/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

class Reader {
 public:
    Reader(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

    std::vector<CsvRecord> read() {
        std::vector<CsvRecord> records;
        while (!rest_.empty()) records.push_back(record());
        return records;
    }

 private:
    CsvRecord record() {
        CsvRecord record{line_, {}};
        while (true) {
            record.cells.push_back(rest_.starts_with('"') ? quoted_cell() : plain_cell());
            if (!rest_.starts_with(',')) break;
            rest_.remove_prefix(1);
        }
        if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
        if (rest_.starts_with('\n')) {
            rest_.remove_prefix(1);
            ++line_;
        } else if (!rest_.empty()) {
            throw InputError(
                fmt::format("{}:{}: found text behind a closing quote; allowed: a comma or the "
                            "end of the line",
                            name_, line_));
        }
        return record;
    }

    std::string plain_cell() {
        std::size_t end = rest_.find_first_of(",\n");
        if (end == std::string_view::npos) end = rest_.size();
        if (end > 0 && end < rest_.size() && rest_[end] == '\n' && rest_[end - 1] == '\r') --end;
        std::string cell(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return cell;
    }

    std::string quoted_cell() {
        const int begin = line_;
        std::string cell;
        for (rest_.remove_prefix(1); !rest_.empty(); rest_.remove_prefix(1)) {
            if (rest_.starts_with("\"\"")) {
                rest_.remove_prefix(1);
            } else if (rest_.starts_with('"')) {
                rest_.remove_prefix(1);
                return cell;
            }
            if (rest_.front() == '\n') ++line_;
            cell += rest_.front();
        }
        throw InputError(
            fmt::format("{}:{}: found a quote that does not end; allowed: a closing quote", name_, begin));
    }

    std::string_view rest_;
    std::string_view name_;
    int line_ = 1;
};

}  // namespace

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

CsvLine& CsvLine::count(long value) {
    separate();
    text_ += std::to_string(value);
    return *this;
}

CsvLine& CsvLine::blank(int cells) {
    for (int i = 0; i < cells; ++i) separate();
    return *this;
}

std::vector<CsvRecord> csv_records(std::string_view text, std::string_view name) {
    return Reader(text, name).read();
}

}  // namespace camopt

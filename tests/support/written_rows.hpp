// SPDX-License-Identifier: MIT
// Rows of keys against a file that has each of them in each of its units: what is read is what was written.
#pragma once

#include "input/row_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace camopt::testing_support {

/// As TOML, in which a number counts in its unit.
inline std::string toml_of(const KeyValue& value) {
    struct Writer {
        std::string operator()(std::monostate) const { return "{}"; }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(long long integer) const { return fmt::to_string(integer); }
        std::string operator()(double number) const { return fmt::to_string(number); }
        std::string operator()(const std::string& text) const { return fmt::format("'{}'", text); }
        std::string operator()(const std::vector<double>& all) const { return fmt::format("{}", all); }
        std::string operator()(const std::vector<std::string>& all) const { return fmt::format("{}", all); }
        std::string operator()(const KeyBounds& range) const {
            return fmt::format("{{ min = {}, max = {} }}", range.least.value(), range.most.value());
        }
        std::string operator()(const KeyPairs&) const { return "[]"; }
        std::string operator()(const KeyOptions&) const { return "{}"; }
    };
    return std::visit(Writer(), value);
}

/// The same value where one unit is `factor` in SI.
inline KeyValue in_si(const KeyValue& value, double factor) {
    if (const auto* const number = std::get_if<double>(&value)) return *number * factor;
    if (const auto* const range = std::get_if<KeyBounds>(&value))
        return KeyBounds{*range->least * factor, *range->most * factor};
    return value;
}

/// file_of(row, line): a file with this line in the table of the row. Returns how many were read.
template <class Owner, class Samples, class File>
int expect_rows_read_as_written(input::KeyRows rows, const Owner& start, const Samples& samples_of,
                                const File& file_of) {
    int read = 0;
    for (const KeyRow& row : rows) {
        if (!row.place->assign || row.type == KeyType::tables) continue;
        for (const Spelling& spelling : row.spellings)
            for (const KeyValue& sample : samples_of(row)) {
                const std::string text =
                    file_of(row, fmt::format("{} = {}\n", row.key(spelling), toml_of(sample)));
                SCOPED_TRACE(text);
                Owner owner = start;
                input::read_rows({.name = "file", .root = input::parse_document(text, "file"), .rows = rows},
                                 owner);
                EXPECT_EQ(row.place->value(owner, {.spelling = &spelling, .choices = row.choices.size()}),
                          in_si(sample, spelling.factor));
                ++read;
            }
    }
    return read;
}

}  // namespace camopt::testing_support

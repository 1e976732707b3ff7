// SPDX-License-Identifier: MIT
#include "output/view/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace camopt {

namespace {

/// Characters of a UTF-8 text: every byte that does not continue one.
std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

const std::string& cell(const std::vector<std::string>& row, std::size_t column) {
    static const std::string empty;
    return column < row.size() ? row[column] : empty;
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::string blanks(width - std::min(width, characters(text)), ' ');
    return left ? text + blanks : blanks + text;
}

std::vector<std::size_t> widths_of(const TextTable& table) {
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        widths.push_back(characters(table.columns[column].title));
        for (const auto& row : table.rows)
            widths.back() = std::max(widths.back(), characters(cell(row, column)));
    }
    return widths;
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

std::string markdown_cell(const std::string& text) {
    std::string escaped;
    for (const char letter : text) escaped += letter == '|' ? std::string("\\|") : std::string(1, letter);
    return escaped;
}

}  // namespace

std::string aligned_text(const TextTable& table) {
    const std::vector<std::size_t> widths = widths_of(table);
    std::string titles, rule, body;
    for (std::size_t column = 0; column < widths.size(); ++column) {
        const std::string gap = column == 0 ? "" : "  ";
        titles += gap + padded(table.columns[column].title, widths[column], table.columns[column].left);
        rule += gap;
        for (std::size_t i = 0; i < widths[column]; ++i) rule += "─";
    }
    for (const auto& row : table.rows) {
        std::string line;
        for (std::size_t column = 0; column < widths.size(); ++column) {
            if (column > 0) line += "  ";
            line += padded(cell(row, column), widths[column], table.columns[column].left);
        }
        body += without_trailing_blanks(line) + "\n";
    }
    return without_trailing_blanks(titles) + "\n" + rule + "\n" + body;
}

std::string markdown_text(const TextTable& table) {
    std::string text = "|", rule = "|";
    for (const TextTable::Column& column : table.columns) {
        text += fmt::format(" {} |", markdown_cell(column.title));
        rule += column.left ? " :--- |" : " ---: |";
    }
    text += "\n" + rule + "\n";
    for (const auto& row : table.rows) {
        text += "|";
        for (std::size_t column = 0; column < table.columns.size(); ++column)
            text += fmt::format(" {} |", markdown_cell(cell(row, column)));
        text += "\n";
    }
    return text;
}

std::string fixed_text(const std::optional<double>& value, int decimals) {
    if (!value || std::isnan(*value)) return "–";
    if (std::isinf(*value)) return *value > 0 ? "∞" : "−∞";
    return fmt::format("{:.{}f}", *value, decimals);
}

std::string wrapped_text(const std::string& words, const std::string& lead, int width) {
    std::string text, line = lead;
    bool fresh = true;
    std::istringstream stream(words);
    for (std::string word; stream >> word;) {
        if (!fresh && characters(line) + 1 + characters(word) > static_cast<std::size_t>(width)) {
            text += line + "\n";
            line = std::string(characters(lead), ' ');
            fresh = true;
        }
        line += (fresh ? "" : " ") + word;
        fresh = false;
    }
    return text + line + "\n";
}

}  // namespace camopt

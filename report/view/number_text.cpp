// SPDX-License-Identifier: MIT
#include "report/view/number_text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace camopt {

namespace {

constexpr double plain_below = 1e7;  // a larger number is read more easily with its power of ten

/// A typographic minus sign: as wide as a digit, never broken from its number.
std::string with_minus_sign(std::string text) {
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
    return text;
}

/// "2.5e+07" → "2.5e7".
std::string with_short_power(std::string text) {
    const std::size_t power = text.find('e');
    if (power == std::string::npos) return text;
    if (text[power + 1] == '+') text.erase(power + 1, 1);
    const std::size_t digit = power + (text[power + 1] == '-' ? 2 : 1);
    text.erase(digit, text.find_first_not_of('0', digit) - digit);
    return text;
}

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

std::string markdown_cell(const std::string& text, bool code = false) {
    std::string escaped;
    if (text.empty()) return escaped;
    for (const char letter : code ? markdown_code(text) : markdown_words(text))
        escaped += letter == '|' ? std::string("\\|") : std::string(1, letter);
    return escaped;
}

}  // namespace

std::string round_trip_text(double value) {
    if (!std::isfinite(value)) return {};
    return fmt::format("{}", value == 0.0 ? 0.0 : value);
}

std::string short_text(double value, int digits) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
    if (unit >= 1.0 && std::abs(value) < plain_below)
        return with_minus_sign(fmt::format("{:.0f}", unit * std::round(value / unit)));
    return power_text(value, digits);
}

std::string short_text(const std::optional<double>& value) {
    return value ? short_text(*value) : "–";
}

std::string power_text(double value, int digits) {
    return with_minus_sign(with_short_power(fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits)));
}

std::string change_text(double value, double reference) {
    const double change = 100.0 * (value - reference) / reference;
    if (!std::isfinite(change) || !std::isfinite(reference)) return "–";
    const double rounded = std::round(10.0 * change) / 10.0;
    if (rounded == 0.0) return "±0.0 %";
    return with_minus_sign(fmt::format("{:+.1f} %", rounded));
}

std::string words_of(std::string_view key) {
    std::string words(key);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

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

std::string markdown_words(std::string_view text) {
    const std::string words = printable(text);
    const auto letter_at = [&](std::size_t i) { return i < words.size() ? words[i] : ' '; };
    const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char next = letter_at(i + 1), last = i > 0 ? words[i - 1] : ' ';
        const auto before = [&](std::string_view marks) {
            return marks.find(next) != std::string_view::npos;
        };
        const bool obeyed = words[i] == '\\' || words[i] == '`' || words[i] == '*' ||
                            (words[i] == '_' && !(is_word(last) && is_word(next))) ||
                            (words[i] == '<' && (is_word(next) || before("/!?"))) ||
                            (words[i] == '&' && (is_word(next) || next == '#')) ||
                            (words[i] == ']' && before("([:")) ||
                            (i == 0 && (words[i] == '#' || words[i] == '>'));
        if (obeyed) result += '\\';
        result += words[i];
    }
    return result;
}

std::string markdown_code(std::string_view text) {
    const std::string words = printable(text);
    std::string fence = "`";
    while (words.find(fence) != std::string::npos) fence += '`';
    const std::string_view gap = fence.size() > 1 ? " " : "";
    return fmt::format("{0}{1}{2}{1}{0}", fence, gap, words);
}

std::string markdown_text(const TextTable& table) {
    std::string text = "|", rule = "|";
    for (const TextTable::Column& column : table.columns) {
        text += fmt::format(" {} |", markdown_cell(column.title));
        rule += column.left ? " :--- |" : " ---: |";
    }
    text += "\n" + rule + "\n";
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        text += "|";
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
            const std::string words = markdown_cell(cell(table.rows[r], column), table.columns[column].code);
            text += column == 0 && r < table.folders.size()
                        ? fmt::format(" [{}]({}/report.md) |", words, table.folders[r])
                        : fmt::format(" {} |", words);
        }
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

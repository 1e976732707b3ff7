// SPDX-License-Identifier: MIT
#include "shop/plc/structured_text.hpp"

#include "core/text/parsing.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace camopt {

namespace {

/// A literal of type REAL has digits on both sides of a point, before an exponent too.
std::string with_point(std::string digits) {
    if (digits.find('.') != std::string::npos) return digits;
    const std::size_t exponent = digits.find('e');
    return digits.insert(exponent == std::string::npos ? digits.size() : exponent, ".0");
}

std::string without_comments(std::string_view text) {
    std::string code;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//")
            i = std::min(text.find('\n', i), text.size()) - 1;
        else
            code += text[i];
    }
    return code;
}

template <class Number>
Number parsed_number(std::string_view text) {
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size())
        throw InputError(fmt::format("an electronic cam: found \"{}\" where a number stands", text));
    return value;
}

const std::string& value_at(const std::map<std::string, std::string>& fields, const std::string& field,
                            const std::string& where) {
    const auto found = fields.find(field);
    if (found == fields.end()) throw InputError(fmt::format("an electronic cam: {} has no {}", where, field));
    return found->second;
}

void assign(StElements& read, const std::string& target, const std::string& value) {
    const std::size_t open = target.rfind('['), close = target.rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) {
        read.fields[target] = value;
        return;
    }
    const int index = parsed_number<int>(std::string_view(target).substr(open + 1, close - open - 1));
    const std::string field = close + 2 <= target.size() ? target.substr(close + 2) : "";
    if (!read.elements[index].emplace(field, value).second)
        throw InputError(fmt::format("an electronic cam: {} is assigned twice", target));
}

void check_knots(const std::vector<EndState>& knots) {
    if (knots.size() < 2)
        throw InputError(
            fmt::format("an electronic cam: found {} points; allowed: two or more", knots.size()));
}

EndState state_of_piece(const CamPiece& piece, double theta) {
    return {theta, value_of(piece, theta, 0), value_of(piece, theta, 1), value_of(piece, theta, 2)};
}

}  // namespace

std::string lreal_text(double value) {
    return with_point(fmt::format("{}", value == 0.0 ? 0.0 : value));
}

std::string real_text(float value) {
    return with_point(fmt::format("{}", value == 0.0F ? 0.0F : value));
}

std::string comment_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += "// " + line + "\n";
    return text;
}

double StElements::number(int index, const std::string& field) const {
    return number_of(word(index, field));
}

float StElements::real(int index, const std::string& field) const {
    return real_of(word(index, field));
}

double StElements::number(const std::string& field) const {
    return number_of(value_at(fields, field, "the file"));
}

const std::string& StElements::word(int index, const std::string& field) const {
    const auto element = elements.find(index);
    if (element == elements.end())
        throw InputError(fmt::format("an electronic cam: found no element {}", index));
    return value_at(element->second, field, fmt::format("element {}", index));
}

StElements read_assignments(std::string_view text) {
    StElements read;
    const std::string code = without_comments(text);
    for (const std::string_view statement : split_text(code, ';')) {
        const std::size_t sign = statement.find(":=");
        if (sign == std::string_view::npos) continue;  // a declaration, a call
        std::string target(trimmed(statement.substr(0, sign)));
        // END_VAR and the like end without a semicolon.
        if (const std::size_t blank = target.find_last_of(" \t\r\n"); blank != std::string::npos)
            target.erase(0, blank + 1);
        assign(read, target, std::string(trimmed(statement.substr(sign + 2))));
    }
    return read;
}

double number_of(std::string_view text) {
    return parsed_number<double>(text);
}

float real_of(std::string_view text) {
    return parsed_number<float>(text);
}

std::vector<std::string> lines_of(std::string_view text) {
    const std::vector<std::string_view> parts = split_text(text, '\n');
    std::vector<std::string> lines(parts.begin(), parts.end());
    if (text.empty() || text.ends_with('\n')) lines.pop_back();  // nothing follows the last line's end
    return lines;
}

EndState state_at_begin(const CamPiece& piece) {
    return state_of_piece(piece, piece.begin);
}

EndState state_at_end(const CamPiece& piece) {
    return state_of_piece(piece, piece.end);
}

std::vector<EndState> knots_of(const std::vector<CamPiece>& pieces) {
    std::vector<EndState> knots;
    knots.reserve(pieces.size() + 1);
    for (const CamPiece& piece : pieces) knots.push_back(state_at_begin(piece));
    if (!pieces.empty()) knots.push_back(state_at_end(pieces.back()));
    return knots;
}

std::vector<CamPiece> quintics_between(const std::vector<EndState>& knots) {
    check_knots(knots);
    std::vector<CamPiece> pieces;
    for (std::size_t i = 1; i < knots.size(); ++i) pieces.push_back(quintic_between(knots[i - 1], knots[i]));
    return pieces;
}

std::vector<CamPiece> lines_between(const std::vector<EndState>& knots) {
    check_knots(knots);
    std::vector<CamPiece> pieces;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const EndState &from = knots[i - 1], &to = knots[i];
        pieces.push_back({from.theta, to.theta, {from.s, (to.s - from.s) / (to.theta - from.theta)}});
    }
    return pieces;
}

std::vector<double> numbers_between(std::string_view line, char separator, std::size_t count) {
    std::vector<double> numbers;
    constexpr std::string_view nothing;  // blanks around a number are none of it
    for (const std::string_view part : split_text(line, separator, nothing))
        numbers.push_back(number_of(part));
    if (numbers.size() != count)
        throw InputError(
            fmt::format("an electronic cam: found {} numbers in a line; allowed: {}", numbers.size(), count));
    return numbers;
}

std::vector<CamPiece> split_at(const CamPiece& piece, double part) {
    const double middle = piece.begin + part * (piece.end - piece.begin);
    return {{piece.begin, middle, piece.coefficients}, {middle, piece.end, polynomial_about(piece, middle)}};
}

}  // namespace camopt

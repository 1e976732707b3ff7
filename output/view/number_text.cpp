// SPDX-License-Identifier: MIT
#include "output/view/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

}  // namespace camopt

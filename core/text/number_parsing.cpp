// SPDX-License-Identifier: MIT
#include "core/text/number_parsing.hpp"

#include "core/errors.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace camopt {
namespace {

/// std::from_chars knows no locale. `text` loses what was read. The one sign it does not take is '+'.
template <typename Number>
std::optional<Number> take(std::string_view& text) {
    const std::size_t begin = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    Number value{};
    const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    if (!std::isfinite(static_cast<double>(value))) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

template <typename Number>
std::optional<Number> whole(std::string_view text) {
    const std::optional<Number> value = take<Number>(text);
    return text.empty() ? value : std::nullopt;
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
    return whole<double>(text);
}

std::optional<double> number_at_start(std::string_view text) {
    return take<double>(text);
}

std::optional<long long> integer_in(std::string_view text) {
    return whole<long long>(text);
}

double required_number(std::string_view text) {
    const std::optional<double> value = number_in(text);
    if (!value) throw ModelError("\"" + std::string(text) + "\" is no number");
    return *value;
}

}  // namespace camopt

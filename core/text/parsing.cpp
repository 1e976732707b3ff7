// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"

#include "core/errors.hpp"

#include <charconv>
#include <system_error>

namespace camopt {
namespace {

/// std::from_chars is independent of the locale, but rejects a leading '+'.
template <typename Number>
std::optional<Number> whole(std::string_view text) {
    const std::size_t begin = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    const char* const last = text.data() + text.size();
    Number value{};
    const auto [end, error] = std::from_chars(text.data() + begin, last, value);
    if (error != std::errc() || end != last || !std::isfinite(static_cast<double>(value)))
        return std::nullopt;
    return value;
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
    return whole<double>(text);
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

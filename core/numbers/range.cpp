// SPDX-License-Identifier: MIT
#include "core/numbers/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {
namespace {

// An inclusive bound also accepts a value moved by the rounding of a change of unit (360° in rad and back).
constexpr double rounding = 1e-14;

}  // namespace

bool Range::contains(double value) const {
    if (!std::isfinite(value)) return false;
    const bool not_below = low_included ? value >= low - rounding * std::abs(low) : value > low;
    const bool not_above = high_included ? value <= high + rounding * std::abs(high) : value < high;
    return (std::isinf(low) || not_below) && (std::isinf(high) || not_above);
}

Range Range::scaled(double factor) const {
    Range range = *this;
    range.low *= factor;
    range.high *= factor;
    return range;
}

std::string Range::text() const {
    const bool has_low = std::isfinite(low);
    const bool has_high = std::isfinite(high);
    if (has_low && has_high && low_included && high_included) return fmt::format("from {} to {}", low, high);
    const std::string below = has_low ? fmt::format("{} {}", low_included ? ">=" : ">", low) : "";
    const std::string above = has_high ? fmt::format("{} {}", high_included ? "<=" : "<", high) : "";
    return below + (has_low && has_high ? " and " : "") + above;
}

std::string Range::number_text() const {
    const std::string interval = text();
    return interval.empty() ? "a finite number" : "a number " + interval;
}

std::string Range::integer_text() const {
    const std::string interval = text();
    return interval.empty() ? "an integer" : "an integer " + interval;
}

}  // namespace camopt

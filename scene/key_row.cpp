// SPDX-License-Identifier: MIT
#include "scene/key_row.hpp"

#include "core/text/list_text.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

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

RefusedValue::RefusedValue(std::size_t item, const std::string& found, const std::string& allowed)
    : InputError(fmt::format("found {}; allowed: {}", found, allowed)), item_(item) {}

const KeyPlace& SharedPlace::none() {
    static const KeyPlace nowhere;
    return nowhere;
}

std::string KeyRow::cam_types_text(char quote) const {
    return listed(
        cam_types, " or ", [=](std::string_view cam) { return fmt::format("{0}{1}{0}", quote, cam); },
        " or ");
}

std::string KeyRow::choices_text() const {
    return type == KeyType::text ? quoted_choices(choices) : listed(choices, " or ");
}

std::string quoted_choices(const std::vector<std::string_view>& words) {
    return listed(words, " or ", in_quotes);
}

std::string KeyRow::key(const Spelling& spelling) const {
    return fmt::format("{}{}", name, spelling.suffix);
}

std::string keys_text(std::span<const KeyNames> names, const std::function<bool(const Spelling&)>& fits) {
    std::vector<std::string> fitting;
    for (const KeyNames& one : names)
        for (const Spelling& spelling : one.spellings)
            if (fits(spelling)) fitting.push_back(fmt::format("{}{}", one.name, spelling.suffix));
    return listed(fitting, " or ");
}

std::string KeyRow::allowed(const Spelling& spelling) const {
    if (!choices.empty() && type == KeyType::boolean_or_text)
        return "true, false or " + quoted_choices(choices);
    if (!choices.empty() && type == KeyType::text_or_table) return quoted_choices(choices) + ", or a table";
    if (!choices.empty()) return choices_text();
    const Range written = range.scaled(spellings.front().factor / spelling.factor);
    switch (type) {
        case KeyType::text:
            return "a text in quotes";
        case KeyType::boolean:
            return "true or false";
        case KeyType::integer:
            return range.integer_text();
        case KeyType::number:
            return written.number_text();
        case KeyType::number_or_range:
            return written.number_text() + ", or a range { min = …, max = … }";
        case KeyType::number_or_bounds:
            return written.number_text() + ", or a table { min = …, max = … }, where one may be missing";
        case KeyType::bounds:
            return "a table { min = …, max = … }, where one may be missing";
        case KeyType::number_or_points:
            return written.number_text() + ", or an array of pairs [place, number]";
        case KeyType::points:
            return "an array of pairs [place, number]";
        case KeyType::numbers:
            return "an array of numbers";
        case KeyType::texts:
            return "an array of texts in quotes";
        case KeyType::boolean_or_text:
            return "true or false";
        case KeyType::table:
            return fmt::format("a [{}] table", joined_key(table, name));
        case KeyType::tables:
            return "an array of tables";
        case KeyType::text_or_table:
            return "a text in quotes or a table";
        case KeyType::options:
            break;
    }
    return fmt::format("a [{}] table", joined_key(table, name));
}

}  // namespace camopt

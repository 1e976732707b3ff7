// SPDX-License-Identifier: MIT
#include "report/view/key_words.hpp"

#include "report/view/number_text.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/part_names.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// The limits whose names end so say the rest by ">=" and "<=".
constexpr std::array<std::string_view, 2> bounds = {"_min", "_max"};

constexpr int needed_digits = 5;

/// As many digits as are shown, on the side that still does.
double rounded_on(double needed, bool up) {
    if (needed == 0.0 || !std::isfinite(needed)) return needed;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(needed))) - (needed_digits - 1));
    const double steps = needed / unit, slack = 1e-6;  // of a step: a value that is round stays
    return unit * (up ? std::ceil(steps - slack) : std::floor(steps + slack));
}

bool is_listed(std::string_view key) {
    return key.starts_with("motion.") && key.find('[') != std::string_view::npos;
}

/// Of a number in a list of the motion. The unit is what follows the name.
KeyWords listed_key_words(std::string_view key) {
    const std::string_view side = key.ends_with(".max") ? ", max" : key.ends_with(".min") ? ", min" : "";
    if (!side.empty()) key.remove_suffix(std::string_view(".max").size());
    KeyWords found{fmt::format("{}{}", listed_words(key), side), "", false};
    if (const Spelling* const unit = unit_of_key(key)) found.unit = unit->sign;
    found.limit = !side.empty();
    return found;
}

/// "raise" and "lower" a limit, "lengthen" an angle, "increase" everything else.
std::string verb_of(const Relaxation& row, const KeyWords& key) {
    const bool more = *row.needed > row.given;
    if (key.limit) return more ? "raise" : "lower";
    if (row.key.find(".via[") != std::string::npos || row.key.find("].to") != std::string::npos)
        return "change";
    if (row.key.starts_with("motion.") && !row.key.starts_with("motion.lift") && is_angle_key(row.key))
        return more ? "lengthen" : "shorten";
    return more ? "increase" : "reduce";
}

}  // namespace

namespace {

/// Of a key of [tolerance] without its unit: "profile error", "tolerance of the base radius".
std::string tolerance_words(std::string_view key) {
    if (std::ranges::find(motion_tolerance_names, key) != motion_tolerance_names.end())
        return fmt::format("{} error", key);
    constexpr std::string_view percent = "_percent";
    if (key.ends_with(percent)) key.remove_suffix(percent.size());
    return fmt::format("tolerance of the {}", words_of(key));
}

}  // namespace

std::string KeyWords::subject() const {
    if (!limit) return words;
    const bool superlative = words.starts_with("largest ") || words.starts_with("least ");
    return superlative ? fmt::format("limit on the {}", words) : fmt::format("{} limit", words);
}

KeyWords key_words(std::string_view key, std::string_view remark) {
    if (is_listed(key)) return listed_key_words(key);
    KeyWords found;
    found.limit = key.starts_with("limits.") || key.starts_with("own.");
    const bool is_tolerance = key.starts_with("tolerance.");
    if (const std::size_t table = key.find('.'); table != std::string_view::npos)
        key.remove_prefix(table + 1);
    const std::string_view end_of_range = key.ends_with(".max")   ? "largest "
                                          : key.ends_with(".min") ? "least "
                                                                  : "";
    if (!end_of_range.empty()) key.remove_suffix(std::string_view(".max").size());
    if (const Spelling* const unit = unit_of_key(key)) {
        found.unit = unit->sign;
        key.remove_suffix(unit->suffix.size());
    }
    std::string_view side = end_of_range;
    for (const std::string_view bound : bounds) {
        if (!key.ends_with(bound)) continue;
        key.remove_suffix(bound.size());
        // Of a figure that both sides may be limited of the words tell which.
        if (bound == bounds[1] && limit_named(fmt::format("{}{}", key, bounds[0])) != nullptr)
            side = "largest ";
    }
    found.words = fmt::format("{}{}", side, words_of(key));
    if (is_tolerance) found.words = tolerance_words(key);
    for (const std::string end : {"start", "end"})  // a state there
        if (key.starts_with(end + "."))
            found.words = fmt::format("{} at the {}", words_of(key.substr(end.size() + 1)), end);
    if (!remark.empty()) found.words += fmt::format(" ({})", remark);
    return found;
}

namespace {

/// For who edits it: of a list with the key.
KeyWords edited_key(const std::string& key) {
    KeyWords words = key_words(key);
    if (is_listed(key)) words.words += fmt::format(" ({})", key);
    return words;
}

}  // namespace

bool is_exact(const Solution& solution, const Relaxation& row) {
    // A value that moved off before a solve succeeded is the solved one.
    return solution.plan && solution.plan->convex && key_words(row.key).limit && row.needed != row.solved;
}

std::string needed_number(const Relaxation& row) {
    if (!row.needed) return {};
    if (row.key == "spline.breakpoints") {
        const long parts = std::lround(*row.needed / row.given);
        return fmt::format("{} (every interval cut in {})", short_text(*row.needed, needed_digits),
                           parts == 2 ? "two" : fmt::format("{}", parts));
    }
    return short_text(row.solved.value_or(rounded_on(*row.needed, *row.needed > row.given)), needed_digits);
}

std::string also_words(const Relaxation& row) {
    std::string text;
    for (const CompanionChange& one : row.also) {
        const KeyWords key = edited_key(one.key);
        const std::string now = fmt::format("{} {}", short_text(one.solved, needed_digits), key.unit);
        const bool gives_way = one.solved < one.given;
        text += gives_way ? fmt::format(", taken from the {}, which becomes {}", key.words, now)
                          : fmt::format(", with the {} at {}", key.words, now);
    }
    return text;
}

std::string change_words(const Relaxation& row) {
    if (!row.needed) return {};
    if (row.key.starts_with("spline.")) {
        std::string number = needed_number(row);
        return "use " + number.insert(std::min(number.find(' '), number.size()), " segments");
    }
    const KeyWords key = edited_key(row.key);
    const std::string unit = key.unit.empty() ? "" : " " + key.unit;
    const bool listed = is_listed(row.key);
    return fmt::format(
        "{} the {}{} to {}{}{}", verb_of(row, key), key.subject(),
        listed && !key.limit ? fmt::format(" from {}", short_text(row.given, needed_digits)) : "",
        needed_number(row), unit, also_words(row));
}

}  // namespace camopt

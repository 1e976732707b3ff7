// SPDX-License-Identifier: MIT
#include "report/view/broken_limits.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int table_figures = 4;

std::string with_unit(double value, const std::string& unit) {
    return short_text(value, table_figures) + (unit.empty() ? "" : " " + unit_words(unit));
}

/// By how much of its scale the limit is passed.
double weight_of(const LimitOutcome& outcome) {
    return std::isnan(outcome.excess) ? infinity : outcome.excess / std::max(outcome.scale, 1e-12);
}

std::string broken_words(const LimitOutcome& outcome) {
    const ConstraintReport& reached = outcome.reached;
    const std::string name = words_of(reached.name);
    if (reached.name.starts_with("rest_"))
        return fmt::format("derivative {} is not 0 at the ends",
                           reached.name.substr(reached.name.find('_') + 1));
    if (reached.no_contact) return fmt::format("{}: {}", name, no_contact_words);
    if (std::isnan(outcome.excess)) return name + " does not exist: the cam cannot be built";
    if (reached.name == "symmetric")
        return fmt::format("not symmetric, by {}", short_text(outcome.excess, table_figures));
    const std::string found = fmt::format("{} {}", name, with_unit(reached.worst, reached.unit));
    if (std::isinf(outcome.excess))
        return fmt::format("{}, allowed {}", found, short_text(reached.limit, table_figures));
    const bool below = reached.worst < reached.limit;
    return fmt::format("{}, {} {} {}", found,
                       short_text(std::abs(outcome.excess), outcome.exact ? 3 : table_figures),
                       below ? "below" : "above", short_text(reached.limit, table_figures));
}

}  // namespace

std::vector<std::string> broken_limits(const ComparisonRow& row) {
    std::vector<std::pair<double, std::string>> broken;
    for (const LimitOutcome& outcome : row.limits) {
        if (!outcome.kept) broken.emplace_back(-weight_of(outcome), broken_words(outcome));
    }
    std::ranges::stable_sort(broken, {}, &std::pair<double, std::string>::first);
    std::vector<std::string> words;
    words.reserve(broken.size());
    for (auto& [weight, text] : broken) words.push_back(std::move(text));
    return words;
}

}  // namespace camopt

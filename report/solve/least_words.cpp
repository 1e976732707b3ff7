// SPDX-License-Identifier: MIT
#include "report/solve/least_words.hpp"

#include "core/text/list_text.hpp"
#include "report/view/key_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string number_of(double value, const std::string& unit) {
    return fmt::format("{:.10g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// The limits of the proof beside the sought number itself.
std::string because(const LeastReport& least) {
    std::vector<std::string> others;
    for (const std::string& key : least.limited_by) {
        const KeyWords words = key_words(key);
        const std::string one = fmt::format("{}{}", words.limit ? "the " : "", words.subject());
        if (key != least.key && std::ranges::find(others, one) == others.end()) others.push_back(one);
    }
    if (others.empty()) return {};
    return fmt::format(", together with {}",
                       listed(others, " and ", [](const std::string& one) { return one; }));
}

/// What is known beyond the value.
std::string claim(const LeastReport& least, const std::string& unit) {
    const char* const beyond = least.largest ? "above" : "below";
    if (!least.impossible) {
        if (least.verdict == Verdict::optimal) return "the end of its range";
        if (least.verdict == Verdict::feasible) return "practically 0, where its range ends";
        return fmt::format("as far as the search found; {} it motions may exist", beyond);
    }
    std::string at_it = fmt::format("at {} it is proved that no motion exists{}",
                                    number_of(*least.impossible, unit), because(least));
    if (least.verdict == Verdict::optimal) return at_it;
    if (least.verdict == Verdict::feasible) return at_it + "; between the two values nothing is known";
    return fmt::format("{}, but other values {} it may have motions", at_it, beyond);
}

}  // namespace

std::string least_sentence(const Solution& solution) {
    if (!solution.least) return {};
    const LeastReport& least = *solution.least;
    const KeyWords words = key_words(least.key);
    return fmt::format("The {} {} ({}) is {}: {}. The weights choose among the motions at it.",
                       least.largest ? "largest" : "least", words.subject(), least.key,
                       number_of(least.value, words.unit), claim(least, words.unit));
}

}  // namespace camopt

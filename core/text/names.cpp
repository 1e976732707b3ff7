// SPDX-License-Identifier: MIT
#include "core/text/names.hpp"

#include "core/text/list_text.hpp"
#include "core/word_of.hpp"

#include <fmt/format.h>

#include <numeric>

namespace camopt {

const char* name_of(MotionType value) {
    return word_of<MotionType::program>(value, {"DRD", "RR", "program"});
}

const char* name_of(DesignKind value) {
    return word_of<DesignKind::states>(value, {"auto", "ordinates", "coefficients", "states"});
}

namespace {

// Longer words are not misspellings.
constexpr std::size_t longest_word = 64;
// More candidates would not be a hint.
constexpr std::size_t most_words = 4;

char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Levenshtein distance; upper and lower case are the same.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (lower_case(a[i]) == lower_case(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::vector<std::string> parts_of(std::string_view word) {
    std::vector<std::string> parts(1);
    for (const char c : word) {
        if (c == '_' || c == '.' || c == '-')
            parts.emplace_back();
        else
            parts.back() += lower_case(c);
    }
    std::erase(parts, "");
    return parts;
}

bool holds_all(const std::string& candidate, const std::vector<std::string>& parts) {
    const std::vector<std::string> there = parts_of(candidate);
    return std::ranges::all_of(
        parts, [&](const std::string& part) { return std::ranges::find(there, part) != there.end(); });
}

}  // namespace

std::vector<std::string> words_like(std::string_view word, const std::vector<std::string>& candidates) {
    if (word.size() > longest_word) return {};
    // Two edits in a long word, one in a short one: more would suggest unrelated words.
    std::size_t least = (word.size() < 5 ? 1 : 2) + 1;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance >= least) continue;
        least = distance;
        nearest = &candidate;
    }
    if (nearest) return {*nearest};
    std::vector<std::string> found;
    const std::vector<std::string> parts = parts_of(word);
    if (parts.empty()) return {};
    for (const std::string& candidate : candidates)
        if (holds_all(candidate, parts)) found.push_back(candidate);
    if (found.size() > most_words) found.clear();
    return found;
}

std::string did_you_mean(const std::vector<std::string>& words) {
    if (words.empty()) return "";
    return fmt::format("; did you mean {}?",
                       listed(words, " or ", [](const std::string& word) { return "'" + word + "'"; }));
}

std::string spelling_hint(std::string_view word, const std::vector<std::string>& candidates) {
    return did_you_mean(words_like(word, candidates));
}

}  // namespace camopt

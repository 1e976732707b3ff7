// SPDX-License-Identifier: MIT
#include "input/keys/meaning_hint.hpp"

#include "core/text/spelling_hint.hpp"
#include "input/keys/scene_keys.hpp"
#include "scene/limit_table.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace camopt::input {
namespace {

struct Synonym {
    std::string_view table, word, name;  ///< `name`: of the key table, without a unit
};

constexpr std::array synonyms = {
    Synonym{"motion", "swing", "lift"},
    Synonym{"motion", "stroke", "lift"},
    Synonym{"motion", "travel", "lift"},
    Synonym{"motion", "amplitude", "lift"},
    Synonym{"motion", "rise_angle", "rise"},
    Synonym{"motion", "fall", "return"},
    Synonym{"motion", "return_angle", "return"},
    Synonym{"motion", "points", "via"},
    Synonym{"motion", "omega", "speed"},
    Synonym{"motion", "speed_of_rotation", "speed"},
    Synonym{"motion.segments", "displacement", "to"},
    Synonym{"motion.segments", "rise", "angle"},
    Synonym{"motion.segments", "type", "kind"},
    Synonym{"spline", "order", "degree"},
    Synonym{"spline", "intervals", "segments"},
    Synonym{"spline", "pieces", "segments"},
    Synonym{"cam", "base_circle", "base_radius"},
    Synonym{"cam", "base_circle_radius", "base_radius"},
    Synonym{"cam", "prime_radius", "base_radius"},
    Synonym{"cam", "eccentricity", "offset"},
    Synonym{"cam", "pivot_distance", "center_distance"},
    Synonym{"cam", "arm", "arm_length"},
    Synonym{"cam", "lever_length", "arm_length"},
    Synonym{"cam", "follower_type", "follower"},
    Synonym{"cam", "direction", "rotation"},
    Synonym{"solver", "backend", "name"},
    Synonym{"solver", "method", "name"},
    Synonym{"solver", "max_time", "max_seconds"},
    Synonym{"solver", "time_limit", "max_seconds"},
    Synonym{"solver", "timeout", "max_seconds"},
};

std::vector<Synonym> all_synonyms() {
    std::vector<Synonym> all(synonyms.begin(), synonyms.end());
    const auto add = [&](std::string_view name, std::span<const std::string_view> words) {
        for (const std::string_view word : words) all.push_back({"limits", word, name});
    };
    for (const PeakLimitRow& row : peak_limit_rows()) add(row.name(), row.also_called);
    for (const LimitRow& row : limit_rows()) add(row.name, row.also_called);
    return all;
}

struct PartSynonym {
    std::string_view word, part;
};

/// Of the names of followers.
constexpr std::array follower_parts = {
    PartSynonym{"swinging", "oscillating"},
    PartSynonym{"swing", "oscillating"},
    PartSynonym{"rocking", "oscillating"},
    PartSynonym{"pivoted", "oscillating"},
    PartSynonym{"reciprocating", "translating"},
    PartSynonym{"linear", "translating"},
    PartSynonym{"plane", "flat"},
    PartSynonym{"mushroom", "flat"},
    PartSynonym{"edge", "knife"},
    PartSynonym{"pointed", "knife"},
    PartSynonym{"wheel", "roller"},
};

std::string follower_in_our_words(std::string_view text) {
    std::string word(text);
    std::ranges::replace(word, ' ', '_');
    for (const PartSynonym& synonym : follower_parts) {
        const std::size_t place = word.find(synonym.word);
        const bool begins = place == 0 || (place != std::string::npos && word[place - 1] == '_');
        const std::size_t end = place + synonym.word.size();
        if (begins && (end == word.size() || word[end] == '_'))
            word.replace(place, synonym.word.size(), synonym.part);
    }
    return word;
}

/// Of cam.rotation.
constexpr std::array rotations = {
    PartSynonym{"cw", "clockwise"},
    PartSynonym{"ccw", "counterclockwise"},
    PartSynonym{"anticlockwise", "counterclockwise"},
};

/// A word of rises, dwells and returns in the notation of other programs: D, R and F. Dwells at the ends are
/// implied in every motion.
std::string motion_meant(std::string_view text) {
    std::string strokes;
    for (const char c : text) {
        const std::size_t letter = std::string_view("DRFdrf").find(c);
        if (letter == std::string_view::npos) return "";
        strokes += letter % 3 == 0 ? 'D' : 'R';
    }
    const std::size_t first = strokes.find('R');
    if (first == std::string::npos) return "";
    strokes = strokes.substr(first, strokes.find_last_of('R') - first + 1);
    if (strokes == "R") return "; did you mean 'DRD'?";
    if (strokes == "RR") return "; did you mean 'RR'?";
    return "; did you mean 'program', with its rises, returns and dwells as [[motion.segments]]?";
}

}  // namespace

std::string key_meant(std::string_view table, std::string_view written) {
    static const std::vector<Synonym> all = all_synonyms();
    for (const Synonym& synonym : all) {
        if (synonym.table != table || !written.starts_with(synonym.word)) continue;
        const std::string_view suffix = written.substr(synonym.word.size());
        const KeyRow* const row = find_row(table, synonym.name);
        if (!row) continue;
        for (const Spelling& spelling : row->spellings)
            if (spelling.suffix == suffix) return row->key(spelling);
        if (suffix.empty()) return row->key(row->spellings.front());
    }
    return "";
}

std::string choice_hint(std::string_view path, std::string_view text,
                        const std::vector<std::string>& choices) {
    if (path == "motion.type")
        if (std::string hint = motion_meant(text); !hint.empty()) return hint;
    if (path == "cam.rotation")
        for (const PartSynonym& synonym : rotations)
            if (text == synonym.word) return did_you_mean({std::string(synonym.part)});
    if (path == "cam.follower")
        if (const std::string word = follower_in_our_words(text); word != text) {
            if (std::ranges::find(choices, word) != choices.end()) return did_you_mean({word});
            return spelling_hint(word, choices);
        }
    return spelling_hint(text, choices);
}

}  // namespace camopt::input

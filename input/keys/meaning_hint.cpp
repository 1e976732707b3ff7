// SPDX-License-Identifier: MIT
#include "input/keys/meaning_hint.hpp"

#include "profiles/kinds/cam_kinds.hpp"
#include "scene/limit_table.hpp"

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
    for (const CamKind& kind : cam_kinds())
        for (const CamSynonym& synonym : kind.also_called)
            all.push_back({"cam", synonym.word, synonym.meant});
    for (const PeakLimitRow& row : peak_limit_rows()) add(row.name(), row.also_called);
    for (const LimitRow& row : limit_rows()) add(row.name, row.also_called);
    return all;
}

/// The word of a variant in the words of its kind.
std::string in_our_words(std::string_view text) {
    std::string word(text);
    std::ranges::replace(word, ' ', '_');
    for (const CamKind& kind : cam_kinds())
        for (const CamSynonym& synonym : kind.parts_called) {
            const std::size_t place = word.find(synonym.word);
            const bool begins = place == 0 || (place != std::string::npos && word[place - 1] == '_');
            const std::size_t end = place + synonym.word.size();
            if (begins && (end == word.size() || word[end] == '_'))
                word.replace(place, synonym.word.size(), synonym.meant);
        }
    return word;
}

/// Of cam.rotation.
constexpr std::array rotations = {
    CamSynonym{"cw", "clockwise"},
    CamSynonym{"ccw", "counterclockwise"},
    CamSynonym{"anticlockwise", "counterclockwise"},
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
    for (const Synonym& synonym : all_synonyms()) {
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
        for (const CamSynonym& synonym : rotations)
            if (text == synonym.word) return did_you_mean({std::string(synonym.meant)});
    if (path == "cam.follower")
        if (const std::string word = in_our_words(text); word != text) {
            if (std::ranges::find(choices, word) != choices.end()) return did_you_mean({word});
            return spelling_hint(word, choices);
        }
    return spelling_hint(text, choices);
}

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
#include "input/keys/scene_keys.hpp"

#include "core/text/list_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

#include <fmt/format.h>

#include <deque>
#include <mutex>

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

using Rows = std::vector<KeyRow>;

/// The rows, and the texts that were joined for them.
struct KeyTable {
    Rows rows;
    std::deque<std::string> texts;

    /// After the others of its table, so that a table is listed once.
    void add(KeyRow row) {
        const auto last = std::find_if(rows.rbegin(), rows.rend(),
                                       [&](const KeyRow& other) { return other.table == row.table; });
        rows.insert(last == rows.rend() ? rows.end() : last.base(), std::move(row));
    }
    void add(std::span<const KeyRow> all) {
        for (const KeyRow& row : all) add(row);
    }
    /// Joined with that of an earlier kind, where there is one.
    void add_of_kind(const KeyRow& row) {
        const auto same = std::ranges::find_if(
            rows, [&](const KeyRow& other) { return other.table == row.table && other.name == row.name; });
        if (same == rows.end()) return add(row);
        if (same->meaning != row.meaning)
            same->meaning = texts.emplace_back(fmt::format("{} {}", same->meaning, row.meaning));
        constexpr std::string_view needed = "required for ";
        if (same->default_text != row.default_text && same->default_text.starts_with(needed) &&
            row.default_text.starts_with(needed))
            same->default_text = texts.emplace_back(
                fmt::format("{}, {}", same->default_text, row.default_text.substr(needed.size())));
    }
};

/// What chooses a kind: in the order of the manual.
KeyRow type_row(KeyTable& table) {
    std::string spoken;
    for (const CamKind& kind : cam_kinds())
        append_item(spoken, kind.spoken.empty() ? kind.type : kind.spoken);
    return called("kind of cam", {"cam", "type", text, plain, any, cam_types(), "required",
                                  table.texts.emplace_back(fmt::format("The kind of cam: {}.", spoken))});
}

/// What a key may say that chooses within a kind.
void add_words_of_variants(Rows& rows) {
    for (const CamKind& kind : cam_kinds())
        for (KeyRow& row : rows) {
            if (kind.choosing_key != row.name || kind.choosing_table != row.table) continue;
            for (const CamVariant& variant : kind.variants)
                if (std::ranges::find(row.choices, variant.word) == row.choices.end())
                    row.choices.emplace_back(variant.word);
        }
}

/// Empty if it belongs to no kind, or to all.
std::vector<std::string_view> kinds_that_know(const KeyRow& row) {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.knows(row.table, row.name)) types.emplace_back(kind.type);
    if (types.size() == cam_kinds().size()) types.clear();
    return types;
}

const CamVariant* variant_of(const CamKind& kind, const CamSpec& cam) {
    const auto is_own = [&](const CamVariant& variant) {
        return kind.variants.size() == 1 ||
               std::ranges::any_of(cam.choices, [&](const auto& one) { return one.second == variant.word; });
    };
    const auto found = std::ranges::find_if(kind.variants, is_own);
    return found == kind.variants.end() ? nullptr : &*found;
}

/// A key of a scene's cam, as its kind describes it.
struct CamKey {
    std::string table, name;

    [[nodiscard]] bool is(const auto& entry) const {
        return entry.owned && entry.table == table && entry.key == name;
    }
    /// The dimension that the key says; null: none does, or one that the kind adds itself.
    [[nodiscard]] const Dimension* dimension(const CamSpec& cam, const CamVariant& variant) const {
        for (const CamNumber& number : variant.numbers)
            if (is(number) && number.index >= 0)
                return &cam.dimensions.at(static_cast<std::size_t>(number.index)).value;
        return nullptr;
    }
    [[nodiscard]] std::optional<KeyValue> value(const Scene& scene) const {
        if (!scene.cam) return std::nullopt;
        const CamSpec& cam = *scene.cam;
        const CamKind* const kind = cam_kind(cam.type);
        if (kind == nullptr || !kind->knows(table, name)) return std::nullopt;
        if (table.empty()) return KeyValue();
        if (table == "cam" && name == "type") return cam.type;
        const CamVariant* const variant = variant_of(*kind, cam);
        if (variant == nullptr) return std::nullopt;
        if (table == kind->choosing_table && name == kind->choosing_key) return variant->word;
        for (const CamChoice& choice : variant->choices)
            if (is(choice)) return chosen_word(cam, *variant);
        for (const CamNumber& number : variant->numbers)
            if (is(number)) return of_number(number, scene, *variant);
        return std::nullopt;
    }

 private:
    /// None: the default.
    [[nodiscard]] std::optional<KeyValue> chosen_word(const CamSpec& cam, const CamVariant& variant) const {
        const std::string word = cam.choice(name);
        return word == variant.spec().choice(name) ? std::nullopt : std::optional<KeyValue>(word);
    }
    [[nodiscard]] std::optional<KeyValue> of_number(const CamNumber& number, const Scene& scene,
                                                    const CamVariant& variant) const {
        const CamSpec& cam = *scene.cam;
        if (name == "face_radius") return key_place::value_of(cam.face_radius);
        if (name == "face_half_width")
            return cam.face_radius ? std::nullopt : key_place::value_of(cam.face_half_width);
        const Dimension* const own = dimension(cam, variant);
        const Dimension* const given = own != nullptr ? own : cam.find(name);
        if (given == nullptr || is_default(number, *given, scene)) return std::nullopt;
        return given->is_variable() ? KeyValue(KeyBounds{given->low, given->high}) : KeyValue(given->low);
    }
    [[nodiscard]] bool is_default(const CamNumber& number, const Dimension& given, const Scene& scene) const {
        const KeyRow* const row = find_row(table, name);
        const bool first = given.key.empty() || row == nullptr ||
                           given.key == fmt::format("{}.{}", table, row->key(row->spellings.front()));
        if (number.index < 0) return given.low == 0.0;  // of a number that a kind adds itself
        return first && number.value && !given.is_variable() &&
               given.low == *number.value + number.per_lift * scene.motion.lift;
    }
};

/// As the cam's dimensions say how they are written.
KeyPlace cam_place(const KeyRow& row) {
    const CamKey key{std::string(row.table), std::string(row.name)};
    KeyPlace place;
    place.value = [key](const Scene& scene, const KeyAt&) { return key.value(scene); };
    place.unit = [key, spellings = row.spellings](const Scene& scene, const KeyAt&) {
        const CamKind* const kind = cam_kind(scene.cam->type);
        const CamVariant* const variant = kind != nullptr ? variant_of(*kind, *scene.cam) : nullptr;
        const Dimension* const given = variant != nullptr ? key.dimension(*scene.cam, *variant) : nullptr;
        if (given == nullptr)
            return std::string(scene.spelling_of(fmt::format("{}.{}", key.table, key.name), {}).unit);
        for (const Spelling& spelling : spellings)
            if (given->key == fmt::format("{}.{}{}", key.table, key.name, spelling.suffix))
                return std::string(spelling.unit);
        return std::string();
    };
    return place;
}

/// Every dimension of a cam may have a tolerance.
void add_tolerances(KeyTable& table) {
    Rows rows;
    for (const KeyRow& row : table.rows) {
        const bool is_dimension =
            row.type == number_or_range && std::ranges::any_of(cam_kinds(), [&](const CamKind& kind) {
                return kind.knows(row.table, row.name);
            });
        if (is_dimension && std::ranges::find(rows, row.name, &KeyRow::name) == rows.end())
            rows.push_back(key_rows::tolerance_of(
                row, table.texts.emplace_back(fmt::format("± of `{}.{}`.", row.table, row.name))));
    }
    table.add(rows);
}

KeyTable all_rows() {
    KeyTable all;
    all.add(key_rows::before_cam());
    all.add(type_row(all));
    for (const CamKind& kind : cam_kinds())
        for (const KeyRow& row : kind.rows) all.add_of_kind(row);
    all.add(key_rows::after_cam());
    add_tolerances(all);
    add_words_of_variants(all.rows);
    for (KeyRow& row : all.rows) {
        row.cam_types = kinds_that_know(row);
        if (!row.place) row.place = cam_place(row);
    }
    return all;
}

}  // namespace

std::string_view motion_types_of(std::string_view key, std::string_view type) {
    constexpr std::string_view not_valve = "other types; a valve lobe is said by lift, duration and ramps";
    struct Only {
        std::vector<std::string_view> keys, types;
        std::string_view words;
    };
    static const std::vector<Only> table = {
        {{"rocker_ratio", "valve_arm", "lash", "checking_height", "duration", "opening", "centerline",
          "opening_ramp", "closing_ramp"},
         {"valve"},
         "type \"valve\""},
        {{"rise", "return", "segments", "closed", "repeat", "stops", "start", "end", "symmetric", "monotone",
          "within_lift", "via"},
         {"DRD", "RR", "program"},
         not_valve},
        {{"segments", "closed", "repeat"}, {"program"}, "type \"program\""},
        {{"phase"}, {"program", "valve"}, "type \"program\" or \"valve\""},
        {{"rise", "return"},
         {"DRD", "RR"},
         "type \"DRD\" or \"RR\"; a program says the angle of each of its segments"},
        {{"symmetric"}, {"DRD", "RR"}, "type \"DRD\" or \"RR\""},
        {{"via"},
         {"DRD", "RR"},
         "type \"DRD\" or \"RR\"; a program has set points in its segments, via in each"}};
    for (const auto& [keys, types, words] : table)
        if (std::ranges::find(keys, key) != keys.end() && std::ranges::find(types, type) == types.end())
            return words;
    return {};
}

const std::vector<KeyRow>& scene_keys() {
    // A program may add kinds: one table per number of kinds, so that returned rows remain valid.
    static std::mutex mutex;
    static std::map<std::size_t, KeyTable> tables;
    const std::lock_guard lock(mutex);
    const auto [table, fresh] = tables.try_emplace(cam_kinds().size());
    if (fresh) table->second = all_rows();
    return table->second.rows;
}

}  // namespace camopt::input

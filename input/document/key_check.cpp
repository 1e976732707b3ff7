// SPDX-License-Identifier: MIT
#include "core/text/list_text.hpp"
#include "core/text/names.hpp"
#include "core/text/parsing.hpp"
#include "input/document/scene_source.hpp"
#include "input/keys/meaning_hint.hpp"
#include "profiles/kinds/cam_kinds.hpp"

#include <fmt/ranges.h>

namespace camopt::input {
namespace {

class KeyCheck {
 public:
    KeyCheck(const SceneSource& source, bool complete) : source_(source), complete_(complete) {}

    void run() const { check_table(source_.root, "", ""); }

 private:
    const SceneSource& source_;
    bool complete_;  ///< a missing key is a fault

    /// `table`: the name in the key table; `path`: as the user would write it, with indices.
    void check_table(const Node& node, std::string_view table, const std::string& path) const {
        for (const Member& member : node.members) {
            const KeyMatch match = match_key(table, member.name, source_.rows);
            const std::string key = joined_key(path, member.name);
            if (!match.row) refuse_unknown(member, table, key);
            const Given given{&member, match.row, match.spelling};
            refuse_second_spelling(node, given, path);
            refuse_other_cam(given, key);
            check_value(given, key);
        }
        if (!complete_) return;
        for (const KeyRow& row : source_.rows)
            if (row.table == table && row.required() && is_of_this_cam(row) &&
                !source_.find_in(node, table, row.name))
                source_.fail(node.place, joined_key(path, row.first_key()),
                             fmt::format("missing; allowed: {}", row.allowed(row.spellings.front())));
    }

    /// cam.type as written; empty if missing.
    [[nodiscard]] std::string_view cam_type() const {
        const auto type = source_.find("cam", "type");
        return type ? std::string_view(type->value().text) : std::string_view{};
    }
    [[nodiscard]] bool is_of_this_cam(const KeyRow& row) const { return row.is_for(cam_type()); }
    void refuse_other_cam(const Given& given, const std::string& key) const {
        if (is_of_this_cam(*given.row)) return;
        // Without a type the missing type is the fault.
        if (given.row->table == "cam" && cam_type().empty()) return;
        source_.fail(given.member->place, key,
                     fmt::format("found a key for cams of type {0}; allowed: only with cam.type = {0}{1}",
                                 given.row->cam_types_text('"'), chosen_elsewhere(key)));
    }

    /// For another type of cam, where `key` selects the follower. Empty: no such key.
    [[nodiscard]] std::string chosen_elsewhere(std::string_view key) const {
        const auto choosing = [](const CamKind& kind) {
            return joined_key(kind.choosing_table, kind.choosing_key);
        };
        const CamKind* const own = cam_kind(cam_type());
        if (own == nullptr || std::ranges::find(cam_kinds(), key, choosing) == cam_kinds().end()) return {};
        return own->choosing_key.empty()
                   ? fmt::format("; cam.type = \"{}\" already determines this value: remove the key",
                                 own->type)
                   : fmt::format("; with cam.type = \"{}\" the key {} chooses it", own->type, choosing(*own));
    }

    /// The tables allowed with this type of cam; a [cam] without a type counts as a disk cam.
    [[nodiscard]] std::vector<std::string> keys_of_this_cam(std::string_view table) const {
        const std::string_view type =
            table == "cam" && cam_type().empty() ? std::string_view(cam_kinds().front().type) : cam_type();
        std::vector<std::string> keys;
        for (const KeyRow& row : source_.rows) {
            if (row.table != table || !row.is_for(type)) continue;
            for (const Spelling& spelling : row.spellings) keys.push_back(row.key(spelling));
        }
        return keys;
    }

    [[noreturn]] void refuse_unknown(const Member& member, std::string_view table,
                                     const std::string& key) const {
        const std::vector<std::string> allowed = keys_of_this_cam(table);
        std::string hint = spelling_hint(member.name, allowed);
        if (const KeyRow* const row = find_row(table, member.name, source_.rows))  // the unit is missing
            hint = fmt::format("; did you mean '{}'?", row->key(row->spellings.front()));
        if (const std::string meant = key_meant(table, member.name); !meant.empty())  // a synonym
            hint = did_you_mean({meant});
        if (table.empty() && member.name == "machine")
            hint = "; this is a file of a machine, for camopt machine and camopt sweep";
        for (const KeyRow& row : source_.rows)  // in the wrong table
            if (hint.empty() && match_key(row.table, member.name, source_.rows).row != nullptr)
                hint = fmt::format("; did you mean '{}'?", joined_key(row.table, member.name));
        source_.fail(member.place, key,
                     fmt::format("found an unknown key; allowed: {}{}", fmt::join(allowed, ", "), hint));
    }

    void refuse_second_spelling(const Node& node, const Given& given, const std::string& path) const {
        for (const Member& other : node.members) {
            if (&other == given.member) break;
            const KeyRow* row = match_key(given.row->table, other.name, source_.rows).row;
            if (row == given.row || row->name == given.row->instead_of || row->instead_of == given.row->name)
                source_.fail(
                    given.member->place, joined_key(path, given.member->name),
                    fmt::format("found together with {}, which means the same; allowed: only one of the two",
                                joined_key(path, other.name)));
        }
    }

    void check_value(const Given& given, const std::string& key) const {
        switch (given.row->type) {
            case KeyType::text:
                return check_text(given, key);
            case KeyType::boolean:
                return refuse_unless(given.value().kind == NodeKind::boolean, given, key);
            case KeyType::integer:
                return check_integer(given, key);
            case KeyType::number:
                return check_number(given, key);
            case KeyType::number_or_range:
                return check_number_or_range(given, key);
            case KeyType::number_or_bounds:
                if (given.value().kind != NodeKind::table) return check_size(given, key);
                [[fallthrough]];
            case KeyType::bounds:
                refuse_unless(given.value().kind == NodeKind::table, given, key);
                return check_bounds(given, key, false);
            case KeyType::number_or_points:
                if (given.value().kind != NodeKind::array) return check_number(given, key);
                [[fallthrough]];
            case KeyType::points:
                return check_points(given, key);
            case KeyType::numbers:
                return check_numbers(given, key);
            case KeyType::texts:
                return check_texts(given, key);
            case KeyType::boolean_or_text:
                if (given.value().kind != NodeKind::boolean) return check_text(given, key);
                return;
            case KeyType::tables:
                return check_tables(given, key);
            case KeyType::text_or_table:
                if (given.value().kind == NodeKind::text) return check_text(given, key);
                [[fallthrough]];
            case KeyType::table:
                refuse_unless(given.value().kind == NodeKind::table, given, key);
                return check_table(given.value(), joined_key(given.row->table, given.row->name), key);
            case KeyType::options:
                return check_options(given, key);
        }
    }

    void check_text(const Given& given, const std::string& key) const {
        const Node& value = given.value();
        const auto& choices = given.row->choices;
        refuse_unless(value.kind == NodeKind::text, given, key);
        if (choices.empty() || std::ranges::find(choices, value.text) != choices.end()) return;
        const std::vector<std::string> words(choices.begin(), choices.end());
        source_.fail(value.place, key,
                     fmt::format("found {}; allowed: {}{}", value.shown(),
                                 given.row->allowed(*given.spelling), choice_hint(key, value.text, words)));
    }

    void check_integer(const Given& given, const std::string& key) const {
        const Node& value = given.value();
        const std::string allowed = given.row->allowed(*given.spelling);
        if (value.kind == NodeKind::number && std::trunc(value.number) == value.number)
            source_.fail(
                value.place, key,
                fmt::format("found {}, a number with a decimal point or exponent; allowed: {}, written "
                            "without one",
                            value.shown(), allowed));
        const auto& choices = given.row->choices;
        refuse_unless(value.kind == NodeKind::integer &&
                          (choices.empty() ? given.row->range.contains(static_cast<double>(value.integer))
                                           : std::ranges::find(choices, value.shown()) != choices.end()),
                      given, key);
    }

    void check_number(const Given& given, const std::string& key) const {
        const Node& value = given.value();
        const Range range = written_range(given);
        if (value.kind == NodeKind::table && !given.row->no_range.empty())
            source_.fail(value.place, key,
                         fmt::format("found a table; allowed: {}: {}", given.row->allowed(*given.spelling),
                                     given.row->no_range));
        refuse_unless(value.is_number() && range.contains(value.as_number()), given, key);
    }

    /// One number for both sides: of a magnitude.
    void check_size(const Given& given, const std::string& key) const {
        const Node& value = given.value();
        if (!value.is_number() || !ranges::positive.contains(value.as_number()))
            source_.fail(value.place, key,
                         fmt::format("found {}; allowed: a number > 0, or a table {{ min = …, max = … }}, "
                                     "where one may be missing",
                                     value.shown()));
    }

    void check_number_or_range(const Given& given, const std::string& key) const {
        if (given.value().kind != NodeKind::table) return check_number(given, key);
        check_bounds(given, key, true);
    }

    /// { min = …, max = … }. both: neither may be missing.
    void check_bounds(const Given& given, const std::string& key, bool both) const {
        const Range range = written_range(given);
        for (const Member& member : given.value().members) {
            const std::string bound_key = joined_key(key, member.name);
            if (member.name != "min" && member.name != "max")
                source_.fail(member.place, bound_key, "found an unknown key; allowed: min, max");
            if (!member.value.is_number() || !range.contains(member.value.as_number()))
                source_.fail(member.value.place, bound_key,
                             fmt::format("found {}; allowed: {}", member.value.shown(), range.number_text()));
        }
        const Member *const least = given.value().find("min"), *const most = given.value().find("max");
        if (!both && (least == nullptr) != (most == nullptr)) return;
        if (least == nullptr || most == nullptr)
            source_.fail(given.value().place, joined_key(key, least == nullptr ? "min" : "max"),
                         fmt::format("missing; allowed: {}", range.number_text()));
        const Node &min = least->value, &max = most->value;
        if (!(min.as_number() < max.as_number()))
            source_.fail(
                given.value().place, key,
                fmt::format("found a range from {} to {}; allowed: min below max", min.shown(), max.shown()));
    }

    static Range written_range(const Given& given) {
        return given.row->range.scaled(given.row->spellings.front().factor / given.spelling->factor);
    }

    void check_numbers(const Given& given, const std::string& key) const {
        refuse_unless(given.value().kind == NodeKind::array, given, key);
        const std::vector<Node>& items = given.value().items;
        for (std::size_t i = 0; i < items.size(); ++i)
            if (!items[i].is_number() || !given.row->range.contains(items[i].as_number()))
                source_.fail(
                    items[i].place, entry_key(key, i),
                    fmt::format("found {}; allowed: {}", items[i].shown(), given.row->range.number_text()));
    }

    void check_texts(const Given& given, const std::string& key) const {
        refuse_unless(given.value().kind == NodeKind::array, given, key);
        const auto& choices = given.row->choices;
        for (const Node& item : given.value().items)
            if (item.kind != NodeKind::text ||
                (!choices.empty() && std::ranges::find(choices, item.text) == choices.end()))
                source_.fail(item.place, key,
                             fmt::format("found {} in the array; allowed: {}", item.shown(),
                                         choices.empty() ? "texts in quotes" : given.row->choices_text()));
    }

    /// Pairs of a place and a number, the places ascending.
    void check_points(const Given& given, const std::string& key) const {
        const std::vector<Node>& items = given.value().items;
        refuse_unless(!items.empty(), given, key);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::vector<Node>& pair = items[i].items;
            const bool good = pair.size() == 2 && pair[0].is_number() && pair[1].is_number() &&
                              std::isfinite(pair[0].as_number()) && std::isfinite(pair[1].as_number());
            if (!good || (i > 0 && !(pair[0].as_number() > items[i - 1].items[0].as_number())))
                source_.fail(
                    items[i].place, entry_key(key, i),
                    fmt::format("found {}; allowed: a pair [angle, number], the angles ascending",
                                good ? fmt::format("the angle {}", pair[0].shown()) : items[i].shown()));
        }
    }

    void check_tables(const Given& given, const std::string& key) const {
        refuse_unless(given.value().kind == NodeKind::array, given, key);
        const std::vector<Node>& items = given.value().items;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::string item_key = entry_key(key, i);
            if (items[i].kind != NodeKind::table)
                source_.fail(items[i].place, item_key,
                             fmt::format("found {}; allowed: a table of {}", items[i].shown(),
                                         fmt::join(written_keys(key, source_.rows), ", ")));
            check_table(items[i], joined_key(given.row->table, given.row->name), item_key);
        }
    }

    void check_options(const Given& given, const std::string& key) const {
        refuse_unless(given.value().kind == NodeKind::table, given, key);
        for (const Member& option : given.value().members) {
            const Node& value = option.value;
            const bool scalar = value.kind == NodeKind::boolean || value.kind == NodeKind::text ||
                                (value.is_number() && std::isfinite(value.as_number()));
            if (!scalar)
                source_.fail(
                    value.place, joined_key(key, option.name),
                    fmt::format("found {}; allowed: a text, a finite number, true or false", value.shown()));
        }
    }

    void refuse_unless(bool allowed, const Given& given, const std::string& key) const {
        if (!allowed)
            source_.fail(given.value().place, key,
                         fmt::format("found {}; allowed: {}", given.value().shown(),
                                     given.row->allowed(*given.spelling)));
    }
};

}  // namespace

void check_name(const SceneSource& source, const Given& given, const std::string& key,
                const AllowedNames& allowed) {
    const std::string text(trimmed(given.value().text.substr(0, given.value().text.find(allowed.until))));
    if (std::ranges::find(allowed.names, text) != allowed.names.end()) return;
    source.fail(given.value().place, key,
                fmt::format("found {}; allowed: {}{}{}{}", given.value().shown(), allowed.before,
                            listed(allowed.names, ", ", in_quotes), allowed.after,
                            choice_hint(key, text, allowed.names)));
}

void check_keys(const SceneSource& source) {
    KeyCheck(source, true).run();
}

void check_given_keys(const SceneSource& source) {
    KeyCheck(source, false).run();
}

}  // namespace camopt::input

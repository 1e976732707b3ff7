// SPDX-License-Identifier: MIT
#include "input/row_reader.hpp"

#include "input/key_file.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

OptionValue option_value(const Node& node) {
    if (node.kind == NodeKind::boolean) return node.boolean;
    if (node.kind == NodeKind::integer) return node.integer;
    if (node.kind == NodeKind::number) return node.number;
    return node.text;
}

bool is_pairs(KeyType type) {
    return type == KeyType::points || type == KeyType::number_or_points;
}

/// A value of a checked file as its row stores it.
class ValueReader {
 public:
    ValueReader(const KeyOwner& owner, const GivenAt& key)
        : owner_(owner), key_(key), row_(*key.given.row), node_(key.given.value()) {}

    [[nodiscard]] KeyValue read() const {
        switch (node_.kind) {
            case NodeKind::text:
                return node_.text;
            case NodeKind::boolean:
                return node_.boolean;
            case NodeKind::integer:
                if (row_.type == KeyType::integer) return node_.integer;
                return stored(node_);
            case NodeKind::number:
                return stored(node_);
            case NodeKind::array:
                return list();
            case NodeKind::table:
                return table();
            case NodeKind::date_or_time:
                break;
        }
        return {};
    }

 private:
    const KeyOwner& owner_;
    const GivenAt& key_;
    const KeyRow& row_;
    const Node& node_;

    [[nodiscard]] double stored(const Node& number) const {
        const double written = number.as_number();
        return row_.place->stored ? row_.place->stored(owner_, key_.at, written)
                                  : written * key_.given.spelling->factor;
    }
    [[nodiscard]] KeyValue list() const {
        if (row_.type == KeyType::tables) return static_cast<long long>(node_.items.size());
        if (row_.type == KeyType::texts) {
            std::vector<std::string> texts;
            for (const Node& item : node_.items) texts.push_back(item.text);
            return texts;
        }
        if (is_pairs(row_.type)) {
            KeyPairs pairs;
            for (const Node& pair : node_.items)
                pairs.push_back({pair.items[0].as_number() * row_.place->first_unit, stored(pair.items[1])});
            return pairs;
        }
        std::vector<double> numbers;
        for (const Node& item : node_.items) numbers.push_back(stored(item));
        return numbers;
    }
    [[nodiscard]] KeyValue table() const {
        if (row_.type == KeyType::options) {
            KeyOptions options;
            for (const Member& option : node_.members)
                options.emplace(option.name, option_value(option.value));
            return options;
        }
        if (row_.type == KeyType::table || row_.type == KeyType::text_or_table) return {};
        KeyBounds bounds;
        if (const Member* const least = node_.find("min")) bounds.least = stored(least->value);
        if (const Member* const most = node_.find("max")) bounds.most = stored(most->value);
        return bounds;
    }
};

class RowReader {
 public:
    /// `scaled`: only keys that are stored by others, after this check; null: only the rest.
    RowReader(const SceneSource& source, const KeyOwner& owner, WrittenUnits* written, const KeyVisit* scaled)
        : source_(source), owner_(owner), written_(written), scaled_(scaled) {}

    /// `table`: the name in the key table; `path`: as the user would write it.
    void read(const Node& node, const std::string& table, const std::string& path, const KeyAt& at,
              std::size_t depth = 0) const {
        std::vector<Given> all;
        for (const Member& member : node.members)
            if (const KeyMatch match = match_key(table, member.name, source_.rows); match.row != nullptr)
                all.push_back({&member, match.row, match.spelling});
        // In the order of the manual: a type before what it decides.
        std::ranges::sort(all, {}, &Given::row);
        for (const Given& given : all) {
            GivenAt key{given, at, joined_key(path, given.member->name)};
            key.at.spelling = given.spelling;
            key.at.choices = given.row->choices.size();
            if (written_ != nullptr) (*written_)[joined_key(path, given.row->name)] = *given.spelling;
            read_one(key);
            read_inner(key, joined_key(table, given.row->name), depth);
        }
    }

 private:
    const SceneSource& source_;
    const KeyOwner& owner_;
    WrittenUnits* written_;
    const KeyVisit* scaled_;

    void read_one(const GivenAt& key) const {
        const KeyPlace& place = *key.given.row->place;
        if (!place.assign || static_cast<bool>(place.stored) != (scaled_ != nullptr)) return;
        if (scaled_ != nullptr && *scaled_) (*scaled_)(key);
        try {
            place.assign(owner_, ValueReader(owner_, key).read(), key.at);
        } catch (const RefusedValue& refused) {
            const Node& value = key.given.value();
            const bool is_item = refused.item() < value.items.size();
            source_.fail(is_item ? value.items[refused.item()].place : value.place, key.key, refused.what());
        }
    }
    void read_inner(const GivenAt& key, const std::string& table, std::size_t depth) const {
        const Node& value = key.given.value();
        const KeyType type = key.given.row->type;
        if (value.kind == NodeKind::table && (type == KeyType::table || type == KeyType::text_or_table))
            return read(value, table, key.key, key.at, depth);
        if (type != KeyType::tables) return;
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            KeyAt at = key.at;
            at.entry[depth] = i;
            read(value.items[i], table, entry_key(key.key, i), at, depth + 1);
        }
    }
};

}  // namespace

void read_rows(const SceneSource& source, const KeyOwner& owner, WrittenUnits* written) {
    RowReader(source, owner, written, nullptr).read(source.root, "", "", {});
}

void read_key_file(std::string_view toml, std::string_view name, KeyRows rows, const KeyOwner& owner) {
    const SceneSource source{.name = std::string(name), .root = parse_document(toml, name), .rows = rows};
    check_keys(source);
    read_rows(source, owner);
}

void read_keys(std::span<const KeySetting> settings, KeyRows rows, const KeyOwner& owner) {
    SceneSource source{.name = {}, .root = {}, .rows = rows};
    for (const auto& [key, value] : settings) {
        Place place;
        place.setting = 1;  // messages begin with the key
        const KeyMatch match = match_key("", key, rows);
        const bool is_text = match.row != nullptr && match.row->type == KeyType::text;
        Node node = is_text ? text_node(value) : parse_override_value(value, place);
        node.place = place;
        source.root.members.push_back({key, place, std::move(node)});
    }
    check_given_keys(source);
    read_rows(source, owner);
}

void read_scaled_rows(const SceneSource& source, std::string_view table, const KeyOwner& owner,
                      const KeyVisit& check) {
    if (const Node* const node = source.table(table))
        RowReader(source, owner, nullptr, &check).read(*node, std::string(table), std::string(table), {});
}

}  // namespace camopt::input

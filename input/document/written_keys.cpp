// SPDX-License-Identifier: MIT
#include "input/document/written_keys.hpp"

#include "input/document/document.hpp"
#include "input/document/scene_source.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace camopt::input {
namespace {

class KeyCollector {
 public:
    /// table: the name in the key table; path: as the user would write it, with indices.
    void add_table(const Node& node, std::string_view table, const std::string& path) {
        for (const Member& member : node.members) {
            const std::string name = joined_key(table, member.name), key = joined_key(path, member.name);
            const KeyMatch match = match_key(table, member.name);
            if (holds_keys(match, member.value))
                add_keys(member.value, name, key);
            else
                all_.push_back({key, value_text(member.value),
                                match.spelling ? std::string(match.spelling->unit) : std::string{},
                                match.row ? std::string(match.row->meaning) : std::string{}});
        }
    }
    [[nodiscard]] std::vector<WrittenKey> take() { return std::move(all_); }

 private:
    std::vector<WrittenKey> all_;

    /// Not a value that happens to be a table, as a range is.
    static bool holds_keys(const KeyMatch& match, const Node& value) {
        if (!match.row || (value.kind != NodeKind::table && value.kind != NodeKind::array)) return false;
        switch (match.row->type) {
            case KeyType::table:
            case KeyType::tables:
            case KeyType::options:
                return true;
            case KeyType::text_or_table:
                return value.kind == NodeKind::table;
            default:
                return false;
        }
    }

    void add_keys(const Node& value, std::string_view table, const std::string& path) {
        if (value.kind == NodeKind::table) return add_table(value, table, path);
        for (std::size_t i = 0; i < value.items.size(); ++i)
            add_table(value.items[i], table, fmt::format("{}[{}]", path, i));
    }
};

}  // namespace

std::vector<WrittenKey> keys_written_in(std::string_view toml, std::string_view source_name) {
    KeyCollector collector;
    collector.add_table(parse_document(toml, source_name), "", "");
    return collector.take();
}

}  // namespace camopt::input

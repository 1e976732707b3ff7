// SPDX-License-Identifier: MIT
// Units of the studio: which of them a field takes, and a scene rewritten in the units that its user reads.
#include "apps/studio/studio_controls.hpp"
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "input/document/document.hpp"
#include "input/keys/scene_keys.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

using input::Member;
using input::Node;
using input::NodeKind;

/// The shortest number this close to it: what was round comes back as it was.
double converted(double value, double factor) {
    constexpr double close = 1e-9;  // relative; twice the rounding to the most digits
    constexpr int most_digits = 10;
    const double exact = value * factor;
    for (int digits = 1; digits <= most_digits; ++digits)
        if (const auto rounded = number_in(fmt::format("{:.{}g}", exact, digits));
            rounded && std::abs(*rounded - exact) <= close * std::abs(exact))
            return *rounded;
    return exact;
}

void scale(Node& value, double factor) {
    if (value.is_number()) {
        value.number = converted(value.as_number(), factor);
        value.kind = NodeKind::number;
    }
    for (Node& item : value.items) scale(item, factor);
    for (Member& end : value.members) scale(end.value, factor);
}

/// "/deg^2" of "mm/deg^2".
std::string_view divisor_of(std::string_view unit) {
    return unit.substr(std::min(unit.find('/'), unit.size()));
}

/// The same quantity in the other system of units, by the same angle or time where it can be; null: it has
/// none, or is written so.
const Spelling* in_system(const KeyRow& row, const Spelling& written, UnitSystem wanted) {
    if (written.system == UnitSystem::both || written.system == wanted) return nullptr;
    const Spelling* found = nullptr;
    for (const Spelling& other : row.spellings) {
        if (other.quantity != written.quantity || other.system != wanted) continue;
        if (divisor_of(other.unit) == divisor_of(written.unit)) return &other;
        if (found == nullptr) found = &other;
    }
    return found;
}

/// Pairs of numbers ([[angle, force], …]) have two units: they stay.
bool has_one_unit(const Node& value) {
    return std::ranges::none_of(value.items, [](const Node& item) { return item.kind == NodeKind::array; });
}

bool rewrite(Node& table, const std::string& path, UnitSystem wanted) {
    bool changed = false;
    for (Member& member : table.members) {
        const auto [row, spelling] = input::match_key(path, member.name);
        if (row == nullptr || row->type == KeyType::options) continue;
        const Spelling* const other = in_system(*row, *spelling, wanted);
        if (other != nullptr && has_one_unit(member.value)) {
            scale(member.value, spelling->factor / other->factor);
            member.name = row->key(*other);
            changed = true;
        } else if (row->type == KeyType::table || row->type == KeyType::tables ||
                   row->type == KeyType::text_or_table) {
            const std::string inner = (path.empty() ? "" : path + ".") + std::string(row->name);
            if (member.value.kind == NodeKind::table) changed |= rewrite(member.value, inner, wanted);
            for (Node& item : member.value.items)
                if (item.kind == NodeKind::table) changed |= rewrite(item, inner, wanted);
        }
    }
    return changed;
}

/// "motion.segments[1].via": the list, made where the scene has none.
Node& list_of(Node& root, std::string_view path) {
    Node* node = &root;
    while (!path.empty()) {
        const std::string_view part = path.substr(0, path.find('.'));
        path.remove_prefix(std::min(part.size() + 1, path.size()));
        const std::size_t bracket = std::min(part.find('['), part.size());
        const std::string name(part.substr(0, bracket));
        if (node->find(name) == nullptr) {
            node->members.push_back({name, {}, {}});
            node->members.back().value.kind = path.empty() ? NodeKind::array : NodeKind::table;
        }
        node = &node->find(name)->value;
        if (bracket == part.size()) continue;
        const auto index = integer_in(part.substr(bracket + 1, part.size() - bracket - 2));
        if (!index || *index < 0 || static_cast<std::size_t>(*index) >= node->items.size())
            throw InputError(fmt::format("{}: no such entry of the scene", part));
        node = &node->items[static_cast<std::size_t>(*index)];
    }
    return *node;
}

}  // namespace

std::vector<UnitChoice> units_of_field(const KeyRow& row, const Spelling& written) {
    std::vector<UnitChoice> choices;
    for (const Spelling& other : row.spellings)
        if (!written.unit.empty() && !other.unit.empty() && other.quantity == written.quantity)
            choices.push_back({std::string(other.unit), as_written(other.factor / written.factor)});
    return choices;
}

std::string scene_in_units(const std::string& text, LengthUnit unit) {
    Node root = input::parse_document(text, "scene");
    const UnitSystem wanted = unit == LengthUnit::inch ? UnitSystem::imperial : UnitSystem::metric;
    return rewrite(root, "", wanted) ? input::document_text(root) : text;
}

std::string scene_with_entry(const std::string& text, const std::string& path, const std::string& entry) {
    Node root = input::parse_document(text, "scene");
    const std::size_t bracket = std::min(path.rfind('['), path.size());
    const auto index =
        path.ends_with(']') ? integer_in(path.substr(bracket + 1, path.size() - bracket - 2)) : std::nullopt;
    if (!index)
        throw InputError(
            fmt::format("{}: found no place in a list; allowed: for example motion.via[0]", path));
    Node& list = list_of(root, std::string_view(path).substr(0, bracket));
    if (list.kind != NodeKind::array || *index < 0 || static_cast<std::size_t>(*index) > list.items.size())
        throw InputError(fmt::format("{}: found {} entries; allowed: a place from 0 to {}", path,
                                     list.items.size(), list.items.size()));
    list.items.insert(list.items.begin() + *index, input::parse_override_value(entry, {}));
    return input::document_text(root);
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
#include "input/scene_text.hpp"

#include "core/text/parsing.hpp"
#include "input/document/scene_source.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

using Forward = std::function<double(double written)>;

constexpr int neighbours = 4;  // that two roundings reach

/// The number of fewest digits that is stored so; none: no number is.
std::optional<double> number_for(double stored, const Forward& forward) {
    if (stored == 0.0) return 0.0;
    const double guess = stored / forward(1.0);
    constexpr std::array digits = {15, 16, 17};
    for (const int count : digits) {
        const double number = number_in(fmt::format("{:.{}g}", guess, count)).value_or(guess);
        if (forward(number) == stored) return number;
    }
    double below = guess, above = guess;
    for (int i = 0; i < neighbours; ++i) {
        below = std::nextafter(below, -std::numeric_limits<double>::infinity());
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
        for (const double number : {below, above})
            if (forward(number) == stored) return number;
    }
    return std::nullopt;
}

/// Of what is pushed straight, or swings; other quantities are neither.
bool is_straight(const Spelling& spelling) {
    const Quantity& of = spelling.quantity;
    return of.mass != 0 ? of.length == 0 : of.force != 0 ? of.length <= 0 : of.length > 0;
}
bool is_swinging(const Spelling& spelling) {
    const Quantity& of = spelling.quantity;
    return of.mass != 0 ? of.length == 2 : of.force != 0 ? of.length > 0 : of.length == 0 && of.angle > 0;
}

Node table_node(std::vector<Member> members) {
    Node node;
    node.members = std::move(members);
    return node;
}

Node array_node(std::vector<Node> items) {
    Node node;
    node.kind = NodeKind::array;
    node.items = std::move(items);
    return node;
}

Member member(std::string_view name, Node value) {
    return {std::string(name), {}, std::move(value)};
}

/// A value in one spelling; `exact`: it is read as the same value.
struct Written {
    const Spelling* spelling = nullptr;
    Node value = {};
    bool exact = true;

    [[nodiscard]] std::size_t length() const { return value_text(value).size(); }
};

/// A value as a node. KeyValue's alternatives.
class NodeWriter {
 public:
    NodeWriter(const KeyPlace& place, Forward forward, bool& exact)
        : place_(place), forward_(std::move(forward)), exact_(exact) {}

    Node operator()(std::monostate) const { return {}; }
    Node operator()(bool value) const { return boolean_node(value); }
    Node operator()(long long value) const { return integer_node(value); }
    Node operator()(double stored) const { return number(stored, forward_); }
    Node operator()(const std::string& text) const { return text_node(text); }
    Node operator()(const std::vector<double>& numbers) const {
        std::vector<Node> items;
        items.reserve(numbers.size());
        for (const double stored : numbers) items.push_back((*this)(stored));
        return array_node(std::move(items));
    }
    Node operator()(const std::vector<std::string>& texts) const {
        std::vector<Node> items;
        items.reserve(texts.size());
        for (const std::string& text : texts) items.push_back(text_node(text));
        return array_node(std::move(items));
    }
    Node operator()(const KeyBounds& bounds) const {
        std::vector<Member> members;
        if (bounds.least) members.push_back(member("min", (*this)(*bounds.least)));
        if (bounds.most) members.push_back(member("max", (*this)(*bounds.most)));
        return table_node(std::move(members));
    }
    Node operator()(const KeyPairs& pairs) const {
        const auto first = [this](double written) { return written * place_.first_unit; };
        std::vector<Node> items;
        for (const auto& [where, value] : pairs)
            items.push_back(array_node({number(where, first), (*this)(value)}));
        return array_node(std::move(items));
    }
    Node operator()(const KeyOptions& options) const {
        std::vector<Member> members;
        for (const auto& [name, value] : options)
            members.push_back(member(name, std::visit([](const auto& one) { return plain(one); }, value)));
        return table_node(std::move(members));
    }

 private:
    const KeyPlace& place_;
    Forward forward_;
    bool& exact_;

    [[nodiscard]] Node number(double stored, const Forward& forward) const {
        const std::optional<double> written = number_for(stored, forward);
        exact_ = exact_ && written;
        return number_node(written.value_or(stored / forward(1.0)));
    }
    /// Of an option: a number stays one, 1.0.
    [[nodiscard]] static Node plain(double value) {
        Node node;
        node.kind = NodeKind::number;
        node.number = value;
        return node;
    }
    [[nodiscard]] static Node plain(bool value) { return boolean_node(value); }
    [[nodiscard]] static Node plain(long long value) { return integer_node(value); }
    [[nodiscard]] static Node plain(const std::string& value) { return text_node(value); }
};

/// Every optional part, and one entry of each array of tables: what keys are compared with.
Scene scene_of_defaults(bool valve) {
    Scene scene;
    scene.spline.by_stroke = true;
    if (valve) scene.motion.valve.emplace();
    for (const KeyRow& row : scene_keys()) {
        if (!row.place->assign || row.place->value(scene, {}).value_or(0LL) != KeyValue(0LL)) continue;
        if (row.type == KeyType::tables) row.place->assign(scene, 1LL, {});
        if (row.type == KeyType::table || row.type == KeyType::text_or_table)
            row.place->assign(scene, {}, {});
    }
    return scene;
}

class SceneWriter {
 public:
    explicit SceneWriter(const Scene& scene)
        : scene_(scene),
          defaults_(scene_of_defaults(scene.motion.valve.has_value())),
          type_(scene.motion.valve ? "valve" : name_of(scene.motion.type)) {}

    [[nodiscard]] Node write() const { return table("", "", {}, 0); }

 private:
    const Scene& scene_;
    Scene defaults_;
    const Scene absent_ = {};
    std::string_view type_;  ///< of the motion

    /// `name`: in the key table; `path`: with indices, as in Scene::written.
    [[nodiscard]] Node table(std::string_view name, const std::string& path, const KeyAt& at,
                             std::size_t depth) const {
        std::vector<Member> members;
        for (const KeyRow& row : scene_keys()) {
            if (row.table != name || (name == "motion" && !motion_types_of(row.name, type_).empty()))
                continue;
            const std::optional<KeyValue> value = row.place->value(scene_, at);
            if (!value || says_other(row, *value, at)) continue;
            const std::string inner = joined_key(name, row.name), inner_path = joined_key(path, row.name);
            if (row.type == KeyType::tables)
                add_tables(members, row, inner_path, {at, depth, std::get<long long>(*value)});
            else if (*value == KeyValue())
                add_table(members, row, table(inner, inner_path, at, depth));
            else if (is_always(row) || value != row.place->value(defaults_, {}))
                add_value(members, row, inner_path, *value, at);
        }
        return table_node(std::move(members));
    }

    struct Entries {
        KeyAt at;
        std::size_t depth = 0;
        long long count = 0;
    };
    void add_tables(std::vector<Member>& members, const KeyRow& row, const std::string& path,
                    Entries entries) const {
        std::vector<Node> items;
        for (long long i = 0; i < entries.count; ++i) {
            entries.at.entry[entries.depth] = static_cast<std::size_t>(i);
            items.push_back(
                table(joined_key(row.table, row.name), entry_key(path, i), entries.at, entries.depth + 1));
        }
        if (!items.empty()) members.push_back(member(row.name, array_node(std::move(items))));
    }
    /// An empty one says something where it is absent otherwise.
    void add_table(std::vector<Member>& members, const KeyRow& row, Node inner) const {
        if (!inner.members.empty() || row.place->value(absent_, {}) != KeyValue())
            members.push_back(member(row.name, std::move(inner)));
    }
    void add_value(std::vector<Member>& members, const KeyRow& row, const std::string& path,
                   const KeyValue& value, const KeyAt& at) const {
        Written best;
        for (const Spelling* const spelling : spellings_for(row, path, at)) {
            Written next = written(row, value, at, *spelling);
            const bool is_better = best.spelling == nullptr || (next.exact && !best.exact) ||
                                   (next.exact == best.exact && next.length() < best.length());
            if (is_better) best = std::move(next);
            if (best.exact && is_known(*best.spelling, row, path, at)) break;
        }
        members.push_back(member(row.key(*best.spelling), std::move(best.value)));
    }

    [[nodiscard]] Written written(const KeyRow& row, const KeyValue& value, KeyAt at,
                                  const Spelling& spelling) const {
        at.spelling = &spelling;
        Written all{&spelling};
        const Forward forward = [&](double number) {
            return row.place->stored ? row.place->stored(scene_, at, number) : number * spelling.factor;
        };
        all.value = std::visit(NodeWriter(*row.place, forward, all.exact), value);
        return all;
    }

    static bool is_always(const KeyRow& row) {
        return row.required() || row.default_text.starts_with("needed") ||
               (row.table == "motion" && row.name == "lift");
    }

    /// Another key says the same in a unit that fits the lift.
    [[nodiscard]] bool says_other(const KeyRow& row, const KeyValue& value, const KeyAt& at) const {
        if (std::ranges::any_of(row.spellings, [&](const Spelling& one) { return fits(one); })) return false;
        return std::ranges::any_of(scene_keys(), [&](const KeyRow& other) {
            return other.table == row.table &&
                   (other.instead_of == row.name || row.instead_of == other.name) &&
                   other.place->value(scene_, at) == value;
        });
    }
    [[nodiscard]] bool fits(const Spelling& spelling) const {
        return scene_.motion.lift_is_angle ? is_swinging(spelling) : is_straight(spelling);
    }

    /// As the value or the scene remembers it; null: neither does.
    [[nodiscard]] const Spelling* known_spelling(const KeyRow& row, const std::string& path,
                                                 const KeyAt& at) const {
        const auto in_scene = scene_.written.find(path);
        const bool remembers = static_cast<bool>(row.place->unit);
        const std::string unit = remembers ? row.place->unit(scene_, at) : std::string();
        for (const Spelling& spelling : row.spellings)
            if (remembers ? spelling.unit == unit
                          : in_scene != scene_.written.end() && spelling.suffix == in_scene->second.suffix)
                return &spelling;
        return nullptr;
    }
    [[nodiscard]] bool is_known(const Spelling& spelling, const KeyRow& row, const std::string& path,
                                const KeyAt& at) const {
        return known_spelling(row, path, at) == &spelling;
    }

    /// That of the value; else that of the scene, that of the manual in the scene's lengths, SI.
    [[nodiscard]] std::vector<const Spelling*> spellings_for(const KeyRow& row, const std::string& path,
                                                             const KeyAt& at) const {
        std::vector<const Spelling*> all;
        const auto add = [&](const Spelling& spelling) {
            if (std::ranges::find(all, &spelling) == all.end()) all.push_back(&spelling);
        };
        if (const Spelling* const known = known_spelling(row, path, at)) add(*known);
        if (row.place->unit && !all.empty()) return all;
        const bool both = std::ranges::any_of(row.spellings, is_straight) &&
                          std::ranges::any_of(row.spellings, is_swinging);
        const UnitSystem foreign =
            scene_.length_unit == LengthUnit::inch ? UnitSystem::metric : UnitSystem::imperial;
        bool first = true;
        for (const Spelling& spelling : row.spellings) {
            if (both && !fits(spelling)) continue;
            if (first && spelling.system != foreign) {
                add(spelling);
                first = false;
            }
            if (spelling.factor == 1.0 && spelling.quantity.crank == 0) add(spelling);
        }
        if (all.empty()) add(row.spellings.front());
        return all;
    }
};

[[noreturn]] void refuse(std::string_view member, std::string_view found, std::string_view allowed) {
    throw InputError(fmt::format("{}: found {}; allowed in a scene file: {}", member, found, allowed));
}

/// Both in one unit, or one number.
void check_sides(const LimitSpec& limits) {
    for (const PeakLimitRow& both : peak_limit_rows()) {
        if (both.side != 0) continue;
        std::vector<std::string> units;
        for (const PeakLimitRow& row : peak_limit_rows())
            if (const auto& limit = row.in(limits); limit && std::string_view(row.key_name) == both.key_name)
                units.push_back(limit->unit);
        if (units.size() > 1 && (both.in(limits) || units[0] != units[1]))
            refuse(fmt::format("limits.{}", both.name()), "several limits of this derivative",
                   "one of both sides, or one of each side in the same unit");
    }
}

void check_writable(const Scene& scene) {
    if (!scene.own_terms.empty() || !scene.own_limits.empty())
        refuse("own_terms", "a term or a limit of the program", "those of camopt");
    const SplineSpec& spline = scene.spline;
    if (spline.by_stroke && spline.breakpoints.empty() && spline.segments != SplineSpec().segments)
        refuse("spline.by_stroke", fmt::format("{} segments", spline.segments),
               "12 by stroke, other numbers over the whole motion, or breakpoints");
    if (scene.cam && !find_row("cam", "type")->place->value(scene, {}))
        refuse("cam.type", fmt::format("\"{}\"", scene.cam->type), "a kind that this program knows");
    check_sides(scene.limits);
}

/// A program that has changed them writes them as segments.
bool are_of_lobe(const MotionSpec& motion) {
    MotionSpec lobe = motion;
    make_valve_lobe(lobe, *motion.valve);
    for (std::size_t i = 0; i < std::min(lobe.segments.size(), motion.segments.size()); ++i)
        for (std::size_t j = 0; j < std::min(lobe.segments[i].via.size(), motion.segments[i].via.size()); ++j)
            lobe.segments[i].via[j].units = motion.segments[i].via[j].units;
    return lobe == motion;
}

MeasuredRows rows_of(const MeasuredMotion& measured) {
    MeasuredRows rows;
    rows.theta = measured.angle;
    rows.s = measured.displacement;
    rows.name = measured.name;
    if (measured.start) rows.use = "start";
    return rows;
}

Node scene_node(Scene all) {
    if (all.motion.valve && !are_of_lobe(all.motion)) all.motion.valve.reset();
    if (all.measured && !all.measured_rows) all.measured_rows = rows_of(*all.measured);
    return SceneWriter(all).write();
}

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
            add_table(value.items[i], table, entry_key(path, i));
    }
};

std::vector<WrittenKey> keys_in(const Node& root) {
    KeyCollector collector;
    collector.add_table(root, "", "");
    return collector.take();
}

}  // namespace

std::string scene_text(const Scene& scene) {
    Scene all = with_written_limits(scene);
    check_writable(all);
    return document_text(scene_node(std::move(all)), TableEntries::on_lines);
}

std::vector<WrittenKey> keys_written_in(std::string_view toml, std::string_view source_name) {
    return keys_in(parse_document(toml, source_name));
}

std::vector<WrittenKey> keys_of(const Scene& scene) {
    return keys_in(scene_node(with_written_limits(scene)));
}

}  // namespace camopt::input

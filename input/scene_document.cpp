// SPDX-License-Identifier: MIT
#include "input/scene_document.hpp"

#include "core/text/printable.hpp"
#include "input/scene_parts.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

/// Makes a node of each kind of value.
struct NodeOf {
    std::string_view key;
    const Place& place;

    Node operator()(bool value) const { return boolean_node(value); }
    Node operator()(int value) const { return integer_node(value); }
    Node operator()(double value) const { return number_node(value); }
    Node operator()(const std::string& value) const { return text_node(value); }
    Node operator()(const std::vector<double>& values) const {
        Node node;
        node.kind = NodeKind::array;
        for (const double value : values) {
            node.items.push_back(number_node(value));
            node.items.back().place = place;
        }
        return node;
    }
    Node operator()(const TomlValue& value) const {
        try {
            return parse_override_value(value.text, place);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", printable(key), error.what()));
        }
    }
};

/// Whether the key table has this key, or the table may have keys of a backend.
bool is_known(std::string_view key) {
    std::string table;
    while (true) {
        const std::size_t dot = key.find('.');
        const std::string_view part = key.substr(0, std::min(dot, key.find('[')));
        const KeyRow* const row = match_key(table, part).row;
        if (!row) return false;
        if (dot == std::string_view::npos || row->type == KeyType::options) return true;
        table = joined_key(table, part);
        key.remove_prefix(dot + 1);
    }
}

}  // namespace

struct SceneDocument::State {
    SceneSource source;
    KnownNames known;
    std::string given;  ///< the text it was made from
    int settings = 0;   ///< number of settings made, retained or not

    [[nodiscard]] Place next_place() {
        return {.line = 1, .column = 1, .override_text = {}, .setting = ++settings};
    }
};

SceneDocument::SceneDocument(std::string_view toml, std::string_view name, KnownNames known)
    : state_(std::make_unique<State>(State{{.name = std::string(name), .root = parse_document(toml, name)},
                                           std::move(known),
                                           std::string(toml)})) {}
SceneDocument::SceneDocument(const SceneDocument& other) : state_(std::make_unique<State>(*other.state_)) {}
SceneDocument& SceneDocument::operator=(const SceneDocument& other) {
    return *this = SceneDocument(other);
}
SceneDocument::SceneDocument(SceneDocument&&) noexcept = default;
SceneDocument& SceneDocument::operator=(SceneDocument&&) noexcept = default;
SceneDocument::~SceneDocument() = default;

const std::string& SceneDocument::name() const {
    return state_->source.name;
}

void SceneDocument::set(std::string_view key, const SceneValue& value) {
    State changed = *state_;
    const Place place = changed.next_place();
    Setting setting{std::string(key), std::visit(NodeOf{key, place}, value)};
    setting.value.place = place;
    apply_setting(changed.source.root, setting);
    check_given_keys(changed.source);
    adopt(std::move(changed));
}

void SceneDocument::unset(std::string_view key) {
    State changed = *state_;
    const Place place = changed.next_place();
    if (remove_setting(changed.source.root, key, place)) return adopt(std::move(changed));
    if (is_known(key)) return;
    Setting unknown{std::string(key), {}};
    unknown.value.place = place;
    apply_setting(changed.source.root, unknown);
    check_given_keys(changed.source);  // throws, listing the keys
}

/// A fault of this setting in a reading of the whole scene is reported; other faults are left to the user of
/// the scene.
void SceneDocument::adopt(State&& changed) {
    try {
        (void)read_document(changed.source, changed.known);
    } catch (const PlacedError& error) {
        if (error.place().setting == changed.settings) throw;
    } catch (const InputError&) {  // NOLINT(bugprone-empty-catch): concerns the scene as a whole
    }
    changed.given.clear();
    *state_ = std::move(changed);
}

Scene SceneDocument::scene(std::span<const std::string> settings) const {
    if (settings.empty()) return read_document(state_->source, state_->known);
    SceneSource source = state_->source;
    for (const std::string& text : settings)
        apply_setting(source.root,
                      parsed_setting(text, {.line = 1, .column = 1, .override_text = {}, .setting = -1}));
    return read_document(source, state_->known);
}

std::string SceneDocument::text() const {
    const std::string& given = state_->given;
    return given.empty() || printable_lines(given) != given ? document_text(state_->source.root) : given;
}

}  // namespace camopt::input

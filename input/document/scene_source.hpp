// SPDX-License-Identifier: MIT
// A parsed scene file through the key table: quantities by name in any unit, errors with their location.
// Internal to input/.
#pragma once

#include "input/document/document.hpp"
#include "input/keys/scene_keys.hpp"
#include "scene/cam_spec.hpp"
#include "scene/part_names.hpp"

namespace camopt::input {

/// A quantity as it was written.
struct Given {
    const Member* member = nullptr;
    const KeyRow* row = nullptr;
    const Spelling* spelling = nullptr;

    [[nodiscard]] const Node& value() const { return member->value; }
    /// SI value of a number.
    [[nodiscard]] double number() const { return member->value.as_number() * spelling->factor; }
    /// A number or a range of one, in SI, with its key and unit as written.
    [[nodiscard]] Dimension dimension() const;
};

class SceneSource {
 public:
    std::string name;  ///< of the file
    Node root;
    KeyRows rows = scene_keys();  ///< that its keys have

    /// The value at a dotted path of tables; nullptr if it is missing or not a table.
    [[nodiscard]] const Node* table(std::string_view path) const;

    /// A quantity of a table, in any unit.
    [[nodiscard]] std::optional<Given> find(std::string_view table_path, std::string_view quantity) const;
    [[nodiscard]] std::optional<Given> find_in(const Node& table, std::string_view table_path,
                                               std::string_view quantity) const;

    /// Throws InputError "LOCATION: key: what".
    [[noreturn]] void fail(const Place& place, std::string_view key, std::string_view what) const {
        throw PlacedError(place, error_prefix(name, place, key) + std::string(what));
    }

    /// Throws for a member of what is read: its location and its key as written, or those of the nearest
    /// table.
    [[noreturn]] void fail_member(std::string_view member, std::string_view what) const;
};

// Validates a parsed scene file against the key table, in the order of the file: unknown keys, wrong types,
// values out of range, two spellings of a quantity, missing keys. Errors: InputError, UnavailableError.
// Internal to input/.

void check_keys(const SceneSource& source);

/// The same without missing keys: for a scene under construction.
void check_given_keys(const SceneSource& source);

/// Names, and the words around their list in an error message.
struct AllowedNames {
    const std::vector<std::string>& names;
    std::string_view before = {}, after = {};
    char until = '\0';  ///< the name ends before it
};

/// Throws if the text is not one of the names.
void check_name(const SceneSource& source, const Given& given, const std::string& key,
                const AllowedNames& allowed);

}  // namespace camopt::input

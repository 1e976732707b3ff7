// SPDX-License-Identifier: MIT
// A TOML document as a plain tree with the location of every key and value, in the order of the file. Errors:
// InputError "FILE:LINE:COLUMN: …" for text that is not TOML. Internal to input/.
#pragma once

#include "core/errors.hpp"
#include "input/keys/scene_keys.hpp"

namespace camopt::input {

/// Where something was written: a line and column of the file, an override ("--set KEY=VALUE"), or a program
/// (input/scene_document.hpp).
struct Place {
    int line = 1;
    int column = 1;
    std::string override_text;  ///< empty: not by an override
    int setting = 0;            ///< 0: not by a program; else which of its settings, < 0: implied by one
};

/// A fault at a location, with the location as prefix.
class PlacedError : public InputError {
 public:
    PlacedError(const Place& where, const std::string& message) : InputError(message), place_(where) {}
    [[nodiscard]] const Place& place() const { return place_; }

 private:
    Place place_;
};

enum class NodeKind { boolean, integer, number, text, array, table, date_or_time };

struct Member;

/// One TOML value. Only the field of its kind is set.
struct Node {
    NodeKind kind = NodeKind::table;
    Place place;
    bool boolean = false;
    long long integer = 0;
    double number = 0.0;
    std::string text;
    std::vector<Node> items;
    std::vector<Member> members;

    [[nodiscard]] const Member* find(std::string_view name) const;
    [[nodiscard]] Member* find(std::string_view name);
    [[nodiscard]] bool is_number() const { return kind == NodeKind::integer || kind == NodeKind::number; }
    /// The value of an integer or a number.
    [[nodiscard]] double as_number() const;
    /// As an error message shows it: 4, 4.0, "text", a table.
    [[nodiscard]] std::string shown() const;
};

struct Member {
    std::string name;
    Place place;  ///< of the key
    Node value;
};

[[nodiscard]] Node boolean_node(bool value);
[[nodiscard]] Node integer_node(long long value);
/// An integer where it is one.
[[nodiscard]] Node number_node(double value);
[[nodiscard]] Node text_node(std::string_view text);

/// `source_name` begins every message.
[[nodiscard]] Node parse_document(std::string_view toml, std::string_view source_name);

/// The value after KEY= of an override: TOML, or a bare word, which is a string. Every location in it is the
/// override.
[[nodiscard]] Node parse_override_value(std::string_view value, const Place& place);

/// "scene.toml:7:12: spline.degree: ", "--set spline.degree=4: spline.degree: ", or for a program
/// "spline.degree: ". An empty key is omitted.
[[nodiscard]] std::string error_prefix(std::string_view source_name, const Place& place,
                                       std::string_view key);

// Writes a document as TOML: parse_document(document_text(root)) is the same tree except for locations.
// Comments and layout are lost. Internal to input/.

/// The entries of an array of tables: after one another, or each on a line.
enum class TableEntries { in_one_line, on_lines };

/// The tables of the root as sections, each key on one line. Numbers with the fewest digits that read back as
/// the same double. Throws InputError for a date or time, which no scene has.
[[nodiscard]] std::string document_text(const Node& root, TableEntries entries = TableEntries::in_one_line);

/// One value of it: 30.0, "DRD", [0.0, 0.5], {min = 20, max = 60}.
[[nodiscard]] std::string value_text(const Node& node);

// Overrides KEY=VALUE of the command line, applied to the parsed file before it is validated. An override
// replaces the key and all its synonyms (lift_in for lift_mm, segments for breakpoints). KEY may address an
// array entry, counted from 0: motion.segments[1].to. Internal to input/.

/// A key and its new value. The location of the value is that of the setting in error messages.
struct Setting {
    std::string key;
    Node value;
};

/// "KEY=VALUE", VALUE in TOML or a bare word. Throws InputError for other texts.
[[nodiscard]] Setting parsed_setting(std::string_view text, const Place& place);

/// Throws InputError for an invalid key or one that leads into something that is not a table.
void apply_setting(Node& root, const Setting& setting, KeyRows rows = scene_keys());

/// Removes the key and its synonyms. False: it was not there. Throws as apply_setting.
bool remove_setting(Node& root, std::string_view key, const Place& place);

/// Throws InputError "--set KEY=VALUE: …" for text that is not KEY=VALUE or leads into something that is not
/// a table.
void apply_overrides(Node& root, std::span<const std::string> overrides, KeyRows rows = scene_keys());

}  // namespace camopt::input

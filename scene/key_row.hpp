// SPDX-License-Identifier: MIT
// The keys of scene files: ranges of numbers, and one row a key.
#pragma once

#include "core/errors.hpp"
#include "core/text/names.hpp"
#include "core/unit.hpp"

#include <functional>
#include <map>
#include <memory>
#include <typeinfo>
#include <variant>

namespace camopt {

// The interval allowed for a number of a scene, with its words in error messages. Used by the validation of a
// Scene and by the key table of the scene reader.

/// An interval; bounds without a value are infinite. Numbers that are not finite are never inside.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;

    [[nodiscard]] static constexpr Range above(double low) { return {.low = low, .low_included = false}; }
    [[nodiscard]] static constexpr Range at_least(double low) { return {.low = low}; }
    [[nodiscard]] static constexpr Range between(double low, double high) {
        return {.low = low, .high = high};
    }
    [[nodiscard]] static constexpr Range above_up_to(double low, double high) {
        return {.low = low, .high = high, .low_included = false};
    }

    [[nodiscard]] bool contains(double value) const;

    /// The interval after a change of unit: both bounds times `factor` > 0.
    [[nodiscard]] Range scaled(double factor) const;

    /// "", "> 0", ">= 0", "> 0 and <= 360", "from 2 to 4".
    [[nodiscard]] std::string text() const;

    /// "a number > 0", "an integer from 2 to 4", "a finite number".
    [[nodiscard]] std::string number_text() const;
    [[nodiscard]] std::string integer_text() const;
};

namespace ranges {

inline constexpr Range any = {};
inline constexpr Range positive = {.low = 0.0, .low_included = false};
inline constexpr Range not_negative = {.low = 0.0};

}  // namespace ranges

// One key of a scene file: type, units, range, default, meaning. The rows of the scene itself are in input/,
// those of a kind of cam in its leaf (scene/cam_kind.hpp).

enum class KeyType {
    text,              ///< a string; one of `choices` if there are any
    boolean,           ///< true or false
    integer,           ///< an integer; one of `choices` where there are any
    number,            ///< a finite number
    number_or_range,   ///< a finite number, or a table of two: { min = …, max = … }
    number_or_bounds,  ///< a finite number, or a table of one or two: { min = …, max = … }
    bounds,            ///< such a table
    number_or_points,  ///< a finite number, or an array of pairs [place, number], places ascending
    points,            ///< such an array
    numbers,           ///< an array of finite numbers
    texts,             ///< an array of strings
    table,             ///< a table with its own rows
    tables,            ///< an array of such tables
    text_or_table,     ///< a string, or a table with its own rows
    boolean_or_text,   ///< true, false, or one of `choices`
    options,           ///< a table of any keys with text, boolean or number values
};

/// How this version treats a key of the contract.
enum class Availability {
    now,
    needs_cam,       ///< only together with a [cam] table
    needs_forces,    ///< only together with a [forces] table
    needs_dynamics,  ///< only together with a [dynamics] table
    needs_drive,     ///< only together with a [drive] table
};

/// A table { min = …, max = … }.
struct KeyBounds {
    std::optional<double> least = {}, most = {};
    friend bool operator==(const KeyBounds&, const KeyBounds&) = default;
};

using KeyPairs = std::vector<std::array<double, 2>>;
using KeyOptions = std::map<std::string, OptionValue>;

/// A number, an integer (of an array of tables their number), true or false, a text, lists of them, a range;
/// of a table nothing. Numbers are as they are stored: in SI, or as KeyPlace::stored makes them.
using KeyValue = std::variant<std::monostate, bool, long long, double, std::string, std::vector<double>,
                              std::vector<std::string>, KeyBounds, KeyPairs, KeyOptions>;

/// Which key of a scene is meant, and how it is written.
struct KeyAt {
    std::array<std::size_t, 2> entry = {};  ///< of arrays of tables: motion.segments[3].via[1] is {3, 1}
    const Spelling* spelling = nullptr;     ///< null: not known
    std::size_t choices = 0;                ///< of the row, for a text that is one of them
};

/// What the keys of a file are stored in: a Scene, a MachineSpec, a PostProcessor. Converts to a reference to
/// the object that it was made from, and throws std::bad_cast for another type.
class KeyOwner {
 public:
    template <class Object>
    requires(!std::is_same_v<std::remove_const_t<Object>, KeyOwner>)
        KeyOwner(Object& object)  // NOLINT(google-explicit-constructor): rows take the object itself
        : object_(const_cast<void*>(static_cast<const void*>(&object))),  // NOLINT: operator Object& checks
          type_(&typeid(Object)),
          is_const_(std::is_const_v<Object>) {}

    template <class Object>
    operator Object&()
        const {  // NOLINT(google-explicit-constructor): functions of rows take the object itself
        if (*type_ != typeid(Object) || (is_const_ && !std::is_const_v<Object>)) throw std::bad_cast();
        return *static_cast<Object*>(object_);
    }

 private:
    void* object_;
    const std::type_info* type_;
    bool is_const_;
};

/// Thrown by KeyPlace::assign: "found …; allowed: …" of the value, or of one item of an array.
class RefusedValue : public InputError {
 public:
    RefusedValue(std::size_t item, const std::string& found, const std::string& allowed);
    [[nodiscard]] std::size_t item() const { return item_; }

 private:
    std::size_t item_;
};

/// Where the value of a key lives in its owner (scene/key_place.hpp). Empty: other keys say what it means.
struct KeyPlace {
    std::function<void(const KeyOwner&, const KeyValue&, const KeyAt&)> assign = {};
    /// None: absent in this owner.
    std::function<std::optional<KeyValue>(const KeyOwner&, const KeyAt&)> value = {};
    /// What a written number is stored as, in proportion to it; other keys say how, which are read before.
    /// None: its SI value.
    std::function<double(const KeyOwner&, const KeyAt&, double written)> stored = {};
    /// The unit that the value itself remembers; none: Scene::written does.
    std::function<std::string(const KeyOwner&, const KeyAt&)> unit = {};
    int entries = 0;          ///< arrays of tables on the way to it
    double first_unit = 1.0;  ///< SI value of one unit of the first numbers of pairs

    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(value); }
};

/// How a quantity may be written.
struct KeyNames {
    std::string_view name;  ///< without the unit
    std::span<const Spelling> spellings;
};

/// Those in a unit that fits, as a message lists them: "lift_mm, lift_in or lift_m".
[[nodiscard]] std::string keys_text(std::span<const KeyNames> names,
                                    const std::function<bool(const Spelling&)>& fits);

/// The place of a row and of its copies.
class SharedPlace {
 public:
    SharedPlace() = default;
    SharedPlace(KeyPlace place)  // NOLINT(google-explicit-constructor): rows are lists of values
        : place_(std::make_shared<const KeyPlace>(std::move(place))) {}

    [[nodiscard]] const KeyPlace& operator*() const { return place_ ? *place_ : none(); }
    const KeyPlace* operator->() const { return &**this; }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(**this); }

 private:
    std::shared_ptr<const KeyPlace> place_;

    [[nodiscard]] static const KeyPlace& none();
};

struct KeyRow {
    std::string_view table;  ///< "motion", "objective.reference"; empty: top level
    std::string_view name;   ///< without the unit: "lift"
    KeyType type = KeyType::number;
    std::span<const Spelling> spellings;    ///< never empty; exactly one of them may be written
    Range range;                            ///< of numbers and integers, in the unit of the first spelling
    std::vector<std::string_view> choices;  ///< allowed texts (or integers as text)
    std::string_view default_text;          ///< "required" if there is none
    std::string_view meaning;
    SharedPlace place = {};
    Availability availability = Availability::now;
    std::string_view instead_of = {};  ///< another key of the table that excludes it
    /// Only if cam.type is one of these; empty: for any type. Filled from the kinds of cams.
    std::vector<std::string_view> cam_types = {};
    /// In a form, where the name does not say it: "choice among equal curves".
    std::string_view label = {};
    /// Of a number: why it cannot be a range, for who writes one.
    std::string_view no_range = {};

    [[nodiscard]] bool is_for(std::string_view type_of_cam) const {
        return cam_types.empty() || std::ranges::find(cam_types, type_of_cam) != cam_types.end();
    }
    /// The types it is for, each between two `quote`s: "disk" or "barrel".
    [[nodiscard]] std::string cam_types_text(char quote) const;
    [[nodiscard]] bool required() const { return default_text == "required"; }
    [[nodiscard]] std::string key(const Spelling& spelling) const;  ///< "lift_mm"
    [[nodiscard]] std::string first_key() const { return key(spellings.front()); }
    [[nodiscard]] KeyNames names() const { return {name, spellings}; }
    /// The allowed values in words for an error message, in the unit of the spelling.
    [[nodiscard]] std::string allowed(const Spelling& spelling) const;
    /// The choices as a message lists them: "a", "b" or "c".
    [[nodiscard]] std::string choices_text() const;
};

[[nodiscard]] inline KeyRow called(std::string_view label, KeyRow row) {
    row.label = label;
    return row;
}

/// "a", "b" or "c", each in quotes.
[[nodiscard]] std::string quoted_choices(const std::vector<std::string_view>& words);

namespace spellings {

using namespace ranges;

}  // namespace spellings
}  // namespace camopt

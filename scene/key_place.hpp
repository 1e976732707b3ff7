// SPDX-License-Identifier: MIT
// Where the value of a key lives in its owner, a Scene for example: the members that lead to it.
//
//     stored_in(&Scene::solver, &SolverSpec::tolerance)
//     stored_in(&Scene::objective, &ObjectiveSpec::dimensions, 2)
//
// Values are numbers in SI, integers, true or false, texts (of an enumeration its word) and lists of them; of
// an array of tables their number. On the way there are optional parts: the row of their own table makes
// them, and the keys of a part that is absent have no value. An entry of an array of tables is a step of the
// way:
//
//     stored_in(&Scene::motion, &MotionSpec::segments, each, &ProgramSegment::via, each_inner, &SetPoint::at)
#pragma once

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

namespace camopt {

namespace key_place {

/// The entry KeyAt::entry[depth] of an array.
struct Entry {
    std::size_t depth = 0;
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
/// A KeyValue holds it as it is.
template <class T>
inline constexpr bool is_kept =
    std::is_same_v<T, bool> || std::is_same_v<T, double> || std::is_same_v<T, std::string> ||
    std::is_same_v<T, std::vector<double>> || std::is_same_v<T, std::vector<std::string>> ||
    std::is_same_v<T, KeyPairs> || std::is_same_v<T, KeyOptions>;
using Two = std::array<double, 2>;

template <class Object>
Object* reached(Object& object, const KeyAt& /*at*/) {
    return &object;
}

/// Null: a part on the way is absent.
template <class Object, class Step, class... Rest>
auto* reached(Object& object, const KeyAt& at, Step step, Rest... rest) {
    if constexpr (is_optional<std::remove_const_t<Object>>)
        return object ? reached(*object, at, step, rest...) : decltype(reached(*object, at, step, rest...))();
    else if constexpr (std::is_member_object_pointer_v<Step>)
        return reached(object.*step, at, rest...);
    else if constexpr (std::is_same_v<Step, Entry>)
        return at.entry[step.depth] < object.size() ? reached(object[at.entry[step.depth]], at, rest...)
                                                    : decltype(reached(object[0], at, rest...))();
    else
        return reached(object[step], at, rest...);
}

/// The value of an enumeration whose word this is, among the first `count`.
template <class Choice>
void assign_choice(Choice& target, const std::string& word, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (word == name_of(static_cast<Choice>(i))) target = static_cast<Choice>(i);
}

template <class T>
void assign(T& target, const KeyValue& value, std::size_t choices) {
    if constexpr (is_optional<T>)
        assign(target.emplace(), value, choices);
    else if constexpr (std::is_enum_v<T>)
        assign_choice(target, std::get<std::string>(value), choices);
    else if constexpr (is_kept<T>)
        target = std::get<T>(value);
    else if constexpr (std::is_integral_v<T>)
        target = static_cast<T>(std::get<long long>(value));
    else if constexpr (std::is_same_v<T, Two>) {
        const auto& both = std::get<std::vector<double>>(value);
        if (both.size() == target.size()) std::ranges::copy(both, target.begin());
    } else if constexpr (is_list<T>)
        target.resize(static_cast<std::size_t>(std::get<long long>(value)));
}

template <class T>
std::optional<KeyValue> value_of(const T& member) {
    if constexpr (is_optional<T>)
        return member ? value_of(*member) : std::nullopt;
    else if constexpr (std::is_enum_v<T>)
        return std::string(name_of(member));
    else if constexpr (is_kept<T>)
        return member;
    else if constexpr (std::is_integral_v<T>)
        return static_cast<long long>(member);
    else if constexpr (std::is_same_v<T, Two>)
        return std::vector<double>{member[0], member[1]};
    else if constexpr (is_list<T>)
        return static_cast<long long>(member.size());
    else
        return KeyValue();  // a table: it is there
}

/// An entry of an array of tables, and of an array within it.
inline constexpr Entry each{0}, each_inner{1};

}  // namespace key_place

template <class Owner, class Member, class... Path>
[[nodiscard]] KeyPlace stored_in(Member Owner::*first, Path... path) {
    KeyPlace place;
    place.assign = [=](Owner& owner, const KeyValue& value, const KeyAt& at) {
        if (auto* const member = key_place::reached(owner, at, first, path...))
            key_place::assign(*member, value, at.choices);
    };
    place.value = [=](const Owner& owner, const KeyAt& at) -> std::optional<KeyValue> {
        const auto* const member = key_place::reached(owner, at, first, path...);
        return member != nullptr ? key_place::value_of(*member) : std::nullopt;
    };
    place.entries = (0 + ... + static_cast<int>(std::is_same_v<Path, key_place::Entry>));
    return place;
}

/// The same with no value where `absent` says so: other keys say it.
template <class Absent>
[[nodiscard]] KeyPlace unless(KeyPlace place, Absent absent) {
    place.value = [=, value = place.value](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        return absent(scene, at) ? std::nullopt : value(scene, at);
    };
    return place;
}

/// The unit of a number that remembers it: where the number is normalised it is empty.
[[nodiscard]] inline KeyPlace in_unit(KeyPlace place, const KeyPlace& unit) {
    place.assign = [assign = place.assign, unit](const KeyOwner& owner, const KeyValue& value,
                                                 const KeyAt& at) {
        assign(owner, value, at);
        if (at.spelling != nullptr && !at.spelling->unit.empty())
            unit.assign(owner, std::string(at.spelling->unit), at);
    };
    place.unit = [unit](const KeyOwner& owner, const KeyAt& at) {
        const std::optional<KeyValue> known = unit.value(owner, at);
        return known ? std::get<std::string>(*known) : std::string();
    };
    return place;
}

/// The value of a key against the range and the choices of its row; none: it has no value, or a right one.
[[nodiscard]] std::optional<SceneFault> row_fault(const KeyRow& row, const KeyOwner& owner);

}  // namespace camopt

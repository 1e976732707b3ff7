// SPDX-License-Identifier: MIT
// Where the value of a key lives in a Scene: the members that lead to it.
//
//     stored_in(&Scene::solver, &SolverSpec::tolerance)
//     stored_in(&Scene::objective, &ObjectiveSpec::dimensions, 2)
//
// Values are numbers in SI, integers, true or false, texts (of an enumeration its word) and lists of numbers.
// On the way there are optional parts: the row of their own table makes them, and the keys of a part that is
// absent have no value.
#pragma once

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

namespace camopt {

namespace key_place {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
/// A KeyValue holds it as it is.
template <class T>
inline constexpr bool is_kept = std::is_same_v<T, bool> || std::is_same_v<T, double> ||
                                std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<double>>;

template <class Object>
Object* reached(Object& object) {
    return &object;
}

/// Null: a part on the way is absent.
template <class Object, class Step, class... Rest>
auto* reached(Object& object, Step step, Rest... rest) {
    if constexpr (is_optional<std::remove_const_t<Object>>)
        return object ? reached(*object, step, rest...) : decltype(reached(*object, step, rest...))();
    else if constexpr (std::is_member_object_pointer_v<Step>)
        return reached(object.*step, rest...);
    else
        return reached(object[step], rest...);
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
    else
        return KeyValue();  // a table: it is there
}

}  // namespace key_place

template <class... Path>
[[nodiscard]] KeyPlace stored_in(Path... path) {
    return {.assign =
                [=](Scene& scene, const KeyValue& value, std::size_t choices) {
                    if (auto* const member = key_place::reached(scene, path...))
                        key_place::assign(*member, value, choices);
                },
            .value = [=](const Scene& scene) -> std::optional<KeyValue> {
                const auto* const member = key_place::reached(scene, path...);
                return member != nullptr ? key_place::value_of(*member) : std::nullopt;
            }};
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A struct that is written as JSON and read back lists its fields once, for both directions:
//
//     static void fields(const JsonFields& json, ForceSummary& forces) {
//         json("least", forces.least);
//         json("largest", forces.largest, infinity);      // null: infinite
//         json.unless("side", forces.side, Side::right);  // the key is left out for this value
//         json.check("least", forces.least >= 0.0, "0 or more");
//     }
//
// Values: bool, whole numbers, double (null where not finite), std::string, enums by name_of (null where the
// name is empty), optional and shared_ptr (null where empty), pairs, lists, Eigen vectors, and structs with
// such a list. Reading throws InputError "FILE: KEY: found …; allowed: …". Private to report/: the JSON
// library stays out of the public headers.
#pragma once

#include "report/json/json_text.hpp"

namespace camopt {

[[nodiscard]] constexpr const char* name_of(Side value) {
    return value == Side::left ? "left" : "right";
}

/// The last value of an enum that is read: all up to it have a name.
template <class Enum>
inline constexpr Enum last_of = Enum::missing;
template <>
inline constexpr Side last_of<Side> = Side::right;
template <>
inline constexpr Verdict last_of<Verdict> = Verdict::failed;
template <>
inline constexpr Reason last_of<Reason> = Reason::objective_not_of_the_curve;
template <>
inline constexpr ProofKind last_of<ProofKind> = ProofKind::boxes;
template <>
inline constexpr Termination last_of<Termination> = Termination::unsupported;
template <>
inline constexpr DesignKind last_of<DesignKind> = DesignKind::states;
template <>
inline constexpr LengthUnit last_of<LengthUnit> = LengthUnit::inch;

template <class T>
concept JsonMaybe = requires(const T& value) {
    *value;
};
template <class T>
concept JsonPair = requires(const T& value) {
    value.first, value.second;
};
template <class T>
concept JsonList = !std::same_as<T, std::string> && requires(const T& value) {
    value.begin();
};

/// Lists of fields take what they may fill; where they write they change nothing.
template <class T>
[[nodiscard]] T& to_write(const T& value) {
    return const_cast<T&>(value);
}

template <class T>
[[nodiscard]] Json written(const T& value);

/// An object that is written, or any value that is read, with its location.
class JsonFields {
 public:
    explicit JsonFields(Json& written_object) : out_(&written_object) {}
    /// kind: "a certificate", what the file should be. Throws InputError for text that is not JSON.
    JsonFields(std::string_view text, std::string_view file, std::string_view kind);

    [[nodiscard]] bool reads() const { return out_ == nullptr; }

    /// null: what null means; without it null is refused.
    template <class T>
    void operator()(const std::string& key, T& value, std::optional<double> null = {}) const {
        if (reads())
            at(key).get(value, null);
        else
            (*out_)[key] = written(value);
    }
    /// A whole number of 0 or more.
    void count(const std::string& key, auto& value) const {
        (*this)(key, value);
        check(key, value >= 0, "a whole number, 0 or more");
    }
    /// A list of numbers, so many if that is known.
    void numbers(const std::string& key, Eigen::VectorXd& values, std::optional<std::size_t> size,
                 std::optional<double> null = {}) const {
        if (reads() && size) at(key).need_list(*size);
        (*this)(key, values, null);
    }
    /// A text; null where it is empty.
    void words(const std::string& key, std::string& text) const;
    /// A number in a unit of files, whose suffix ends the key; one that may be absent has no key then.
    void in(const auto& unit, const std::string& name, double& value, std::optional<double> null = {}) const {
        double number = unit.of(value);
        (*this)(name + unit.suffix, number, null);
        if (reads()) value = unit.si_of(number);
    }
    void in(const auto& unit, const std::string& name, std::optional<double>& value) const {
        if (double* const number = if_there(name + unit.suffix, value)) in(unit, name, *number);
    }
    /// Left out where it has its usual value.
    template <class T>
    void unless(const std::string& key, T& value, const auto& usual) const {
        if (reads() ? has(key) : !(value == usual))
            (*this)(key, value);
        else if (reads())
            value = usual;
    }
    /// The value of a key that is left out where it is empty; nullptr then.
    template <class T>
    [[nodiscard]] T* if_there(const std::string& key, std::optional<T>& value) const {
        if (reads()) value.reset();
        if (reads() && has(key)) value = T();
        return value ? &*value : nullptr;
    }
    /// Each object of a list by list(json, value).
    void each(const std::string& key, auto& values, const auto& list) const {
        if (reads())
            values.resize(at(key).size());
        else
            (*out_)[key] = Json::array();
        for (std::size_t i = 0; i < values.size(); ++i)
            list(reads() ? at(key).at(i) : JsonFields((*out_)[key].emplace_back()), values[i]);
    }
    /// Written only.
    void shown(const std::string& key, const auto& value) const {
        if (!reads()) (*out_)[key] = value;
    }
    /// Of what was read: whether it may be so; `allowed` in words.
    void check(const std::string& key, bool fine, std::string_view allowed) const {
        if (reads() && !fine) at(key).refuse(allowed);
    }

    [[nodiscard]] JsonFields at(const std::string& key) const;  ///< of an object; InputError if missing

    // Of a value that is read.

    [[nodiscard]] JsonFields at(std::size_t index) const;  ///< of a list
    [[nodiscard]] bool has(const std::string& key) const {
        return value_->is_object() && value_->contains(key);
    }
    [[nodiscard]] bool is_null() const { return value_->is_null(); }
    /// Keys and values of an object, in its order.
    [[nodiscard]] std::vector<std::pair<std::string, JsonFields>> members() const;
    template <class T>
    void get(T& value, std::optional<double> null = {}) const;
    template <class T>
    [[nodiscard]] T as() const {
        T value;
        get(value);
        return value;
    }
    [[noreturn]] void fail(std::string_view what) const;
    [[noreturn]] void refuse(std::string_view allowed) const;  ///< "found (this value); allowed: …"

 private:
    struct Document;
    JsonFields(const JsonFields& parent, const Json& value, std::string path)
        : document_(parent.document_), value_(&value), path_(std::move(path)) {}
    [[nodiscard]] std::string path_to(std::string_view key) const;
    [[nodiscard]] std::size_t size() const;  ///< of a list
    void need_list(std::size_t size) const;
    [[nodiscard]] std::int64_t whole(std::int64_t least, std::int64_t most) const;
    [[nodiscard]] std::size_t choice(std::span<const std::string_view> names) const;

    Json* out_ = nullptr;
    std::shared_ptr<const Document> document_;
    const Json* value_ = nullptr;
    std::string path_;
};

template <class T>
Json written(const T& value) {
    if constexpr (std::same_as<T, double>) {
        return number_json(value);
    } else if constexpr (std::integral<T> || std::same_as<T, std::string>) {
        return value;
    } else if constexpr (std::is_enum_v<T>) {
        return words_json(name_of(value));
    } else if constexpr (JsonMaybe<T>) {
        return value ? written(*value) : Json(nullptr);
    } else if constexpr (JsonPair<T>) {
        return Json::array({written(value.first), written(value.second)});
    } else if constexpr (JsonList<T>) {
        Json list = Json::array();
        for (const auto& one : value) list.push_back(written(one));
        return list;
    } else {
        Json object = Json::object();
        fields(JsonFields(object), to_write(value));
        return object;
    }
}

template <class T>
void JsonFields::get(T& value, std::optional<double> null) const {
    if constexpr (std::same_as<T, double>) {
        if (!value_->is_number() && !(null && is_null())) refuse("a number");
        value = is_null() ? *null : value_->template get<double>();
    } else if constexpr (std::same_as<T, bool>) {
        if (!value_->is_boolean()) refuse("true or false");
        value = value_->template get<bool>();
    } else if constexpr (std::integral<T>) {
        value = static_cast<T>(whole(std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
    } else if constexpr (std::same_as<T, std::string>) {
        if (!value_->is_string()) refuse("a text");
        value = value_->template get<std::string>();
    } else if constexpr (std::is_enum_v<T>) {
        std::array<std::string_view, static_cast<std::size_t>(last_of<T>) + 1> names;
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = name_of(static_cast<T>(i));
        value = static_cast<T>(choice(names));
    } else if constexpr (JsonMaybe<T>) {
        value = {};
        if (is_null()) return;
        std::remove_cvref_t<decltype(*value)> inner;
        get(inner);
        if constexpr (requires { value.emplace(inner); })
            value.emplace(std::move(inner));
        else
            value = std::make_shared<decltype(inner)>(std::move(inner));
    } else if constexpr (JsonPair<T>) {
        need_list(2);
        at(std::size_t{0}).get(value.first);
        at(std::size_t{1}).get(value.second);
    } else if constexpr (JsonList<T>) {
        if constexpr (requires { value.resize(1); })
            value.resize(static_cast<decltype(value.size())>(size()));
        else
            need_list(value.size());
        std::size_t i = 0;
        for (auto& one : value) at(i++).get(one, null);
    } else {
        fields(*this, value);
    }
}

/// The value as written, truncated if long; an object or a list by its kind.
[[nodiscard]] std::string json_words(const Json& value);

}  // namespace camopt

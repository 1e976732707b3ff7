// SPDX-License-Identifier: MIT
// A value of a JSON document with its location, for messages. Internal to input/ and to the reader of result
// folders.
#pragma once

#include "core/base/standard.hpp"

#include <nlohmann/json.hpp>

namespace camopt::input {

class JsonSource {
 public:
    /// Throws InputError for text that is not JSON.
    JsonSource(std::string_view text, std::string_view source_name);

    [[nodiscard]] JsonSource at(const char* key) const;  ///< of an object; InputError if missing
    [[nodiscard]] bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
    [[nodiscard]] bool is_null() const { return value_->is_null(); }
    [[nodiscard]] std::vector<JsonSource> items() const;  ///< of a list

    [[nodiscard]] double number() const;
    [[nodiscard]] std::vector<double> numbers() const;
    [[nodiscard]] long count() const;   ///< a whole number of 0 or more
    [[nodiscard]] int integer() const;  ///< 0 to 2^31 − 1
    [[nodiscard]] bool flag() const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string words() const { return is_null() ? std::string() : text(); }
    [[nodiscard]] std::vector<std::string> texts() const;
    /// Keys and values of an object, in its order.
    [[nodiscard]] std::vector<std::pair<std::string, JsonSource>> members() const;

    [[noreturn]] void fail(std::string_view what) const;
    [[nodiscard]] std::string shown() const;  ///< for messages, truncated if long

 private:
    using Json = nlohmann::ordered_json;
    JsonSource(const JsonSource& parent, const Json& value, std::string path)
        : document_(parent.document_), value_(&value), file_(parent.file_), path_(std::move(path)) {}
    [[nodiscard]] std::string path_to(std::string_view key) const;

    std::shared_ptr<const Json> document_;
    const Json* value_ = nullptr;
    std::string file_, path_;
};

/// The value as written, truncated if long; an object or a list by its kind.
[[nodiscard]] std::string json_words(const nlohmann::ordered_json& value);

}  // namespace camopt::input

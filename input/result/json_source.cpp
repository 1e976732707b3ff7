// SPDX-License-Identifier: MIT
#include "input/result/json_source.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "input/result/json_words.hpp"

#include <fmt/format.h>

#include <limits>

namespace camopt::input {

JsonSource::JsonSource(std::string_view text, std::string_view source_name) : file_(source_name) {
    try {
        document_ = std::make_shared<const Json>(Json::parse(text));
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: found no JSON: {}", printable(file_), printable(error.what())));
    }
    value_ = document_.get();
}

std::string JsonSource::shown() const {
    return json_words(*value_);
}

void JsonSource::fail(std::string_view what) const {
    throw InputError(
        fmt::format("{}: {}{}{}", printable(file_), printable(path_), path_.empty() ? "" : ": ", what));
}

std::string JsonSource::path_to(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

bool JsonSource::has(const char* key) const {
    return value_->is_object() && value_->contains(key);
}

JsonSource JsonSource::at(const char* key) const {
    if (!value_->is_object()) fail(fmt::format("found {}; allowed: an object", shown()));
    const auto found = value_->find(key);
    if (found == value_->end())
        throw InputError(fmt::format("{}: {}: found no such key; allowed: a result as camopt writes it",
                                     printable(file_), printable(path_to(key))));
    return {*this, *found, path_to(key)};
}

std::vector<JsonSource> JsonSource::items() const {
    if (!value_->is_array()) fail(fmt::format("found {}; allowed: a list", shown()));
    std::vector<JsonSource> all;
    for (std::size_t i = 0; i < value_->size(); ++i)
        all.push_back({*this, (*value_)[i], fmt::format("{}[{}]", path_, i)});
    return all;
}

double JsonSource::number() const {
    if (!value_->is_number()) fail(fmt::format("found {}; allowed: a number", shown()));
    return value_->get<double>();
}

std::vector<double> JsonSource::numbers() const {
    std::vector<double> all;
    for (const JsonSource& item : items()) all.push_back(item.number());
    return all;
}

long JsonSource::count() const {
    const bool whole =
        value_->is_number_unsigned() &&
        value_->get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<long>::max());
    if (!whole) fail(fmt::format("found {}; allowed: a whole number, 0 or more", shown()));
    return value_->get<long>();
}

int JsonSource::integer() const {
    const long value = count();
    if (value > std::numeric_limits<int>::max())
        fail(fmt::format("found {}; allowed: up to {}", value, std::numeric_limits<int>::max()));
    return static_cast<int>(value);
}

bool JsonSource::flag() const {
    if (!value_->is_boolean()) fail(fmt::format("found {}; allowed: true or false", shown()));
    return value_->get<bool>();
}

std::string JsonSource::text() const {
    if (!value_->is_string()) fail(fmt::format("found {}; allowed: a text", shown()));
    return value_->get<std::string>();
}

std::vector<std::string> JsonSource::texts() const {
    std::vector<std::string> all;
    for (const JsonSource& item : items()) all.push_back(item.text());
    return all;
}

std::vector<std::pair<std::string, JsonSource>> JsonSource::members() const {
    if (!value_->is_object()) fail(fmt::format("found {}; allowed: an object", shown()));
    std::vector<std::pair<std::string, JsonSource>> all;
    for (const auto& [key, value] : value_->items())
        all.emplace_back(key, JsonSource(*this, value, path_to(key)));
    return all;
}

}  // namespace camopt::input

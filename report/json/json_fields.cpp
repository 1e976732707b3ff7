// SPDX-License-Identifier: MIT
#include "report/json/json_fields.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr std::size_t longest_shown = 60;

}  // namespace

struct JsonFields::Document {
    Json json;
    std::string file, kind;
};

JsonFields::JsonFields(std::string_view text, std::string_view file, std::string_view kind) {
    try {
        document_ = std::make_shared<const Document>(
            Document{Json::parse(text), std::string(file), std::string(kind)});
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: found no JSON: {}; allowed: {}", printable(file),
                                     printable(error.what()), kind));
    }
    value_ = &document_->json;
}

void JsonFields::fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}{}{}", printable(document_->file), printable(path_),
                                 path_.empty() ? "" : ": ", what));
}

void JsonFields::refuse(std::string_view allowed) const {
    fail(fmt::format("found {}; allowed: {}", json_words(*value_), allowed));
}

std::string JsonFields::path_to(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

JsonFields JsonFields::at(const std::string& key) const {
    if (!reads()) return JsonFields((*out_)[key]);
    if (!value_->is_object()) refuse("an object");
    const auto found = value_->find(key);
    if (found == value_->end())
        JsonFields(*this, *value_, path_to(key))
            .fail(fmt::format("found no such key; allowed: {} as camopt writes it", document_->kind));
    return {*this, *found, path_to(key)};
}

JsonFields JsonFields::at(std::size_t index) const {
    return {*this, value_->at(index), fmt::format("{}[{}]", path_, index)};
}

std::vector<std::pair<std::string, JsonFields>> JsonFields::members() const {
    if (!value_->is_object()) refuse("an object");
    std::vector<std::pair<std::string, JsonFields>> all;
    for (const auto& [key, value] : value_->items())
        all.emplace_back(key, JsonFields(*this, value, path_to(key)));
    return all;
}

void JsonFields::words(const std::string& key, std::string& text) const {
    std::optional<std::string> words;
    if (!text.empty()) words = text;
    (*this)(key, words);
    if (reads()) text = words.value_or("");
}

std::size_t JsonFields::size() const {
    if (!value_->is_array()) refuse("a list");
    return value_->size();
}

void JsonFields::need_list(std::size_t size) const {
    if (!value_->is_array() || value_->size() != size) refuse(fmt::format("a list of {}", size));
}

std::int64_t JsonFields::whole(std::int64_t least, std::int64_t most) const {
    const bool fits = value_->is_number_unsigned()
                          ? std::cmp_less_equal(value_->get<std::uint64_t>(), most)
                          : value_->is_number_integer() && value_->get<std::int64_t>() >= least &&
                                value_->get<std::int64_t>() <= most;
    if (!fits) refuse(fmt::format("a whole number up to {}", most));
    return value_->get<std::int64_t>();
}

std::size_t JsonFields::choice(std::span<const std::string_view> names) const {
    std::string word;
    if (!is_null()) get(word);
    const auto found = std::ranges::find(names, word);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    const std::size_t shown = names.front().empty() ? 1 : 0;  // "" is null, which is none of them
    refuse(fmt::format("{}", fmt::join(names.subspan(shown), ", ")));
}

std::string json_words(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("a list of {}", value.size());
    const std::string text = printable(value.dump(-1, ' ', true, Json::error_handler_t::replace));
    return text.size() <= longest_shown ? text : text.substr(0, longest_shown) + "...";
}

}  // namespace camopt

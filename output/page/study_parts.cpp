// SPDX-License-Identifier: MIT
#include "core/version.hpp"
#include "input/scene_reader.hpp"
#include "output/page/page_parts.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    }
    return lines;
}

/// What stands otherwise in a text of as many lines; a text of other length replaces the whole by its first
/// line.
Json edits_between(const std::vector<std::string>& base, const std::string& text) {
    const std::vector<std::string> lines = lines_of(text);
    Json edits = Json::array();
    if (lines.size() != base.size()) return {{-1, text}};
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i] != base[i]) edits.push_back({i, lines[i]});
    return edits;
}

}  // namespace

StudyPage::StudyPage(std::string_view kind, std::string_view title) {
    page_ = {{"page", "study"},
             {"camopt", version()},
             {"kind", kind},
             {"title", title.empty() ? kind : title},
             {"items", {{"names", Json::array()}, {"numbers", Json::array()}, {"tones", Json::array()}}},
             {"columns", Json::array()},
             {"axes", nullptr},
             {"picture", nullptr},
             {"overlay", nullptr},
             {"scenes", nullptr},
             {"without_scenes", nullptr},
             {"scene", nullptr}};
}

void StudyPage::add_item(std::string_view name, int number, std::string_view tone) {
    page_["items"]["names"].push_back(name);
    page_["items"]["numbers"].push_back(number);
    page_["items"]["tones"].push_back(tone);
}

void StudyPage::add_column(std::string_view key, std::string_view title, Json values, bool left) {
    page_["columns"].push_back(
        {{"key", key}, {"title", title}, {"left", left}, {"values", std::move(values)}});
}

void StudyPage::set_picture(std::string_view svg) {
    if (const std::size_t begin = svg.find("<svg"); begin != std::string_view::npos) svg.remove_prefix(begin);
    page_["picture"] = svg;
}

void StudyPage::set_scenes(const RunOrigin& origin,
                           std::span<const std::optional<std::vector<std::string>>> settings) {
    if (origin.scene_text.empty()) return;
    page_["scene"] = {{"file", origin.scene_file}, {"text", origin.scene_text}, {"lines", Json::array()}};
    std::vector<std::string> base;
    Json edits = Json::array();
    for (const std::optional<std::vector<std::string>>& item : settings) {
        if (!item) {
            edits.push_back(nullptr);
            continue;
        }
        const std::string text =
            item->empty() ? origin.scene_text
                          : input::scene_with_overrides(origin.scene_text, origin.scene_file, *item);
        if (base.empty()) {
            base = lines_of(text);
            page_["scenes"]["base"] = text;
        }
        edits.push_back(edits_between(base, text));
    }
    if (!base.empty()) page_["scenes"]["edits"] = std::move(edits);
}

std::string StudyPage::html() const {
    PageHtml page;
    page.title = page_["title"].get<std::string>();
    page.data = page_.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    return page_html(page);
}

Json cell_json(std::optional<double> value) {
    if (!value) return nullptr;
    return std::isinf(*value) ? Json("∞") : rounded_json(*value);
}

}  // namespace camopt

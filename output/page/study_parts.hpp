// SPDX-License-Identifier: MIT
// Private to output/page: what the pages of many motions are put together from.
#pragma once

#include "output/json/json_text.hpp"
#include "output/json/run_origin.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// Many motions on one page, in the making.
class StudyPage {
 public:
    StudyPage(std::string_view kind, std::string_view title);

    /// headline, and sentences below it; tone as in page_data.hpp.
    void set_verdict(std::string_view tone, std::string_view headline,
                     const std::vector<std::string>& sentences);
    void add_item(std::string_view name, int number, std::string_view tone);
    /// One value an item, in their order.
    void add_column(std::string_view key, std::string_view title, Json values, bool left = false);
    void set_axes(std::string_view x, std::string_view y);
    void set_picture(std::string_view svg);
    void set_overlay(Json overlay) { page_["overlay"] = std::move(overlay); }
    /// The scene as text, and of every item the settings KEY=VALUE that make its own of it; none: it has
    /// none. Nothing where there is no text.
    void set_scenes(const RunOrigin& origin,
                    std::span<const std::optional<std::vector<std::string>>> settings);
    /// Instead of scenes: what a click says, and the command that solves an item's scene but for the settings
    /// in the item's name ("row 7: KEY=VALUE, KEY=VALUE").
    void set_without_scenes(std::string_view words, std::string_view command);
    /// The whole page.
    [[nodiscard]] std::string html() const;

 private:
    Json page_;
};

/// A number, or "∞" where it is infinite, null where there is none.
[[nodiscard]] Json cell_json(std::optional<double> value);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Private to output/page: the parts of page_html.hpp.
#pragma once

#include "output/json/json_text.hpp"
#include "output/page/page_html.hpp"

namespace camopt {

/// To so many significant digits: eight are as many as a page can show. null for what is not finite.
[[nodiscard]] Json rounded_json(double value, int digits = 8);

/// null where there is no plane cam.
[[nodiscard]] Json plane_drawing(const View& view);

/// To a ten-thousandth of the unit; ten thousand steps a unit keep the text short: 12.3,
/// not 12.299999999999999.
void append(Json& list, const ShownUnit& unit, const Eigen::Ref<const Eigen::VectorXd>& point);

[[nodiscard]] Json verdict_part(const Solution& solution);
/// Of a picture before its proof.
[[nodiscard]] Json open_verdict_part(const Solution& solution);
[[nodiscard]] Json figures_part(const Solution& solution);
/// null without a law to compare with.
[[nodiscard]] Json reference_part(const Solution& solution, PageReference wish);
[[nodiscard]] Json tables_part(const Solution& solution);
[[nodiscard]] Json appendix_part(const Solution& solution, const RunOrigin& origin);
[[nodiscard]] Json table_json(std::string_view key, std::string_view title, const TextTable& table,
                              std::string_view note = {});

// Private to output/page: what the pages of many motions are put together from.

/// Many motions on one page, in the making.
class StudyPage {
 public:
    StudyPage(std::string_view kind, std::string_view title);

    /// headline, and sentences below it; tone as in page_html.hpp.
    void set_verdict(std::string_view tone, std::string_view headline,
                     const std::vector<std::string>& sentences) {
        page_["verdict"] = {{"key", tone}, {"tone", tone}, {"headline", headline}, {"sentences", sentences}};
    }
    void add_item(std::string_view name, int number, std::string_view tone);
    /// One value an item, in their order.
    void add_column(std::string_view key, std::string_view title, Json values, bool left = false);
    void set_axes(std::string_view x, std::string_view y) { page_["axes"] = {{"x", x}, {"y", y}}; }
    void set_picture(std::string_view svg);
    void set_overlay(Json overlay) { page_["overlay"] = std::move(overlay); }
    /// The scene as text, and of every item the settings KEY=VALUE that make its own of it; none: it has
    /// none. Nothing where there is no text.
    void set_scenes(const RunOrigin& origin,
                    std::span<const std::optional<std::vector<std::string>>> settings);
    /// Instead of scenes: what a click says, and the command that solves an item's scene but for the settings
    /// in the item's name ("row 7: KEY=VALUE, KEY=VALUE").
    void set_without_scenes(std::string_view words, std::string_view command) {
        page_["without_scenes"] = {{"words", words}, {"command", command}};
    }
    /// The whole page.
    [[nodiscard]] std::string html() const;

 private:
    Json page_;
};

/// A number, or "∞" where it is infinite, null where there is none.
[[nodiscard]] Json cell_json(std::optional<double> value);

// Private to output/page: the files under assets/ and vendor/, compiled in.

/// "assets/page.css". Throws ModelError for a name that is not there.
[[nodiscard]] std::string_view page_asset(std::string_view name);

}  // namespace camopt

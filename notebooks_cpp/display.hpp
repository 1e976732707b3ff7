// SPDX-License-Identifier: MIT
// Pictures, HTML and tables below a notebook's cell: display_svg(text), display_html(text), Table.
//
// The kernel of this folder (kernel/session.py) cuts frames out of what a cell writes to stdout:
//
//     "\x1e" "camopt display MIME BYTES\n" and BYTES bytes of text
//
// Under xeus-cpp the same functions call xcpp::display. Text is UTF-8; nothing is checked and nothing throws.
#pragma once

#include <charconv>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#if __has_include(<xcpp/xdisplay.hpp>)
#include <nlohmann/json.hpp>

#include <xcpp/xdisplay.hpp>
#define CAMOPT_NOTEBOOK_XEUS 1
#else
#include <dlfcn.h>
#define CAMOPT_NOTEBOOK_XEUS 0
#endif

namespace notebook {

struct Rich {
    std::string mime, text;
};

#if CAMOPT_NOTEBOOK_XEUS
inline nlohmann::json mime_bundle_repr(const Rich& rich) {
    nlohmann::json bundle = nlohmann::json::object();
    bundle[rich.mime] = rich.text;
    return bundle;
}
inline void display(const Rich& rich) {
    xcpp::display(rich);
}
inline bool interrupted() {
    return false;
}
#else
inline void display(const Rich& rich) {
    std::cout.flush();
    std::cout << "\x1e"
              << "camopt display " << rich.mime << ' ' << rich.text.size() << '\n'
              << rich.text << std::flush;
}
/// Whether the cell was asked to stop. For SolveControl::stop_requested: the solve then ends with what it
/// has.
inline bool interrupted() {
    using Question = bool (*)();
    static const Question question =
        reinterpret_cast<Question>(::dlsym(RTLD_DEFAULT, "camopt_notebook_interrupted"));
    return question != nullptr && question();
}
#endif

inline void display_html(std::string_view text) {
    display({"text/html", std::string(text)});
}

/// The rules of a picture's <style> would hold for the whole page: each gets the picture's id before it, and
/// so do the ids that the picture itself refers to.
inline std::string with_rules_of_its_own(std::string svg, const std::string& id) {
    for (std::size_t place = svg.find("<style>"); place != std::string::npos;
         place = svg.find("<style>", place)) {
        place += 7;
        const std::size_t end = svg.find("</style>", place);
        std::string rules;
        bool selector = true, at_begin = true;
        for (std::size_t i = place; i < end; ++i) {
            if (selector && at_begin && svg[i] != ' ' && svg[i] != '\n') {
                rules += '#' + id + ' ';
                at_begin = false;
            }
            rules += svg[i];
            if (svg[i] == '{') selector = false;
            if (svg[i] == '}') selector = true;
            if (svg[i] == '}' || svg[i] == ',') at_begin = true;
        }
        svg.replace(place, end - place, rules);
    }
    for (const auto& [mark, tail] :
         {std::pair(" id=\"", ""), std::pair("url(#", ""), std::pair("href=\"#", "")}) {
        const std::string with = std::string(mark) + id + '-' + tail;
        for (std::size_t place = svg.find(mark); place != std::string::npos;
             place = svg.find(mark, place + with.size()))
            svg.replace(place, std::string_view(mark).size(), with);
    }
    const std::size_t open = svg.find("<svg");
    if (open != std::string::npos) svg.insert(open + 4, " id=\"" + id + '"');
    return svg;
}

/// A picture, as SVG text with or without an XML declaration.
inline void display_svg(std::string_view text) {
    static int count = 0;
    const std::size_t begin = text.find("<svg");
    display({"image/svg+xml",
             with_rules_of_its_own(std::string(begin == std::string_view::npos ? text : text.substr(begin)),
                                   "picture-" + std::to_string(++count))});
}

/// A number with so many decimals, 0 to 80.
inline std::string fixed(double value, int decimals) {
    char text[400];  // the longest double has 309 digits before its point
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
    return end.ec == std::errc{} ? std::string(text, end.ptr) : "?";
}

/// Rows under heads; the first column is words, the others are numbers, to the right. Cells are text: & < >
/// are escaped.
class Table {
 public:
    explicit Table(std::vector<std::string> heads) : heads_(std::move(heads)) {}

    Table& row(std::vector<std::string> cells) {
        rows_.push_back(std::move(cells));
        return *this;
    }

    void show() const {
        std::string html = "<table>\n<thead><tr>";
        for (std::size_t i = 0; i < heads_.size(); ++i) html += cell("th", i, heads_[i]);
        html += "</tr></thead>\n<tbody>\n";
        for (const auto& row : rows_) {
            html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) html += cell("td", i, row[i]);
            html += "</tr>\n";
        }
        display_html(html + "</tbody>\n</table>\n");
    }

 private:
    static std::string cell(const std::string& kind, std::size_t column, const std::string& words) {
        std::string text = '<' + kind + " style=\"text-align:" + (column == 0 ? "left" : "right") + "\">";
        for (const char letter : words) {
            if (letter == '&')
                text += "&amp;";
            else if (letter == '<')
                text += "&lt;";
            else if (letter == '>')
                text += "&gt;";
            else
                text += letter;
        }
        return text + "</" + kind + '>';
    }

    std::vector<std::string> heads_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace notebook

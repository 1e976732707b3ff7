// SPDX-License-Identifier: MIT
// A page as one HTML file that loads nothing from anywhere: styles, scripts and data stand in it. Its policy
// (Content-Security-Policy) lets it load nothing either, whatever the data says.
#pragma once

#include "output/page/page_data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct PageHtml {
    std::string title;
    std::string data;     ///< JSON (page_data.hpp); any text: what could end a script is written otherwise
    bool solids = false;  ///< with the library for three dimensions, half a megabyte
    /// More scripts and styles, run after the page's own, and what the page may connect to (an element of
    /// the policy's connect-src): the studio's.
    std::vector<std::string> scripts = {}, styles = {};
    std::string connect = "'none'";
    /// Of the scripts, for a policy that a server sends; empty: none.
    std::string nonce = {};
};

[[nodiscard]] std::string page_html(const PageHtml& page);

/// report.html: the report of a solution.
[[nodiscard]] std::string report_html(const View& view, const RunOrigin& origin = {});

}  // namespace camopt

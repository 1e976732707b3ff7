// SPDX-License-Identifier: MIT
// What a browser would find in a page: its data, and where its scripts end.
#pragma once

#include "tests/report/well_formed.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace camopt::testing_support {

inline constexpr std::string_view data_begin = "<script type=\"application/json\" id=\"page-data\">";

/// The text of the data element, up to the first end of a script: as an HTML parser reads it.
inline std::string data_text(const std::string& html) {
    const std::size_t begin = html.find(data_begin) + data_begin.size();
    return html.substr(begin, html.find("</script", begin) - begin);
}

/// Throws where it is no JSON.
inline nlohmann::json data_of(const std::string& html) {
    return nlohmann::json::parse(data_text(html));
}

}  // namespace camopt::testing_support

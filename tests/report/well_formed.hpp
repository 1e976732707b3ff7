// SPDX-License-Identifier: MIT
// A strict little reader of XML: enough to say whether a text is well-formed and what it holds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camopt::testing_support {

/// Empty where every tag is closed in order, attributes are quoted and entities are known; else what is
/// wrong.
inline std::string xml_fault(std::string_view text) {
    std::vector<std::string> open;
    std::size_t at = 0;
    while ((at = text.find_first_of("<&", at)) != std::string_view::npos) {
        const std::string_view rest = text.substr(at);
        if (rest[0] == '&') {
            bool known = false;
            for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;"})
                known = known || rest.starts_with(entity);
            if (!known) return "entity: " + std::string(rest.substr(0, 12));
            ++at;
            continue;
        }
        if (rest.starts_with("<![CDATA[")) {
            at = text.find("]]>", at);
            if (at == std::string_view::npos) return "open CDATA";
            continue;
        }
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) return "open tag";
        const std::string_view tag = text.substr(at + 1, end - at - 1);
        at = end + 1;
        if (tag.starts_with("?") || tag.starts_with("!DOCTYPE")) continue;
        if (tag.starts_with("/")) {
            if (open.empty() || open.back() != tag.substr(1)) return "closes " + std::string(tag);
            open.pop_back();
            continue;
        }
        std::size_t quotes = 0;
        for (const char letter : tag) quotes += letter == '"' ? 1 : 0;
        if (quotes % 2 != 0 || tag.find('<') != std::string_view::npos) return "tag " + std::string(tag);
        if (!tag.ends_with("/")) open.emplace_back(tag.substr(0, tag.find_first_of(" \n")));
    }
    return open.empty() ? std::string{} : "open " + open.back();
}

inline int count_of(std::string_view text, std::string_view part) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string_view::npos; at += part.size()) ++count;
    return count;
}

}  // namespace camopt::testing_support

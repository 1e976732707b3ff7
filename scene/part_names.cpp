// SPDX-License-Identifier: MIT
#include "scene/part_names.hpp"

#include "core/text/parsing.hpp"

#include <fmt/format.h>

namespace camopt {

std::string listed_words(std::string_view key) {
    const std::size_t name = key.rfind('.') + 1;
    std::string words(key.substr(name, key.find('_', name) - name));
    const bool end = key.find("].end.") != std::string_view::npos;
    if (key.find(".via[") != std::string_view::npos)
        words = words == "at"     ? "angle"
                : words == "from" ? "first angle"
                : words == "to"   ? "last angle"
                                  : words;
    else if (words == "to")
        words = "last displacement";
    if (end) words += " at the end";
    std::string places;
    for (std::size_t open = key.find('['); open != std::string_view::npos; open = key.find('[', open + 1)) {
        const std::size_t dot = key.rfind('.', open) + 1;
        const std::string_view list = key.substr(dot, open - dot);
        const std::string_view index = key.substr(open + 1, key.find(']', open) - open - 1);
        places.insert(0, fmt::format(" of {} {}",
                                     list == "via"        ? "set point"
                                     : list == "segments" ? "segment"
                                                          : list,
                                     1 + integer_in(index).value_or(0)));
    }
    return key.ends_with(']') ? places.substr(std::string_view(" of ").size()) : words + places;
}

}  // namespace camopt

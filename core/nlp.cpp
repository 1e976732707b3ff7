// SPDX-License-Identifier: MIT
#include "core/nlp.hpp"

#include <fmt/format.h>

namespace camopt {

std::string RowOrigin::text() const {
    std::string words = rule;
    if (!remark.empty()) words += fmt::format(" ({})", remark);
    if (at) words += fmt::format(" at x = {:.9g}{}", *at, side == Side::left ? "-" : "");
    return words;
}

}  // namespace camopt

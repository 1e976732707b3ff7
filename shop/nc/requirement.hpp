// SPDX-License-Identifier: MIT
// Private to shop/nc: options that must hold, refused in one form of words.
#pragma once

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

/// "blank: its upper end must lie above its lower end, found -5 mm"
struct Requirement {
    const char* subject = "";
    const char* unit = "";  ///< " mm"
    double unit_value = 1.0;

    /// Throws InputError where it does not hold.
    void operator()(bool holds, const char* what, double found) const {
        if (holds) return;
        throw InputError(fmt::format("{}: {}, found {:g}{}", subject, what, found / unit_value, unit));
    }
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/text/quantity_text.hpp"

#include <fmt/format.h>

namespace camopt {

std::string length_text(double length, LengthUnit unit) {
    return fmt::format("{:.6g} {}", length / metres_of(unit), name_of(unit));
}

std::string length_fault(std::string_view name, double length, bool has_sign) {
    if (!std::isfinite(length)) return fmt::format("the {} is not a number", name);
    return has_sign || length > 0.0 ? ""
                                    : fmt::format("the {} of {} is not positive", name, length_text(length));
}

std::string angle_text(double angle) {
    return fmt::format("{:.6g} deg", angle / units::degree);
}

}  // namespace camopt

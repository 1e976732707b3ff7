// SPDX-License-Identifier: MIT
#include "core/text/quantity_text.hpp"

#include <fmt/format.h>

namespace camopt {

std::string length_text(double length, LengthUnit unit) {
    return fmt::format("{:.6g} {}", length / metres_of(unit), name_of(unit));
}

std::string angle_text(double angle) {
    return fmt::format("{:.6g} deg", angle / units::degree);
}

}  // namespace camopt

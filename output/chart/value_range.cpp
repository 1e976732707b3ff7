// SPDX-License-Identifier: MIT
#include "output/chart/value_range.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

void ValueRange::add(double value) {
    if (!std::isfinite(value)) return;
    lower = started ? std::min(lower, value) : value;
    upper = started ? std::max(upper, value) : value;
    started = true;
}

ValueRange ValueRange::padded(double part) const {
    constexpr double least_width =
        1e-3;  // of the values: what differs by less is level, not a curve of rounding
    const double size = std::max(std::abs(lower), std::abs(upper));
    const double width = std::max(upper - lower, least_width * (size > 0.0 ? size : 1.0));
    const double middle = 0.5 * (lower + upper);
    return {middle - (0.5 + part) * width, middle + (0.5 + part) * width, started};
}

}  // namespace camopt

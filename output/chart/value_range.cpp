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
    const double width = std::max(upper - lower, 1e-6 * std::max(1.0, std::abs(upper)));
    return {lower - part * width, upper + part * width, started};
}

}  // namespace camopt

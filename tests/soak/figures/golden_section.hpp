// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

namespace camopt::soak {

/// The largest value found of a function with one maximum in [low, high].
template <typename Number, typename Function>
double highest_between(Number low, Number high, const Function& function) {
    constexpr auto golden = static_cast<Number>(0.61803398874989484820L);
    double best = -std::numeric_limits<double>::infinity();
    for (int step = 0; step < 60; ++step) {
        const Number left = high - golden * (high - low);
        const Number right = low + golden * (high - low);
        const double at_left = function(left), at_right = function(right);
        best = std::max({best, at_left, at_right});
        (at_left > at_right ? high : low) = at_left > at_right ? right : left;
    }
    return best;
}

}  // namespace camopt::soak

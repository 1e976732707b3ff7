// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::c {

double number_or_absent(const std::optional<double>& value) {
    return value.value_or(absent_number);
}

double finite_or_absent(double value) {
    return std::isfinite(value) ? value : absent_number;
}

void check_size(std::size_t size, std::size_t least, const char* name) {
    if (size < least)
        throw Failure(
            CAMOPT_ERROR_ARGUMENT,
            fmt::format("{}: found size = {}; allowed: sizeof of the struct, {} or more", name, size, least));
}

void check_index(std::size_t index, std::size_t count, const char* name) {
    if (index < count) return;
    throw Failure(CAMOPT_ERROR_ARGUMENT,
                  count == 0 ? fmt::format("{}: found {}; there is none", name, index)
                             : fmt::format("{}: found {}; allowed: 0 to {}", name, index, count - 1));
}

}  // namespace camopt::c

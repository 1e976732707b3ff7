// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace camopt {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Tokens that nobody can guess.
#pragma once

#include "core/base/standard.hpp"

namespace camopt::apps {

/// For addresses and policies: 128 bits of the system's random source, as 32 hexadecimal digits. Throws
/// std::system_error where there is none.
[[nodiscard]] std::string random_token();

}  // namespace camopt::apps

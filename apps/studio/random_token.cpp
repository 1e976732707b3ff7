// SPDX-License-Identifier: MIT
#include "apps/studio/random_token.hpp"

#include <fmt/format.h>

#include <random>

namespace camopt::apps {

std::string random_token() {
    std::random_device source;
    std::string token;
    for (int i = 0; i < 16; ++i) token += fmt::format("{:02x}", source() & 0xffU);
    return token;
}

}  // namespace camopt::apps

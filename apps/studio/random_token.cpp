// SPDX-License-Identifier: MIT
#include "apps/studio/studio_server.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <sys/random.h>

namespace camopt::apps {

std::string random_token() {
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error("the system's random source returned nothing");
    std::string token;
    for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
    return token;
}

}  // namespace camopt::apps

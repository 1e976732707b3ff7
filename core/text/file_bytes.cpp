// SPDX-License-Identifier: MIT
#include "core/text/file_bytes.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace camopt {

namespace {

std::string reason() {
    return std::generic_category().message(errno);
}

}  // namespace

FileBytes file_bytes(const std::filesystem::path& path, std::uintmax_t most) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return {{}, "it is a folder"};
    errno = 0;
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
    if (!file) return {{}, reason()};
    FileBytes result;
    std::array<char, 1U << 16U> part;
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get())) {
        if (result.bytes.size() + count > most)
            return {{}, fmt::format("it has more than {} MB", most >> 20U)};
        result.bytes.append(part.data(), count);
    }
    if (std::ferror(file.get()) != 0) return {{}, reason()};
    return result;
}

}  // namespace camopt

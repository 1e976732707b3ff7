// SPDX-License-Identifier: MIT
#include "output/text_file.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unistd.h>

namespace camopt {

namespace {

[[noreturn]] void refuse(const char* what, const std::filesystem::path& path, const std::string& reason) {
    throw InputError(fmt::format("cannot {} {}: {}", what, path.string(), reason));
}

}  // namespace

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path temporary = path;
    temporary += fmt::format(".{}.tmp", ::getpid());  // two camopt runs may write into the same folder
    std::error_code ignored;
    errno = 0;
    {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.flush();
        if (!file) {
            const std::string reason = std::strerror(errno);
            std::filesystem::remove(temporary, ignored);
            refuse("write", path, reason);
        }
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::filesystem::remove(temporary, ignored);
        refuse("write", path, error.message());
    }
}

std::string read_text_file(const std::filesystem::path& path) {
    errno = 0;
    if (std::filesystem::is_directory(path)) refuse("read", path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse("read", path, std::strerror(errno));
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) refuse("read", path, std::strerror(errno));
    return text;
}

}  // namespace camopt

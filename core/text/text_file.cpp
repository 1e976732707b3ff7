// SPDX-License-Identifier: MIT
#include "core/text/text_file.hpp"

#include "core/errors.hpp"
#include "core/platform/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace camopt {

namespace {

[[noreturn]] void refuse(const char* what, const std::filesystem::path& path, const std::string& reason) {
    throw InputError(fmt::format("cannot {} {}: {}", what, path.string(), reason));
}

enum class Durability { program, power };  ///< whose failure the file survives

/// False: errno has the reason.
bool is_written(const std::filesystem::path& path, std::string_view text, Durability durability) {
    std::FILE* const file = open_for_writing(path);
    if (file == nullptr) return false;
    const bool done = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                      (durability == Durability::program || flush_to_disk(file));
    const int reason = errno;
    if (std::fclose(file) != 0) return false;  // a network file system may report a full disk only here
    errno = reason;
    return done;
}

void write_in_one_step(const std::filesystem::path& path, std::string_view text, Durability durability) {
    std::filesystem::path temporary = path;
    temporary += fmt::format(".{}.tmp", process_number());  // two camopt runs may write into the same folder
    std::error_code ignored;
    errno = 0;
    if (!is_written(temporary, text, durability)) {
        const std::string reason = std::strerror(errno);
        std::filesystem::remove(temporary, ignored);
        refuse("write", path, reason);
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::filesystem::remove(temporary, ignored);
        refuse("write", path, error.message());
    }
}

std::string reason() {
    return std::generic_category().message(errno);
}

}  // namespace

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    write_in_one_step(path, text, Durability::program);
}

void write_durable_text_file(const std::filesystem::path& path, std::string_view text) {
    write_in_one_step(path, text, Durability::power);
}

std::string read_text_file(const std::filesystem::path& path) {
    FileBytes file = file_bytes(path);
    if (!file.fault.empty()) refuse("read", path, file.fault);
    return std::move(file.bytes);
}

FileBytes file_bytes(const std::filesystem::path& path, std::uintmax_t most) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return {{}, "it is a folder"};
    errno = 0;
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(open_for_reading(path), close);
    if (!file) return {{}, reason()};
    FileBytes result;
    std::array<char, 1U << 16U> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get())) {
        if (result.bytes.size() + count > most)
            return {{}, fmt::format("it has more than {} MB", most >> 20U)};
        result.bytes.append(part.data(), count);
    }
    if (std::ferror(file.get()) != 0) return {{}, reason()};
    return result;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A file is there whole, or its writing is refused with the reason.
#include "core/text/text_file.hpp"

#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <unistd.h>

namespace camopt {
namespace text_file_test {

using Write = void (*)(const std::filesystem::path&, std::string_view);

/// Its temporary file leads to a device that is always full.
std::string fault_on_full_disk(Write write, const std::filesystem::path& path, std::size_t bytes) {
    std::filesystem::path temporary = path;
    temporary += "." + std::to_string(::getpid()) + ".tmp";
    std::filesystem::create_symlink("/dev/full", temporary);
    std::string fault = testing_support::refusal([&] { write(path, std::string(bytes, 'x')); });
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(temporary)));
    return fault;
}

TEST(TextFile, FullDiskKeepsOldFile) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("camopt_text_file_" + std::to_string(::getpid()));
    write_text_file(path, "old");
    for (const Write write : {write_text_file, write_durable_text_file})
        for (const std::size_t bytes : {1U, 100'000U})  // within the stream's buffer, and beyond
            EXPECT_EQ(fault_on_full_disk(write, path, bytes),
                      "cannot write " + path.string() + ": No space left on device");
    EXPECT_EQ(file_bytes(path).bytes, "old");
    std::filesystem::remove(path);
}

}  // namespace text_file_test
}  // namespace camopt

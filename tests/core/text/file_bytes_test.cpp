// SPDX-License-Identifier: MIT
// Files that cannot be read say why instead of throwing from the standard library.
#include "core/text/text_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace camopt {
namespace file_bytes_test {

TEST(FileBytes, AreThoseOfTheFile) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("camopt_file_bytes_" + std::to_string(::getpid()));
    const std::string bytes("a\0b\r\n\xff", 6);
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_EQ(file_bytes(path).bytes, bytes);
    EXPECT_EQ(file_bytes(path).fault, "");
    EXPECT_EQ(file_bytes(path, 6).bytes, bytes);
    EXPECT_NE(file_bytes(path, 5).fault, "");
    std::filesystem::remove(path);
    EXPECT_EQ(file_bytes(path).fault, "No such file or directory");
}

TEST(FileBytes, FaultsUnderWayAreFaults) {
    EXPECT_EQ(file_bytes("/").fault, "it is a folder");
    if (std::filesystem::exists("/proc/self/mem")) {  // opens, and fails at its first byte
        EXPECT_NE(file_bytes("/proc/self/mem").fault, "");
        EXPECT_EQ(file_bytes("/proc/self/mem").bytes, "");
    }
    if (std::filesystem::exists("/dev/zero")) {  // has no end
        EXPECT_EQ(file_bytes("/dev/zero", 1U << 21U).fault, "it has more than 2 MB");
    }
}

}  // namespace file_bytes_test
}  // namespace camopt

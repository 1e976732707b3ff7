// SPDX-License-Identifier: MIT
// The bytes of a file, or why there are none: the one place that reads files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace camopt {

/// What nobody writes by hand, and what a device without an end would fill the memory with.
inline constexpr std::uintmax_t most_file_bytes = std::uintmax_t{1} << 30U;

struct FileBytes {
    std::string bytes;
    std::string fault;  ///< empty: `bytes` are the file; else the reason, as the system words it
};

/// Never throws but for want of memory. A folder, a file that fails under way and one with more than `most`
/// bytes are faults.
[[nodiscard]] FileBytes file_bytes(const std::filesystem::path& path, std::uintmax_t most = most_file_bytes);

}  // namespace camopt

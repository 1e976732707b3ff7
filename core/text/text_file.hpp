// SPDX-License-Identifier: MIT
// Writing a file so that an interruption loses nothing: the text goes to a temporary file beside it, which
// then takes its name in one step. Either the old file stands there or the new one, never half of one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace camopt {

/// Throws InputError, naming the file and the system's reason, where it cannot be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// The same, and the bytes are on the disk before the file takes its name: it survives a power failure too.
/// Some milliseconds slower.
void write_durable_text_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError where the file cannot be read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

// The bytes of a file, or why there are none: the one place that reads files.

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

// SPDX-License-Identifier: MIT
// Atomic writing of a file: the text goes to a temporary file in the same folder, which is then renamed.
// After an interruption either the old file exists or the new one, never half of one.
#pragma once

#include "core/base/standard.hpp"

#include <cstdint>
#include <filesystem>

namespace camopt {

/// Throws InputError, naming the file and the system's reason, where it cannot be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// The same, with the bytes on the disk before the rename: survives a power failure too. Some milliseconds
/// slower.
void write_durable_text_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError where the file cannot be read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

// The bytes of a file, or why there are none. All files are read here.

/// More than users write by hand; prevents an endless device from filling the memory.
inline constexpr std::uintmax_t most_file_bytes = std::uintmax_t{1} << 30U;

struct FileBytes {
    std::string bytes;
    std::string fault;  ///< empty: `bytes` are the file; else the reason, as the system words it
};

/// Throws only for lack of memory. A folder, a read error and a file of more than `most` bytes are faults.
[[nodiscard]] FileBytes file_bytes(const std::filesystem::path& path, std::uintmax_t most = most_file_bytes);

}  // namespace camopt

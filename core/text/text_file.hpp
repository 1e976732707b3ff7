// SPDX-License-Identifier: MIT
// Writing a file so that an interruption loses nothing: the text goes to a temporary file beside it, which
// then takes its name in one step. Either the old file stands there or the new one, never half of one.
#pragma once

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

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The files of parts as the operating system finds and opens them. One implementation each: posix, and none,
// where every part is linked in. Internal to parts.cpp.
#pragma once

#include "core/base/standard.hpp"
#include "core/platform/part_function.hpp"

#include <filesystem>

namespace camopt {

/// camopt/ below each folder in which the libraries of this module are looked for, in that order.
[[nodiscard]] std::vector<std::filesystem::path> part_folders();

/// "camopt_part_step.so"
[[nodiscard]] std::string part_file_name(std::string_view part);

/// Throws UnavailableError where the system cannot open the file or it has no such function.
[[nodiscard]] PartEntry open_part_file(const std::filesystem::path& file, const std::string& function);

}  // namespace camopt

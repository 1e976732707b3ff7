// SPDX-License-Identifier: MIT
// In a browser, and on Windows: every part that a build has is linked in.
#include "core/platform/part_files.hpp"

#include "core/errors.hpp"

namespace camopt {

std::vector<std::filesystem::path> part_folders() {
    return {};
}

std::string part_file_name(std::string_view part) {
    return "camopt_part_" + std::string(part);
}

PartEntry open_part_file(const std::filesystem::path& file, const std::string&) {
    throw UnavailableError("cannot open " + file.string() + ": on this system parts of camopt are linked in");
}

}  // namespace camopt

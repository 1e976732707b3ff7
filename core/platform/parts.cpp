// SPDX-License-Identifier: MIT
#include "core/platform/parts.hpp"

#include "core/errors.hpp"
#include "core/platform/part_files.hpp"

#include <fmt/ranges.h>

#include <cstdlib>
#include <system_error>

namespace camopt {

namespace {

constexpr const char* place_variable = "CAMOPT_PARTS";

std::vector<std::filesystem::path> folders_to_search() {
    std::vector<std::filesystem::path> folders = part_folders();
    if (const char* const place = std::getenv(place_variable); place != nullptr && *place != '\0')
        folders.insert(folders.begin(), place);
    return folders;
}

/// Empty: it is in none.
std::filesystem::path file_of(const PartInfo& part) {
    std::error_code ignored;
    for (const std::filesystem::path& folder : folders_to_search())
        if (std::filesystem::path file = folder / part_file_name(part.name);
            std::filesystem::is_regular_file(file, ignored))
            return file;
    return {};
}

std::string searched_words() {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : folders_to_search()) names.push_back(folder.string());
    return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuse(const PartInfo& part) {
    if (part.build == PartBuild::absent)
        throw UnavailableError(fmt::format("{} need {}, which this build of camopt does not have: {}",
                                           part.use, part.library, part_remedy(part)));
    throw UnavailableError(fmt::format("{} need {}: found no {} in {}; {}", part.use, part.library,
                                       part_file_name(part.name), searched_words(), part_remedy(part)));
}

}  // namespace

bool part_available(const PartInfo& part) {
    switch (part.build) {
        case PartBuild::absent:
            return false;
        case PartBuild::linked:
            return true;
        case PartBuild::opened:
            break;
    }
    return !file_of(part).empty();
}

std::string part_remedy(const PartInfo& part) {
    if (part.build == PartBuild::absent)
        return fmt::format("install {} and configure camopt again with {}=ON", part.library_package,
                           part.option);
    return fmt::format("install the Debian package {}, or name the folder of the file in {}", part.package,
                       place_variable);
}

void require_part(const PartInfo& part) {
    if (!part_available(part)) refuse(part);
}

const void* part_table(const PartInfo& part, PartEntry linked) {
    if (part.build == PartBuild::linked) return linked(CAMOPT_PART_BUILD);
    if (part.build == PartBuild::absent) refuse(part);
    const std::filesystem::path file = file_of(part);
    if (file.empty()) refuse(part);
    const std::string function = std::string("camopt_part_") + part.name;
    const void* const table = open_part_file(file, function)(CAMOPT_PART_BUILD);
    if (table == nullptr)
        throw UnavailableError(fmt::format("{} need {}: found {} of another camopt; allowed: that of {}",
                                           part.use, part.library, file.string(), CAMOPT_PART_BUILD));
    return table;
}

}  // namespace camopt

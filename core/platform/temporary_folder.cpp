// SPDX-License-Identifier: MIT
// The same on every platform: a name that is not there yet.
#include "core/errors.hpp"
#include "core/platform/files.hpp"

#include <random>
#include <system_error>

namespace camopt {

std::filesystem::path make_temporary_folder() {
    std::random_device source;
    std::error_code error;
    const std::filesystem::path root = std::filesystem::temp_directory_path(error);
    constexpr int attempts = 100;
    for (int i = 0; i < attempts && !error; ++i) {
        std::filesystem::path path =
            root / ("camopt-" + std::to_string(process_number()) + "-" + std::to_string(source()));
        if (!std::filesystem::create_directory(path, error)) continue;
        std::filesystem::permissions(path, std::filesystem::perms::owner_all, error);
        return path;
    }
    throw InputError("cannot create a folder in \"" + root.string() + "\": " + error.message());
}

}  // namespace camopt

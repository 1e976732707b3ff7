// SPDX-License-Identifier: MIT
// In a browser: one program, and no disk.
#include "core/platform/files.hpp"

namespace camopt {

long long process_number() {
    return 1;
}

bool process_has_ended(long long) {
    return true;
}

std::FILE* open_for_reading(const std::filesystem::path& path) {
    return std::fopen(path.c_str(), "rb");
}

std::FILE* open_for_writing(const std::filesystem::path& path) {
    return std::fopen(path.c_str(), "wb");
}

bool flush_to_disk(std::FILE* file) {
    return std::fflush(file) == 0;
}

FolderLock::FolderLock(const std::filesystem::path&) {}

void FolderLock::leave_to_parent() {}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/platform/files.hpp"

#include "core/errors.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/types.h>
#include <unistd.h>

namespace camopt {

long long process_number() {
    return ::getpid();
}

bool process_has_ended(long long number) {
    return ::kill(static_cast<::pid_t>(number), 0) != 0 && errno == ESRCH;
}

std::FILE* open_for_reading(const std::filesystem::path& path) {
    return std::fopen(path.c_str(), "rb");
}

std::FILE* open_for_writing(const std::filesystem::path& path) {
    return std::fopen(path.c_str(), "wb");
}

bool flush_to_disk(std::FILE* file) {
    return std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
}

FolderLock::FolderLock(const std::filesystem::path& folder) {
    file_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    leave_to_parent();
    throw InputError("another camopt is running in " + folder.string() +
                     "; wait for it, or take another folder");
}

void FolderLock::leave_to_parent() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
}

}  // namespace camopt

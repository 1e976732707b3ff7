// SPDX-License-Identifier: MIT
#include "apps/folder_lock.hpp"

#include "core/errors.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace camopt::apps {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    file_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    leave_to_parent();
    throw InputError("another camopt is at work in " + folder.string() +
                     "; wait for it, or take another folder");
}

void FolderLock::leave_to_parent() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
}

}  // namespace camopt::apps

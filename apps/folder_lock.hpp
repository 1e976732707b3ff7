// SPDX-License-Identifier: MIT
// One program at a time in a folder.
#pragma once

#include <filesystem>

namespace camopt::apps {

/// Held as long as it lives; the system lets go of it however the program ends.
class FolderLock {
 public:
    /// Throws InputError where another program holds it. A file system that knows no locks is no hindrance.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock() { leave_to_parent(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// In a forked child: the lock stays with the parent alone.
    void leave_to_parent();

 private:
    int file_ = -1;
};

}  // namespace camopt::apps

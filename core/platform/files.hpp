// SPDX-License-Identifier: MIT
// What only the operating system can do with files and folders. One implementation each: posix, windows and
// none (a browser: one program, no disk).
#pragma once

#include "core/base/standard.hpp"

#include <cstdio>
#include <filesystem>

namespace camopt {

/// For names of temporary files: two camopt runs may write into the same folder.
[[nodiscard]] long long process_number();

/// No process of this number runs any more.
[[nodiscard]] bool process_has_ended(long long number);

/// Binary; null: errno has the reason.
[[nodiscard]] std::FILE* open_for_reading(const std::filesystem::path& path);
[[nodiscard]] std::FILE* open_for_writing(const std::filesystem::path& path);

/// Waits until the bytes that were written are on the disk. False: they may not be; errno has the reason.
[[nodiscard]] bool flush_to_disk(std::FILE* file);

/// A new, empty folder of this process alone among the temporary files, which nothing removes. Throws
/// InputError where the system gives none.
[[nodiscard]] std::filesystem::path make_temporary_folder();

/// One program at a time in a folder. Held as long as it lives; the system releases it however the program
/// ends.
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
    [[maybe_unused]] int file_ = -1;  // of platforms that know locks
};

}  // namespace camopt

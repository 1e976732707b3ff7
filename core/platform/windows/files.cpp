// SPDX-License-Identifier: MIT
#include "core/platform/files.hpp"

#include "core/errors.hpp"

#include <cstdint>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace camopt {

long long process_number() {
    return static_cast<long long>(::GetCurrentProcessId());
}

bool process_has_ended(long long number) {
    const HANDLE process = ::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(number));
    if (process == nullptr) return ::GetLastError() == ERROR_INVALID_PARAMETER;
    const bool ended = ::WaitForSingleObject(process, 0) == WAIT_OBJECT_0;
    ::CloseHandle(process);
    return ended;
}

std::FILE* open_for_reading(const std::filesystem::path& path) {
    return ::_wfopen(path.c_str(), L"rb");
}

std::FILE* open_for_writing(const std::filesystem::path& path) {
    return ::_wfopen(path.c_str(), L"wb");
}

bool flush_to_disk(std::FILE* file) {
    return std::fflush(file) == 0 && ::_commit(::_fileno(file)) == 0;
}

// A folder cannot be locked; a file in it that no one else may open can, and it goes with its holder.
FolderLock::FolderLock(const std::filesystem::path& folder) {
    const std::filesystem::path name = folder / ".camopt.lock";
    const HANDLE held = ::CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS,
                                      FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    if (held != INVALID_HANDLE_VALUE)
        file_ = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(held), _O_RDONLY);
    else if (::GetLastError() == ERROR_SHARING_VIOLATION)
        throw InputError("another camopt is running in " + folder.string() +
                         "; wait for it, or take another folder");
}

void FolderLock::leave_to_parent() {
    if (file_ >= 0) ::_close(file_);
    file_ = -1;
}

}  // namespace camopt

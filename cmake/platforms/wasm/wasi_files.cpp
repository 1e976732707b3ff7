// SPDX-License-Identifier: MIT
// What of files is asked in a browser, where there are none: is it a folder? Everything that changes one is
// refused.
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM

file_status __status(const path& file, error_code* error) {
    struct ::stat found {};
    if (::stat(file.c_str(), &found) != 0) {
        if (error) *error = error_code(errno, generic_category());
        return file_status(errno == ENOENT ? file_type::not_found : file_type::none);
    }
    if (error) error->clear();
    return file_status(S_ISDIR(found.st_mode) ? file_type::directory : file_type::regular);
}

namespace {

/// Without a place for the reason the caller would throw; nothing here is called so.
void refuse(error_code* error) {
    if (error) *error = make_error_code(errc::function_not_supported);
}

}  // namespace

bool __create_directory(const path&, error_code* error) {
    refuse(error);
    return false;
}

bool __remove(const path&, error_code* error) {
    refuse(error);
    return false;
}

uintmax_t __remove_all(const path&, error_code* error) {
    refuse(error);
    return static_cast<uintmax_t>(-1);
}

void __rename(const path&, const path&, error_code* error) {
    refuse(error);
}

void __permissions(const path&, perms, perm_options, error_code* error) {
    refuse(error);
}

path __temp_directory_path(error_code* error) {
    refuse(error);
    return {};
}

_LIBCPP_END_NAMESPACE_FILESYSTEM

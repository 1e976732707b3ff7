// SPDX-License-Identifier: MIT
#include "core/platform/part_files.hpp"

#include "core/errors.hpp"

#include <dlfcn.h>
#include <link.h>

namespace camopt {

// The system's own list, as it is for this module: the program, or the shared library that holds camopt.
std::vector<std::filesystem::path> part_folders() {
    Dl_info unused{};
    void* module = nullptr;
    Dl_serinfo size{};
    if (::dladdr1(reinterpret_cast<void*>(&part_folders), &unused, &module, RTLD_DL_LINKMAP) == 0 ||
        ::dlinfo(module, RTLD_DI_SERINFOSIZE, &size) != 0)
        return {};
    const auto bytes = std::make_unique<std::max_align_t[]>(size.dls_size / sizeof(std::max_align_t) + 1);
    auto* const list = reinterpret_cast<Dl_serinfo*>(bytes.get());
    list->dls_size = size.dls_size;
    list->dls_cnt = size.dls_cnt;
    if (::dlinfo(module, RTLD_DI_SERINFO, list) != 0) return {};
    std::vector<std::filesystem::path> folders;
    const Dl_serpath* const first = &list->dls_serpath[0];
    for (unsigned int i = 0; i < list->dls_cnt; ++i)
        // What depends on the folder that the program is called in is no place for code.
        if (std::filesystem::path folder = first[i].dls_name; folder.is_absolute())
            folders.push_back(folder.lexically_normal() / "camopt");
    return folders;
}

std::string part_file_name(std::string_view part) {
    return "camopt_part_" + std::string(part) + ".so";
}

PartEntry open_part_file(const std::filesystem::path& file, const std::string& function) {
    void* const opened = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const entry = opened == nullptr ? nullptr : ::dlsym(opened, function.c_str());
    if (entry == nullptr) throw UnavailableError(std::string("cannot open a part of camopt: ") + ::dlerror());
    return reinterpret_cast<PartEntry>(entry);
}

}  // namespace camopt

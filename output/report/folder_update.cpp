// SPDX-License-Identifier: MIT
#include "output/report/folder_update.hpp"

#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "output/report/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <sys/types.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace camopt {

namespace {

constexpr const char* mark_text =
    "camopt was stopped while it wrote to this folder: it may contain files of two runs.\n"
    "Run the command again; this file is removed on success.\n";

void move_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error) throw InputError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

/// What is not there need not go.
void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) throw InputError(fmt::format("cannot remove {}: {}", path.string(), error.message()));
}

/// What killed runs left aside in this folder.
void remove_leftovers(const std::filesystem::path& folder) {
    constexpr std::string_view begin = ".camopt-", end = ".tmp";
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(begin) || !name.ends_with(end)) continue;
        const auto process =
            integer_in(std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size()));
        const bool gone = process && ::kill(static_cast<::pid_t>(*process), 0) != 0 && errno == ESRCH;
        if (gone) std::filesystem::remove_all(entry.path(), ignored);
    }
}

}  // namespace

FolderUpdate::FolderUpdate(std::filesystem::path folder)
    : folder_(std::move(folder)), aside_(folder_ / fmt::format(".camopt-{}.tmp", ::getpid())) {
    prepare_folder(folder_);
    remove_leftovers(folder_);
    std::error_code ignored;
    std::filesystem::remove_all(aside_, ignored);  // of a process of the same number, killed
    prepare_folder(aside_);
}

FolderUpdate::~FolderUpdate() {
    std::error_code ignored;
    std::filesystem::remove_all(aside_, ignored);
}

void FolderUpdate::write(const std::string& name, std::string_view text) {
    write_text_file(aside_ / name, text);
    add(name);
}

void FolderUpdate::add(const std::string& name) {
    if (std::ranges::find(names_, name) != names_.end())
        throw ModelError(fmt::format("two files of a result have the name {}", name));
    names_.push_back(name);
}

std::vector<std::filesystem::path> FolderUpdate::finish() {
    std::vector<std::filesystem::path> paths;
    if (names_.empty()) return paths;
    write_text_file(aside_ / incomplete_mark, mark_text);
    move_file(aside_ / incomplete_mark, folder_ / incomplete_mark);
    remove_file(folder_ / names_.back());
    for (const std::string& name : names_) {
        if (name != names_.back()) move_file(aside_ / name, folder_ / name);
        paths.push_back(folder_ / name);
    }
    for (const std::string& name : earlier_)
        if (std::ranges::find(names_, name) == names_.end()) remove_file(folder_ / name);
    move_file(aside_ / names_.back(), folder_ / names_.back());
    remove_file(folder_ / incomplete_mark);
    return paths;
}

}  // namespace camopt

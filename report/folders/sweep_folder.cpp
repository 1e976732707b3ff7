// SPDX-License-Identifier: MIT
#include "report/folders/sweep_folder.hpp"

#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/folders/result_folder.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt {

namespace {

namespace fs = std::filesystem;

constexpr const char* chunk_folder = "chunks";

fs::path description_in(const fs::path& path, const std::string& study) {
    return path / (study + ".json");
}

bool is_half_written(const fs::path& path) {
    return path.extension() == ".tmp";
}

}  // namespace

bool is_unused_sweep_folder(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) return true;
    if (!fs::is_directory(path, error)) return false;
    return std::all_of(fs::directory_iterator(path), fs::directory_iterator(),
                       [](const auto& entry) { return is_half_written(entry.path()); });
}

SweepFolder SweepFolder::create(const fs::path& path, const StoredSweep& sweep) {
    const fs::path file = description_in(path, sweep.identity.study);
    const bool grid = sweep.identity.is_grid();
    if (grid && !is_unused_sweep_folder(path)) {
        std::error_code error;
        if (fs::exists(file, error))
            throw InputError(
                fmt::format("{} holds a sweep already; allowed: --resume to continue it, or another "
                            "folder",
                            path.string()));
        throw InputError(
            fmt::format("{} is not empty and holds no sweep; allowed: a new or empty folder", path.string()));
    }
    prepare_folder(path);
    SweepFolder folder(path, sweep);
    if (!grid) fs::remove(folder.table_path());
    write_durable_text_file(file, sweep_json(sweep));
    if (grid) prepare_folder(path / chunk_folder);
    return folder;
}

bool SweepFolder::holds(const fs::path& path, const std::string& study) {
    std::error_code error;
    return fs::exists(description_in(path, study), error);
}

SweepFolder SweepFolder::open(const fs::path& path, const std::string& study) {
    const fs::path file = description_in(path, study);
    if (!holds(path, study))
        throw InputError(
            fmt::format("{} holds no {}: it has no {}", path.string(), study, file.filename().string()));
    SweepFolder folder(path, read_sweep_json(read_text_file(file), file.string(), study));
    if (folder.identity().is_grid())
        prepare_folder(path / chunk_folder);  // a run killed right after its start may not have made it
    return folder;
}

fs::path SweepFolder::chunk_path(int chunk) const {
    return path_ / chunk_folder / fmt::format("chunk_{:06}.csv", chunk);
}

std::vector<int> SweepFolder::chunks() const {
    std::vector<int> numbers;
    for (int chunk = 0; chunk < identity().chunking.count(); ++chunk)
        if (shard().holds(chunk)) numbers.push_back(chunk);
    return numbers;
}

bool SweepFolder::has_chunk(int chunk) const {
    std::error_code error;
    return fs::exists(chunk_path(chunk), error);
}

std::vector<int> SweepFolder::finished_chunks() const {
    std::vector<int> numbers = chunks();
    std::erase_if(numbers, [&](int chunk) { return !has_chunk(chunk); });
    return numbers;
}

std::vector<int> SweepFolder::missing_chunks() const {
    std::vector<int> numbers = chunks();
    std::erase_if(numbers, [&](int chunk) { return has_chunk(chunk); });
    return numbers;
}

void SweepFolder::write_chunk(int chunk, std::span<const SweepRow> rows) const {
    write_chunk_text(chunk, sweep_csv({identity().columns, {rows.begin(), rows.end()}}));
}

void SweepFolder::write_chunk_text(int chunk, const std::string& text) const {
    write_durable_text_file(chunk_path(chunk), text);
}

std::string SweepFolder::chunk_text(int chunk) const {
    return read_text_file(chunk_path(chunk));
}

std::vector<SweepRow> SweepFolder::read_chunk(int chunk) const {
    const std::string name = chunk_path(chunk).string();
    SweepTable table = read_sweep_csv(chunk_text(chunk), name);
    const RowRange range = identity().chunking.range(chunk);
    bool complete = table.columns.keys == identity().columns.keys &&
                    table.columns.dimensions == identity().columns.dimensions &&
                    static_cast<int>(table.rows.size()) == range.size();
    for (int i = 0; complete && i < range.size(); ++i) complete = table.rows[i].number == range.begin + i;
    if (!complete)
        throw InputError(
            fmt::format("{}: found other rows than {} to {} of this sweep; delete the file and "
                        "continue with --resume",
                        name, range.begin, range.end - 1));
    return std::move(table.rows);
}

/// What is no chunk belongs to the first shard.
bool SweepFolder::may_remove(const fs::path& file) const {
    const std::string name = file.filename().string();
    const std::string number = name.substr(0, name.find('.'));
    const std::optional<long long> chunk = integer_in(number.substr(number.rfind('_') + 1));
    return shard().holds(chunk ? static_cast<int>(*chunk) : 0);
}

int SweepFolder::remove_leftovers() const {
    std::vector<fs::path> half_written;
    for (const fs::path& folder : {path_, path_ / chunk_folder}) {
        if (!fs::exists(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder))
            if (is_half_written(entry.path()) && may_remove(entry.path()))
                half_written.push_back(entry.path());
    }
    std::error_code gone;
    for (const fs::path& file : half_written) fs::remove(file, gone);
    int damaged = 0;
    for (const int chunk : finished_chunks()) {
        try {
            (void)read_chunk(chunk);
        } catch (const InputError&) {
            fs::remove(chunk_path(chunk));
            ++damaged;
        }
    }
    return damaged;
}

SweepTable SweepFolder::table() const {
    SweepTable table{identity().columns, {}};
    for (const int chunk : finished_chunks())
        std::ranges::move(read_chunk(chunk), std::back_inserter(table.rows));
    return table;
}

std::vector<SweepRow> SweepFolder::written_rows() const {
    if (!fs::exists(table_path())) return {};
    return read_sweep_csv(read_text_file(table_path()), table_path().string()).rows;
}

void SweepFolder::write_rows(const SweepTable& so_far) const {
    write_durable_text_file(table_path(), sweep_csv(so_far));
}

SweepTable SweepFolder::write_table() const {
    SweepTable complete = table();
    mark_front(complete);
    write_rows(complete);
    return complete;
}

}  // namespace camopt

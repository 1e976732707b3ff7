// SPDX-License-Identifier: MIT
// The folder of a sweep: sweep.json (what it is), chunks/chunk_000012.csv (finished chunks), and at the end
// sweep.csv (all rows).
//
// Every file takes its name in one step when it is complete and on the disk, so whatever stands there under
// its name is whole: a run that was killed at any moment loses the chunks it was working on and nothing else.
// All functions throw InputError naming the folder or the file.
#pragma once

#include "report/json/sweep_json.hpp"

#include <filesystem>

namespace camopt {

class SweepFolder {
 public:
    /// Makes a folder for a new sweep. Refuses one that holds anything, but for what a killed start left.
    [[nodiscard]] static SweepFolder create(const std::filesystem::path& path, const StoredSweep& sweep);

    /// A folder that holds a sweep already.
    [[nodiscard]] static SweepFolder open(const std::filesystem::path& path);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const SweepIdentity& identity() const { return sweep_.identity; }
    [[nodiscard]] const SweepShard& shard() const { return sweep_.shard; }
    [[nodiscard]] std::filesystem::path table_path() const { return path_ / "sweep.csv"; }

    /// The numbers of the chunks of its shard, ascending; those of them that stand there; those that do not.
    [[nodiscard]] std::vector<int> chunks() const;
    [[nodiscard]] std::vector<int> finished_chunks() const;
    [[nodiscard]] std::vector<int> missing_chunks() const;

    void write_chunk(int chunk, std::span<const SweepRow> rows) const;
    /// Throws where its rows are not those of the chunk.
    [[nodiscard]] std::vector<SweepRow> read_chunk(int chunk) const;
    /// As it stands there.
    [[nodiscard]] std::string chunk_text(int chunk) const;
    void write_chunk_text(int chunk, const std::string& text) const;

    /// Removes what a killed run left half-written, and chunks that cannot be read back. Returns the number
    /// of the latter.
    [[nodiscard]] int remove_leftovers() const;

    /// The rows of its finished chunks, by number; no front is marked.
    [[nodiscard]] SweepTable table() const;
    /// The same with the Pareto front marked, as sweep.csv too.
    SweepTable write_table() const;

 private:
    SweepFolder(std::filesystem::path path, StoredSweep sweep)
        : path_(std::move(path)), sweep_(std::move(sweep)) {}
    [[nodiscard]] std::filesystem::path chunk_path(int chunk) const;

    std::filesystem::path path_;
    StoredSweep sweep_;
};

/// Whether there is no such folder, or one with nothing in it that a killed start would not leave.
[[nodiscard]] bool is_unused_sweep_folder(const std::filesystem::path& path);

}  // namespace camopt

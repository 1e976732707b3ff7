// SPDX-License-Identifier: MIT
// The folder of a study of many solves. sweep.json, pareto.json or surface.json says what it is, the table of
// the same name has its rows, the picture and the page of that name show them. The rows of a sweep stand in
// chunks/chunk_000012.csv until all are there; those of the others are one chain, whose table grows.
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
    /// Makes a folder for a new study. A sweep refuses one that holds anything, but for what a killed start
    /// left; a front and a surface begin anew.
    [[nodiscard]] static SweepFolder create(const std::filesystem::path& path, const StoredSweep& sweep);

    /// A folder that holds such a study already.
    [[nodiscard]] static SweepFolder open(const std::filesystem::path& path,
                                          const std::string& study = "sweep");
    [[nodiscard]] static bool holds(const std::filesystem::path& path, const std::string& study);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const SweepIdentity& identity() const { return sweep_.identity; }
    [[nodiscard]] const SweepShard& shard() const { return sweep_.shard; }
    [[nodiscard]] std::filesystem::path table_path() const { return path_ / (identity().study + ".csv"); }

    /// The numbers of the chunks of its shard, ascending; those of them that stand there; those that do not.
    [[nodiscard]] std::vector<int> chunks() const;
    [[nodiscard]] std::vector<int> finished_chunks() const;
    [[nodiscard]] std::vector<int> missing_chunks() const;

    [[nodiscard]] bool has_chunk(int chunk) const;
    /// The same folder, in which others solve the other chunks meanwhile.
    [[nodiscard]] SweepFolder part(const SweepShard& share) const { return {path_, {identity(), share}}; }

    void write_chunk(int chunk, std::span<const SweepRow> rows) const;
    /// Throws where its rows are not those of the chunk.
    [[nodiscard]] std::vector<SweepRow> read_chunk(int chunk) const;
    /// As it stands there.
    [[nodiscard]] std::string chunk_text(int chunk) const;
    void write_chunk_text(int chunk, const std::string& text) const;

    /// Of its shard: removes what a killed run left half-written, and chunks that cannot be read back.
    /// Returns the number of the latter.
    [[nodiscard]] int remove_leftovers() const;

    /// The rows of a chain so far.
    [[nodiscard]] std::vector<SweepRow> written_rows() const;
    void write_rows(const SweepTable& so_far) const;

    /// The rows of its finished chunks, by number; no front is marked.
    [[nodiscard]] SweepTable table() const;
    /// The same with the Pareto front marked, as sweep.csv too.
    SweepTable write_table() const;

 private:
    SweepFolder(std::filesystem::path path, StoredSweep sweep)
        : path_(std::move(path)), sweep_(std::move(sweep)) {}
    [[nodiscard]] std::filesystem::path chunk_path(int chunk) const;
    [[nodiscard]] bool may_remove(const std::filesystem::path& half_written) const;

    std::filesystem::path path_;
    StoredSweep sweep_;
};

/// Whether there is no such folder, or one with nothing in it that a killed start would not leave.
[[nodiscard]] bool is_unused_sweep_folder(const std::filesystem::path& path);

}  // namespace camopt

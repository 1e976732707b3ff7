// SPDX-License-Identifier: MIT
// The folder of a sweep: what it refuses, what it finds again, what it tells.
#include "report/folders/sweep_folder.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/document/document_text.hpp"
#include "report/sweep/sweep_document.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace camopt {
namespace sweep_folder_test {

using testing_support::refusal;
using testing_support::says;

using test::TemporaryFolder;

StoredSweep sample_sweep() {
    StoredSweep sweep;
    sweep.identity = {"0.1.0",
                      "s.toml",
                      "text\n\"quoted\" µ\n",
                      {"spline.segments=8"},
                      {"--weights simplex:3"},
                      "0123456789abcdef",
                      {},
                      {10, 4}};
    sweep.identity.columns = {.keys = {"objective.velocity"},
                              .dimensions = {DimensionIndex::base_radius},
                              .train = true,
                              .criteria = {"velocity", "jerk"}};
    return sweep;
}

std::vector<SweepRow> rows(int begin, int end) {
    std::vector<SweepRow> all;
    for (int number = begin; number < end; ++number) {
        SweepRow row;
        row.number = number;
        row.settings = {0.1 * number};
        row.verdict = Verdict::optimal;
        row.objective = 2.0 - 0.1 * number;
        row.figures[0] = 1.0 + number;
        row.figures[2] = 10.0 - number;
        all.push_back(row);
    }
    return all;
}

TEST(SweepJson, ReadsBackTheSame) {
    StoredSweep sweep = sample_sweep();
    sweep.shard = {2, 3};
    const StoredSweep read = read_sweep_json(sweep_json(sweep), "sweep.json");
    EXPECT_EQ(difference(read.identity, sweep.identity), "");
    EXPECT_EQ(read.identity.scene_file, "s.toml");
    EXPECT_EQ(read.identity.axes, sweep.identity.axes);
    EXPECT_EQ(read.identity.columns.dimensions, sweep.identity.columns.dimensions);
    EXPECT_TRUE(read.identity.columns.train);
    EXPECT_EQ(read.identity.columns.criteria, sweep.identity.columns.criteria);
    EXPECT_EQ(read.shard.index, 2);
    EXPECT_EQ(read.shard.count, 3);
    const auto refused = [](const std::string& text) {
        return refusal([&] { (void)read_sweep_json(text, "x"); });
    };
    for (const char* text : {"", "{"}) EXPECT_TRUE(says(refused(text), "x: found no JSON")) << text;
    EXPECT_EQ(refused("[]"), "x: found a list of 0; allowed: an object");
    EXPECT_EQ(refused("{}"),
              "x: camopt: found no such key; allowed: a description of a sweep as camopt writes it");
    EXPECT_EQ(refused("{\"camopt\": 3}"), "x: camopt: found 3; allowed: a text");
    sweep.shard = {4, 3};
    EXPECT_EQ(refused(sweep_json(sweep)), "x: shard.index: found 4; allowed: 1 to 3");
    sweep.identity.chunking.size = 0;
    EXPECT_TRUE(says(refused(sweep_json(sweep)), "x: chunk: found 0; allowed: 1 to "));
}

TEST(SweepJson, ReportsDifferencesOfSweeps) {
    const SweepIdentity one = sample_sweep().identity;
    const auto with = [&](const std::function<void(SweepIdentity&)>& change) {
        SweepIdentity other = one;
        change(other);
        return difference(one, other);
    };
    EXPECT_EQ(with([](SweepIdentity& i) { i.scene_file = "elsewhere/s.toml"; }), "");
    EXPECT_EQ(with([](SweepIdentity& i) { i.version = "0.2.0"; }), "camopt 0.1.0, not 0.2.0");
    EXPECT_EQ(with([](SweepIdentity& i) { i.scene_text += "#"; }), "another scene");
    EXPECT_TRUE(says(with([](SweepIdentity& i) { i.settings.clear(); }), "settings"));
    EXPECT_TRUE(says(with([](SweepIdentity& i) { i.columns.keys = {"a"}; }), "keys"));
    EXPECT_TRUE(says(with([](SweepIdentity& i) { i.plan = "0"; }), "values"));
    EXPECT_EQ(with([](SweepIdentity& i) { i.chunking.rows = 11; }), "10 rows, not 11");
    EXPECT_EQ(with([](SweepIdentity& i) { i.chunking.size = 5; }), "chunks of 4 rows, not 5");
}

TEST(SweepFolder, KeepsChunksAndMakesTheTable) {
    const TemporaryFolder temporary;
    const std::string path = temporary.path() + "/new/sweep";
    EXPECT_TRUE(is_unused_sweep_folder(path));
    const SweepFolder folder = SweepFolder::create(path, sample_sweep());
    EXPECT_FALSE(is_unused_sweep_folder(path));
    EXPECT_EQ(folder.chunks(), (std::vector{0, 1, 2}));
    folder.write_chunk(2, rows(8, 10));
    folder.write_chunk(0, rows(0, 4));
    const SweepFolder again = SweepFolder::open(path);
    EXPECT_EQ(again.finished_chunks(), (std::vector{0, 2}));
    EXPECT_EQ(again.missing_chunks(), std::vector{1});
    again.write_chunk(1, rows(4, 8));
    const SweepTable table = again.write_table();
    ASSERT_EQ(table.rows.size(), 10U);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(table.rows[static_cast<std::size_t>(i)].number, i);
    EXPECT_TRUE(table.rows[3].on_front);  // V rises and J falls with the number: all are
    EXPECT_EQ(read_text_file(path + "/sweep.csv"), sweep_csv(table));
    const std::string text = console_text(sweep_summary(table));
    EXPECT_TRUE(says(text, "Rows: 10 (10 optimal)"));
    EXPECT_TRUE(says(text, "Pareto front: 10 rows, weighing velocity, jerk"));
    EXPECT_TRUE(says(text, "Least objective: 1.1 in row 9 (objective.velocity 0.9)"));
}

TEST(SweepFolder, AShardHoldsEveryNthChunk) {
    const TemporaryFolder temporary;
    StoredSweep sweep = sample_sweep();
    sweep.shard = {2, 2};
    EXPECT_EQ(SweepFolder::create(temporary.path() + "/2", sweep).chunks(), std::vector{1});
    sweep.shard = {1, 2};
    EXPECT_EQ(SweepFolder::create(temporary.path() + "/1", sweep).chunks(), (std::vector{0, 2}));
}

TEST(SweepFolder, RefusesFolderInUse) {
    const TemporaryFolder temporary;
    const std::string other = temporary.path() + "/other", sweep = temporary.path() + "/sweep";
    std::filesystem::create_directories(other);
    write_text_file(other + "/letter.txt", "dear\n");
    const auto create = [&](const std::string& path) {
        return refusal([&] { (void)SweepFolder::create(path, sample_sweep()); });
    };
    EXPECT_TRUE(says(create(other), "is not empty and holds no sweep"));
    EXPECT_EQ(read_text_file(other + "/letter.txt"), "dear\n");
    EXPECT_TRUE(says(create(other + "/letter.txt"), "allowed: a new or empty folder"));
    EXPECT_EQ(create(sweep), "no refusal");
    EXPECT_TRUE(says(create(sweep), "holds a sweep already; allowed: --resume"));
    EXPECT_TRUE(says(refusal([&] { (void)SweepFolder::open(other); }), "holds no sweep"));
    EXPECT_TRUE(says(refusal([&] { (void)SweepFolder::open(other + "/none"); }), "holds no sweep"));
}

TEST(SweepFolder, IgnoresRemainsOfKilledRuns) {
    const TemporaryFolder temporary;
    write_text_file(temporary.path() + "/sweep.json.77.tmp", "{ \"camo");
    const SweepFolder folder = SweepFolder::create(temporary.path(), sample_sweep());
    folder.write_chunk(0, rows(0, 4));
    write_text_file(temporary.path() + "/chunks/chunk_000001.csv.77.tmp", "row,obj");
    write_text_file(temporary.path() + "/chunks/chunk_000001.csv", "row,obj");             // damaged
    write_text_file(temporary.path() + "/chunks/chunk_000002.csv", folder.chunk_text(0));  // another's rows
    EXPECT_EQ(folder.remove_leftovers(), 2);
    EXPECT_EQ(folder.finished_chunks(), std::vector{0});
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(temporary.path()))
        files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 2);  // sweep.json and chunk 0
}

/// A front or a surface: one table that grows, and a new run begins anew.
TEST(SweepFolder, AChainKeepsItsGrowingTable) {
    const TemporaryFolder temporary;
    StoredSweep sweep = sample_sweep();
    sweep.identity.study = "pareto";
    sweep.identity.axes = {"--pareto velocity,jerk"};
    const SweepFolder folder = SweepFolder::create(temporary.path(), sweep);
    EXPECT_TRUE(folder.written_rows().empty());
    SweepTable table;
    table.rows = rows(0, 3);
    table.columns.keys = {"objective.velocity"};
    table.columns.front = true;
    table.rows[1].settings = {std::numeric_limits<double>::quiet_NaN()};
    table.rows[1].front = {
        .point = 1, .arc = 0.5, .weighted = {}, .limit_first = 1.5, .limit_second = 6, .end = "cut_off"};
    folder.write_rows(table);
    const SweepFolder again = SweepFolder::open(temporary.path(), "pareto");
    EXPECT_EQ(difference(again.identity(), sweep.identity), "");
    const std::vector<SweepRow> read = again.written_rows();
    ASSERT_EQ(read.size(), 3U);
    EXPECT_TRUE(std::isnan(read[1].settings[0]));
    EXPECT_EQ(read[1].front.end, "cut_off");
    EXPECT_EQ(read[1].front.limit_second, 6.0);
    EXPECT_EQ(read[2].settings, table.rows[2].settings);
    sweep.identity.axes = {"--pareto velocity,acceleration"};
    EXPECT_TRUE(says(difference(again.identity(), sweep.identity), "goals"));
    EXPECT_TRUE(SweepFolder::create(temporary.path(), sweep).written_rows().empty());
    EXPECT_TRUE(
        says(refusal([&] { (void)SweepFolder::open(temporary.path(), "surface"); }), "holds no surface"));
}

}  // namespace sweep_folder_test
}  // namespace camopt

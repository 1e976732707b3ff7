// SPDX-License-Identifier: MIT
// camopt sweep from outside: what is solved, interrupted, continued and joined.
#include "core/text/text_file.hpp"
#include "core/units.hpp"
#include "program.hpp"
#include "report/csv/sweep_csv.hpp"
#include "sweep_run_of_program.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace camopt {
namespace sweep_test {

using test::chunk_count;
using test::ProgramRun;
using test::run_camopt;
using test::RunningProgram;
using test::TemporaryFolder;
using test::timeless_rows;
using testing_support::says;

using Words = std::vector<std::string>;

std::string scene_file(const char* name) {
    return source_folder() + "/scenes/" + name + ".toml";
}

Words operator+(Words one, const Words& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

/// 66 rows in 11 chunks, some milliseconds a row.
Words small_sweep(const std::string& out) {
    return {"sweep", scene_file("drd_cubic_12"), "--weights", "simplex:10", "--chunk", "6", "--out", out};
}

int run_sweep(const Words& words, const std::string& log) {
    return RunningProgram(words, log).wait();
}

/// Waits until it holds, or half a minute. False: it never did.
bool wait_for(const std::function<bool()>& condition) {
    for (int i = 0; i < 30'000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return condition();
}

class SweepCommand : public testing::Test {
 protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    [[nodiscard]] std::string errors(const std::string& name) const {
        return read_text_file(path(name) + ".err");
    }
    [[nodiscard]] std::string output(const std::string& name) const {
        return read_text_file(path(name) + ".out");
    }

 private:
    TemporaryFolder folder_;
};

TEST_F(SweepCommand, SolvesAndReportsEveryWeight) {
    ASSERT_EQ(run_sweep(small_sweep(path("map")), path("map")), 0) << errors("map");
    EXPECT_EQ(errors("map"), "");
    const SweepTable table = read_sweep_csv(read_text_file(path("map") + "/sweep.csv"), "sweep.csv");
    ASSERT_EQ(table.rows.size(), 66U);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const SweepRow& row = table.rows[i];
        EXPECT_EQ(row.number, static_cast<int>(i));
        EXPECT_EQ(row.verdict, Verdict::optimal) << i << " " << row.reason;
        EXPECT_NEAR(row.settings[0] + row.settings[1] + row.settings[2], 1.0, 1e-12);
        ASSERT_TRUE(row.objective && row.lower_bound && row.any_curve_limit);
        EXPECT_LE(*row.lower_bound, *row.objective + 1e-9);
        EXPECT_GE(*row.objective, *row.any_curve_limit - 1e-7);
    }
}

/// A row's folder is a result folder as any other.
TEST_F(SweepCommand, KeepsResultFolderForEveryRow) {
    const Words words = {"sweep",     scene_file("drd_cubic_12"),
                         "--weights", "simplex:4",
                         "--chunk",   "15",
                         "--out",     path("map"),
                         "--results"};
    ASSERT_EQ(run_sweep(words, path("map")), 0) << errors("map");
    const SweepTable table = read_sweep_csv(read_text_file(path("map") + "/sweep.csv"), "sweep.csv");
    ASSERT_EQ(table.rows.size(), 15U);
    EXPECT_TRUE(
        std::ranges::any_of(table.rows, [](const SweepRow& row) { return row.proved_from.has_value(); }));
    for (const SweepRow& row : table.rows) {
        const std::string folder = path("map") + fmt::format("/rows/{:06}", row.number);
        ASSERT_EQ(run_sweep({"report", folder}, path("log")), 0) << errors("log");  // reads and checks it
        const std::string certificate = read_text_file(folder + "/certificate.json");
        EXPECT_TRUE(says(certificate, "optimal"));
    }
}

TEST_F(SweepCommand, GridWithInfeasibleRowsSucceeds) {
    ASSERT_EQ(run_sweep({"sweep", scene_file("drd_cubic_12"), "--vary", "limits.velocity=0.9,1.6,2", "--vary",
                         "spline.segments=8:16:2", "--set", "objective.jerk=0.3", "--out", path("grid")},
                        path("grid")),
              0)
        << errors("grid");
    const SweepTable table = read_sweep_csv(read_text_file(path("grid") + "/sweep.csv"), "sweep.csv");
    ASSERT_EQ(table.rows.size(), 6U);
    EXPECT_EQ(table.columns.keys, (Words{"limits.velocity", "spline.segments"}));
    for (const SweepRow& row : table.rows)
        EXPECT_EQ(row.verdict, row.settings[0] < 1.0 ? Verdict::infeasible : Verdict::optimal) << row.number;
    EXPECT_EQ(table.rows[2].active_limits, Words{"limits.velocity"});
    // The same as `camopt solve` with these keys.
    const ProgramRun run =
        run_camopt("solve '" + scene_file("drd_cubic_12") +
                   "' --set limits.velocity=1.6 spline.segments=16 objective.jerk=0.3 --json");
    const std::size_t at = run.output.find("\"objective\": ");
    ASSERT_NE(at, std::string::npos) << run.output;
    EXPECT_EQ(table.rows[2].settings, (std::vector{1.6, 16.0}));
    EXPECT_NEAR(*table.rows[2].objective, std::stod(run.output.substr(at + 13)), 1e-8);
}

/// Keys of the machine file and of the scene of an axis; by workers, in parts, and as `camopt machine` says.
TEST_F(SweepCommand, MachinesAreSweptLikeScenes) {
    const std::string machine = scene_file("machines/cartoner");
    const Words words = {"sweep",  machine,
                         "--set",  "machine.speed_rpm={min=150,max=200}",
                         "--vary", "pusher.limits.acceleration_m_s2=40,60",
                         "--out"};
    ASSERT_EQ(run_sweep(words + Words{path("whole"), "--results"}, path("whole")), 0) << errors("whole");
    const SweepTable table = read_sweep_csv(read_text_file(path("whole") + "/sweep.csv"), "sweep.csv");
    EXPECT_TRUE(table.columns.machine);
    ASSERT_EQ(table.rows.size(), 2U);
    for (const SweepRow& row : table.rows) {
        EXPECT_EQ(row.verdict, Verdict::optimal) << row.reason;
        ASSERT_TRUE(row.machine.speed && row.machine.impossible_above);
        EXPECT_LE(*row.machine.impossible_above, *row.machine.speed * 1.0011);
        EXPECT_FALSE(row.active_limits.empty());
    }
    EXPECT_GT(*table.rows[1].machine.speed, *table.rows[0].machine.impossible_above);
    EXPECT_EQ(table.rows[0].active_limits.front().substr(0, 9), "clearance");
    // The folder of a row is that of camopt machine, and a machine again.
    const std::string row = path("whole") + "/rows/000000/";
    EXPECT_TRUE(says(read_text_file(row + "pusher.toml"), "acceleration_m_s2 = 40"));
    ASSERT_EQ(run_sweep({"machine", row + "machine.toml", "--json"}, path("again")), 0) << errors("again");
    const std::string text = output("again");
    const double again = std::stod(text.substr(text.find("\"speed_rpm\": ") + 13));
    EXPECT_NEAR(*table.rows[0].machine.speed / units::revolution_per_minute, again, 1e-6 * again);
    for (const char* part : {"1/2", "2/2"})
        ASSERT_EQ(
            run_sweep(words + Words{path("part" + std::string(part, 1)), "--shard", part, "--workers", "1"},
                      path("log")),
            0)
            << errors("log");
    ASSERT_EQ(
        run_sweep({"sweep", "merge", path("part1"), path("part2"), "--out", path("merged")}, path("log")), 0)
        << errors("log");
    EXPECT_EQ(timeless_rows(path("merged")), timeless_rows(path("whole")));
}

TEST_F(SweepCommand, WorkersAndShardsMakeNoDifference) {
    const auto sweep = [&](const std::string& name, const Words& more) {
        EXPECT_EQ(run_sweep(small_sweep(path(name)) + more, path(name)), 0) << errors(name);
    };
    sweep("one", {"--workers", "1"});
    sweep("two", {"--workers", "2"});
    sweep("part1", {"--shard", "1/2", "--workers", "2"});
    sweep("part2", {"--shard", "2/2", "--workers", "1"});
    const std::vector<std::string> expected = timeless_rows(path("one"));
    EXPECT_EQ(expected.size(), 67U);
    EXPECT_EQ(timeless_rows(path("two")), expected);
    EXPECT_FALSE(std::filesystem::exists(path("part1") + "/sweep.csv"));  // a part knows no front
    ASSERT_EQ(
        run_sweep({"sweep", "merge", path("part2"), path("part1"), "--out", path("whole")}, path("log")), 0)
        << errors("log");
    EXPECT_EQ(timeless_rows(path("whole")), expected);
    EXPECT_EQ(run_sweep(small_sweep(path("whole")) + Words{"--resume"}, path("log")), 0) << errors("log");
    EXPECT_EQ(timeless_rows(path("whole")), expected);
}

TEST_F(SweepCommand, MergeRefusesUnfinishedShards) {
    for (const char* part : {"1", "2"})
        EXPECT_EQ(
            run_sweep(small_sweep(path(part)) + Words{"--shard", part + std::string("/2")}, path("log")), 0)
            << errors("log");
    std::filesystem::remove(path("2") + "/chunks/chunk_000003.csv");
    EXPECT_EQ(run_sweep({"sweep", "merge", path("1"), path("2"), "--out", path("whole")}, path("log")), 2);
    EXPECT_FALSE(std::filesystem::exists(path("whole")));
    EXPECT_TRUE(says(errors("log"), "rows 18 to 23 are missing: " + path("2") + " is not finished"));
}

/// 231 rows in 58 chunks: long enough to be interrupted in the middle.
Words longer_sweep(const std::string& out) {
    return {"sweep", scene_file("drd_cubic_12"), "--weights", "simplex:20", "--chunk", "4",
            "--set", "spline.segments=32",       "--workers", "2",          "--out",   out};
}

constexpr int longer_chunks = 58;

TEST_F(SweepCommand, TwentyKillsChangeNoResult) {
    ASSERT_EQ(run_sweep(longer_sweep(path("whole")), path("log")), 0) << errors("log");
    const std::vector<std::string> expected = timeless_rows(path("whole"));
    std::mt19937 generator(4);
    std::uniform_int_distribution<int> moment(0, longer_chunks * 2 / 3);
    std::uniform_int_distribution<int> microseconds(0, 4000);
    constexpr int kills = 20;
    int in_the_middle = 0;
    for (int i = 0; i < kills; ++i) {
        SCOPED_TRACE(i);
        const std::string name = path(std::to_string(i));
        const int enough = moment(generator);
        RunningProgram program(longer_sweep(name), path("log"));
        EXPECT_TRUE(wait_for([&] { return chunk_count(name) >= enough || !program.runs(); }));
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds(generator)));
        program.send(SIGKILL);
        const bool killed = program.wait() == 128 + SIGKILL;
        const bool unfinished = !std::filesystem::exists(name + "/sweep.csv");
        if (killed && unfinished && chunk_count(name) < longer_chunks) ++in_the_middle;
        ASSERT_EQ(run_sweep(longer_sweep(name) + Words{"--resume"}, path("log")), 0) << errors("log");
        EXPECT_EQ(timeless_rows(name), expected);
    }
    EXPECT_GE(in_the_middle, kills * 3 / 4);
}

TEST_F(SweepCommand, InterruptKeepsResultsAndSuggestsResume) {
    ASSERT_EQ(run_sweep(longer_sweep(path("whole")), path("log")), 0) << errors("log");
    RunningProgram program(longer_sweep(path("map")), path("log"));
    ASSERT_TRUE(wait_for([&] { return chunk_count(path("map")) >= 3; }));
    const std::vector<pid_t> workers = program.children();
    EXPECT_EQ(workers.size(), 1U);  // of two threads
    program.send(SIGINT);
    EXPECT_EQ(program.wait(), 130);
    for (const pid_t worker : workers) EXPECT_NE(::kill(worker, 0), 0) << "a worker lives on";
    EXPECT_TRUE(says(errors("log"), "interrupted; "));
    EXPECT_TRUE(says(errors("log"), "of 58 chunks are finished and kept in"));
    EXPECT_TRUE(says(errors("log"), "--resume goes on"));
    EXPECT_EQ(output("log"), "");
    EXPECT_FALSE(std::filesystem::exists(path("map") + "/sweep.csv"));
    const int kept = chunk_count(path("map"));
    EXPECT_GE(kept, 3);
    EXPECT_LT(kept, longer_chunks);
    // Chunk 0 may be the one that a slow worker still had.
    std::filesystem::path one;
    for (const auto& entry : std::filesystem::directory_iterator(path("map") + "/chunks"))
        if (entry.path().extension() == ".csv") one = entry.path();
    const auto first = std::filesystem::last_write_time(one);
    ASSERT_EQ(run_sweep(longer_sweep(path("map")) + Words{"--resume"}, path("log")), 0) << errors("log");
    EXPECT_EQ(timeless_rows(path("map")), timeless_rows(path("whole")));
    EXPECT_EQ(std::filesystem::last_write_time(one), first);
}

TEST_F(SweepCommand, TerminationKeepsWhatIsFinishedToo) {
    ASSERT_EQ(run_sweep(longer_sweep(path("whole")), path("log")), 0) << errors("log");
    RunningProgram program(longer_sweep(path("map")), path("log"));
    ASSERT_TRUE(wait_for([&] { return chunk_count(path("map")) >= 3; }));
    for (const pid_t worker : program.children()) ::kill(worker, SIGTERM);  // as schedulers do
    program.send(SIGTERM);
    EXPECT_EQ(program.wait(), 130);
    EXPECT_TRUE(says(errors("log"), "interrupted; "));
    ASSERT_EQ(run_sweep(longer_sweep(path("map")) + Words{"--resume"}, path("log")), 0) << errors("log");
    EXPECT_EQ(timeless_rows(path("map")), timeless_rows(path("whole")));
}

TEST_F(SweepCommand, AKilledWorkerCostsNothing) {
    ASSERT_EQ(run_sweep(longer_sweep(path("whole")), path("log")), 0) << errors("log");
    RunningProgram program(longer_sweep(path("map")), path("log"));
    ASSERT_TRUE(wait_for([&] { return chunk_count(path("map")) >= 3; }));
    int killed = 0;
    for (const pid_t worker : program.children()) killed += ::kill(worker, SIGKILL) == 0 ? 1 : 0;
    EXPECT_EQ(killed, 1);
    EXPECT_EQ(program.wait(), 0) << errors("log");
    EXPECT_EQ(timeless_rows(path("map")), timeless_rows(path("whole")));
}

/// One row that takes longer than the test has patience for.
Words endless_sweep(const std::string& out) {
    return {"sweep",     scene_file("drd_cubic_12"),
            "--vary",    "spline.segments=12,60000",
            "--chunk",   "1",
            "--workers", "1",
            "--out",     out};
}

TEST_F(SweepCommand, RowKillingTwoWorkersFailsAlone) {
    RunningProgram program(endless_sweep(path("map")), path("log"));
    ASSERT_TRUE(wait_for([&] { return chunk_count(path("map")) >= 1; }));
    pid_t before = 0;
    for (int i = 0; i < 3; ++i) {  // in company, then twice alone
        std::vector<pid_t> workers;
        ASSERT_TRUE(wait_for([&] {
            workers = program.children();
            return workers.size() == 1 && workers[0] != before;
        }));
        before = workers[0];
        std::this_thread::sleep_for(std::chrono::milliseconds(150));  // until it has been given its chunk
        ASSERT_EQ(::kill(before, SIGSEGV), 0);
    }
    EXPECT_EQ(program.wait(), 1);
    const SweepTable table = read_sweep_csv(read_text_file(path("map") + "/sweep.csv"), "sweep.csv");
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].verdict, Verdict::optimal);
    EXPECT_EQ(table.rows[1].verdict, Verdict::failed);
    EXPECT_EQ(table.rows[1].reason, "worker died: signal 11");
    EXPECT_FALSE(table.rows[1].objective);
    EXPECT_TRUE(says(output("log"), "Failed, worker died: signal 11: 1 row"));
}

TEST_F(SweepCommand, ProgramsShareNoFolder) {
    RunningProgram program(endless_sweep(path("map")), path("first"));
    ASSERT_TRUE(wait_for([&] { return chunk_count(path("map")) >= 1; }));
    EXPECT_EQ(run_sweep(endless_sweep(path("map")) + Words{"--resume"}, path("log")), 2);
    EXPECT_TRUE(says(errors("log"), "another camopt is running in"));
}

/// Neither linear nor convex: searches from several seeded starts.
Words general_sweep(const std::string& out) {
    return {"sweep",
            scene_file("cam_undercut"),
            "--set",
            "spline.segments=6",
            "solver.starts=2",
            "--vary",
            "cam.base_radius_mm=11,13,15",
            "--weights",
            "simplex:1",
            "--chunk",
            "2",
            "--out",
            out};
}

TEST_F(SweepCommand, NonconvexScenesAreRepeatable) {
    ASSERT_EQ(run_sweep(general_sweep(path("one")) + Words{"--workers", "1"}, path("log")), 0)
        << errors("log");
    ASSERT_EQ(run_sweep(general_sweep(path("two")) + Words{"--workers", "2"}, path("log")), 0)
        << errors("log");
    const std::vector<std::string> expected = timeless_rows(path("one"));
    EXPECT_EQ(timeless_rows(path("two")), expected);
    RunningProgram program(general_sweep(path("killed")), path("log"));
    EXPECT_TRUE(wait_for([&] { return chunk_count(path("killed")) >= 2 || !program.runs(); }));
    program.send(SIGKILL);
    (void)program.wait();
    EXPECT_FALSE(std::filesystem::exists(path("killed") + "/sweep.csv"));  // it was killed in the middle
    ASSERT_EQ(run_sweep(general_sweep(path("killed")) + Words{"--resume"}, path("log")), 0) << errors("log");
    EXPECT_EQ(timeless_rows(path("killed")), expected);
}

}  // namespace sweep_test
}  // namespace camopt

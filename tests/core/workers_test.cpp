// SPDX-License-Identifier: MIT
// The executor: everything is done once, crashes cost one unit, no child outlives the parent.
#include "core/platform/workers.hpp"

#include "core/errors.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <poll.h>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace camopt {
namespace workers_test {

using test::TemporaryFolder;

std::vector<int> units(int count) {
    std::vector<int> all;
    for (int i = 0; i < count; ++i) all.push_back(i);
    return all;
}

bool no_child_is_left() {
    return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

/// The pool's task with everything the parent heard.
struct Heard {
    std::map<int, int> told;
    std::map<int, std::string> lost;

    PoolTask task(int count, int workers) {
        PoolTask task;
        task.units = units(count);
        task.workers = workers;
        task.fence = Fence::around_each;
        task.work = [](int unit, const std::function<void(int)>& tell) { tell(unit); };
        task.told = [this](int number) { ++told[number]; };
        task.lost = [this](int unit, const std::string& reason) { lost[unit] = reason; };
        return task;
    }
};

TEST(WorkerPool, DoesEveryUnitExactlyOnce) {
    for (const Fence fence : {Fence::none, Fence::around_all, Fence::around_each})
        for (const int workers : {1, 2, 5, 40}) {
            SCOPED_TRACE(workers);
            Heard heard;
            PoolTask task = heard.task(30, workers);
            task.fence = fence;
            EXPECT_EQ(run_workers(task), PoolOutcome::finished);
            EXPECT_EQ(heard.told.size(), 30U);
            for (const auto& [unit, times] : heard.told) EXPECT_EQ(times, 1) << unit;
            EXPECT_TRUE(heard.lost.empty());
            EXPECT_TRUE(no_child_is_left());
            task.units.clear();
            EXPECT_EQ(run_workers(task), PoolOutcome::finished);
        }
}

TEST(WorkerPool, UnitOfDeadWorkerIsRedone) {
    const TemporaryFolder folder;
    Heard heard;
    PoolTask task = heard.task(12, 2);
    task.work = [&](int unit, const std::function<void(int)>& tell) {
        const std::string mark = folder.path() + "/" + std::to_string(unit);
        if (unit % 3 == 0 && !std::filesystem::exists(mark)) {
            std::ofstream(mark) << "tried";
            std::raise(SIGKILL);
        }
        tell(unit);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 12U);
    EXPECT_TRUE(heard.lost.empty());
}

/// By the signal itself, whatever a sanitizer makes of it.
void crash() {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
}

TEST(WorkerPool, UnitKillingTwoWorkersIsLost) {
    Heard heard;
    PoolTask task = heard.task(10, 3);
    task.work = [](int unit, const std::function<void(int)>& tell) {
        if (unit == 2) std::raise(SIGTERM);  // the parent decides
        if (unit == 4) crash();
        if (unit == 7) std::raise(SIGKILL);
        if (unit == 8) ::_exit(3);
        tell(unit);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 7U);
    EXPECT_EQ(heard.lost, (std::map<int, std::string>{{4, "worker died: signal 11"},
                                                      {7, "worker died: signal 9"},
                                                      {8, "worker died: exit code 3"}}));
    EXPECT_TRUE(no_child_is_left());
}

/// Done or not, no thread of the one child is left; the rest goes on, each alone.
TEST(WorkerPool, CrashOfThreadsLeavesOthersUnharmed) {
    const TemporaryFolder folder;
    const std::string mark = folder.path() + "/tried";
    Heard heard;
    PoolTask task = heard.task(12, 3);
    task.fence = Fence::around_all;
    task.work = [&](int unit, const std::function<void(int)>& tell) {
        if (unit == 4) crash();
        if (unit == 7 && !std::filesystem::exists(mark)) {
            std::ofstream(mark) << "tried";
            std::raise(SIGKILL);
        }
        tell(unit);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 11U);
    EXPECT_EQ(heard.lost, (std::map<int, std::string>{{4, "worker died: signal 11"}}));
    EXPECT_TRUE(no_child_is_left());
}

TEST(WorkerPool, ThreadsShareMemoryAndThrow) {
    std::set<std::thread::id> threads;
    std::mutex mutex;
    Heard heard;
    PoolTask task = heard.task(40, 2);
    task.fence = Fence::none;
    task.work = [&](int unit, const std::function<void(int)>& tell) {
        const std::lock_guard lock(mutex);
        threads.insert(std::this_thread::get_id());
        tell(unit);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 40U);
    EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
    EXPECT_LE(threads.size(), 2U);
    task.work = [](int, const std::function<void(int)>&) { throw std::logic_error("own kind"); };
    EXPECT_THROW((void)run_workers(task), std::logic_error);
    task.units = units(10'000);
    task.stop_requested = [] { return true; };
    task.work = [&](int, const std::function<void(int)>&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::stopped);
}

TEST(WorkerPool, ExceptionsEndRunWithTheirMessage) {
    Heard heard;
    PoolTask task = heard.task(10, 2);
    task.work = [](int unit, const std::function<void(int)>&) {
        if (unit == 3) throw InputError("cannot write: the disk is full");
    };
    EXPECT_EQ(testing_support::refusal([&] { (void)run_workers(task); }), "cannot write: the disk is full");
    EXPECT_TRUE(no_child_is_left());
    task.work = [](int, const std::function<void(int)>&) { throw std::logic_error(std::string(9000, 'x')); };
    EXPECT_THROW((void)run_workers(task), std::runtime_error);
    EXPECT_TRUE(no_child_is_left());
}

TEST(WorkerPool, StopsImmediatelyWithoutOrphans) {
    for (const Fence fence : {Fence::around_all, Fence::around_each}) {
        Heard heard;
        PoolTask task = heard.task(1000, 2);
        task.fence = fence;
        task.work = [](int unit, const std::function<void(int)>& tell) {
            tell(unit);
            if (unit >= 2) ::pause();  // would never end
        };
        task.stop_requested = [&] { return heard.told.size() >= 4; };
        EXPECT_EQ(run_workers(task), PoolOutcome::stopped);
        EXPECT_TRUE(no_child_is_left());
    }
}

TEST(WorkerPool, WorkersIgnoreInterruptsAndStartOnce) {
    Heard heard;
    PoolTask task = heard.task(6, 2);
    int begun = 0;
    task.begin_child = [&] { ++begun; };
    task.work = [&](int unit, const std::function<void(int)>& tell) {
        std::raise(SIGINT);
        tell(begun == 1 ? unit : -1);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 6U);
    EXPECT_FALSE(heard.told.contains(-1));
    EXPECT_EQ(begun, 0);  // in the workers, not here
}

TEST(WorkerPool, WorkersDieWithTheParent) {
    int line[2];
    ASSERT_EQ(::pipe(line), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        ::close(line[0]);
        Heard heard;
        PoolTask task = heard.task(3, 3);
        task.work = [&](int, const std::function<void(int)>&) {
            if (::write(line[1], "x", 1) == 1) ::pause();
        };
        (void)run_workers(task);
        ::_exit(0);
    }
    ::close(line[1]);
    char letters[3];
    for (int i = 0; i < 3; ++i) ASSERT_EQ(::read(line[0], &letters[i], 1), 1);  // all three are at work
    ::kill(parent, SIGKILL);
    ASSERT_EQ(::waitpid(parent, nullptr, 0), parent);
    pollfd end{line[0], POLLIN, 0};
    ASSERT_EQ(::poll(&end, 1, 20'000), 1) << "a worker lives on";
    EXPECT_EQ(::read(line[0], letters, 1), 0);  // nobody holds the other end any more
    ::close(line[0]);
}

}  // namespace workers_test
}  // namespace camopt

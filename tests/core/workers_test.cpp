// SPDX-License-Identifier: MIT
// Worker processes: everything is done once, crashes cost one unit, nobody outlives the parent.
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
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
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
        task.work = [](int unit, const std::function<void(int)>& tell) { tell(unit); };
        task.told = [this](int number) { ++told[number]; };
        task.lost = [this](int unit, const std::string& reason) { lost[unit] = reason; };
        return task;
    }
};

TEST(WorkerPool, DoesEveryUnitExactlyOnce) {
    for (const int workers : {1, 2, 5, 40}) {
        SCOPED_TRACE(workers);
        Heard heard;
        EXPECT_EQ(run_workers(heard.task(30, workers)), PoolOutcome::finished);
        EXPECT_EQ(heard.told.size(), 30U);
        for (const auto& [unit, times] : heard.told) EXPECT_EQ(times, 1) << unit;
        EXPECT_TRUE(heard.lost.empty());
        EXPECT_TRUE(no_child_is_left());
    }
    Heard heard;
    EXPECT_EQ(run_workers(heard.task(0, 2)), PoolOutcome::finished);
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

/// Who did a unit.
struct WhoDidIt {
    std::map<int, pid_t> last;  ///< by unit

    /// The worker tells its process and the unit in one number, as numbers are all that it can tell.
    void listen_to(PoolTask& task, Heard& heard) {
        constexpr int most_processes = 1 << 22;  // of Linux
        task.work = [](int unit, const std::function<void(int)>& tell) {
            tell(unit * most_processes + static_cast<int>(::getpid()));
        };
        task.told = [this, &heard](int number) {
            last[number / most_processes] = number % most_processes;
            ++heard.told[number / most_processes];
        };
    }
};

void see_it_dead(pid_t process) {
    siginfo_t seen{};
    (void)::waitid(P_PID, static_cast<id_t>(process), &seen, WEXITED | WNOWAIT);  // left for the pool to bury
}

void kill_and_see_it_dead(pid_t process) {
    ::kill(process, SIGKILL);
    see_it_dead(process);
}

/// Until proc(5) says so: S, nothing is left for it to do; T, it is stopped.
void see_its_state(pid_t process, std::string_view wanted) {
    const std::string file = "/proc/" + std::to_string(process) + "/stat";
    std::string number, name, state;
    do {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        std::ifstream(file) >> number >> name >> state;
    } while (state != wanted);
}

/// The second worker dies of unit 1, which goes to the first, who has said that it is done and is dead too.
TEST(WorkerPool, DeadWorkerDoesNotFailUnit) {
    const TemporaryFolder folder;
    const std::string mark = folder.path() + "/begun";
    Heard heard;
    WhoDidIt who;
    PoolTask task = heard.task(2, 2);
    who.listen_to(task, heard);
    task.work = [&, tell_who = task.work](int unit, const std::function<void(int)>& tell) {
        if (unit == 1 && !std::filesystem::exists(mark)) {
            std::ofstream(mark) << ::getpid();
            while (true) ::pause();
        }
        tell_who(unit, tell);
        if (unit == 0)
            std::thread([] {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));  // "done" is said by then
                std::raise(SIGKILL);
            }).detach();
    };
    task.told = [&, remember = task.told](int number) {
        remember(number);
        if (heard.told.contains(1)) return;
        pid_t second = 0;
        while (!(std::ifstream(mark) >> second)) std::this_thread::yield();
        kill_and_see_it_dead(second);
        see_it_dead(who.last.at(0));
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 2U);
    EXPECT_TRUE(heard.lost.empty());
    EXPECT_TRUE(no_child_is_left());
}

/// The first worker is stopped when it is done, is given unit 1 of the other, who died, and dies unread.
TEST(WorkerPool, DyingWorkerDoesNotFailUnit) {
    const TemporaryFolder folder;
    const std::string mark = folder.path() + "/begun";
    Heard heard;
    WhoDidIt who;
    PoolTask task = heard.task(2, 2);
    who.listen_to(task, heard);
    task.work = [&, tell_who = task.work](int unit, const std::function<void(int)>& tell) {
        if (unit == 1 && !std::filesystem::exists(mark)) {
            std::ofstream(mark) << ::getpid();
            while (true) ::pause();
        }
        tell_who(unit, tell);
    };
    pid_t stopped = 0;
    task.told = [&, remember = task.told](int number) {
        remember(number);
        if (heard.told.contains(1)) return;
        stopped = who.last.at(0);
        see_its_state(stopped, "S");  // it has sent "done"
        ::kill(stopped, SIGSTOP);
        see_its_state(stopped, "T");  // before that it could still read
        pid_t second = 0;
        while (!(std::ifstream(mark) >> second)) std::this_thread::yield();
        kill_and_see_it_dead(second);
    };
    int ticks = 0;
    task.tick = [&] {  // by the third one the stopped worker has been given what it will never read
        if (stopped != 0 && ++ticks == 3) ::kill(stopped, SIGKILL);
    };
    EXPECT_EQ(run_workers(task), PoolOutcome::finished);
    EXPECT_EQ(heard.told.size(), 2U);
    EXPECT_TRUE(heard.lost.empty());
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
    Heard heard;
    PoolTask task = heard.task(1000, 2);
    task.work = [](int unit, const std::function<void(int)>& tell) {
        tell(unit);
        if (unit >= 2) ::pause();  // would never end
    };
    task.stop_requested = [&] { return heard.told.size() >= 4; };
    EXPECT_EQ(run_workers(task), PoolOutcome::stopped);
    EXPECT_TRUE(no_child_is_left());
}

TEST(WorkerPool, WorkersIgnoreInterruptsAndStartOnce) {
    Heard heard;
    PoolTask task = heard.task(6, 2);
    int begun = 0;
    task.begin_worker = [&] { ++begun; };
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

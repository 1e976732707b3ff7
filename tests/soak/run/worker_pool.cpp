// SPDX-License-Identifier: MIT
#include "tests/soak/run/worker_pool.hpp"

#include "core/platform/files.hpp"
#include "core/platform/workers.hpp"

#include <fmt/format.h>

#include <condition_variable>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <numeric>
#include <thread>
#include <unistd.h>

namespace camopt::soak {

namespace {

/// In the worker, beside a trial: ends the process where the trial takes too long.
void watch(const std::stop_token& over, Patience::Clock::duration budget) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    Patience patience(Patience::Clock::now());
    while (!over.stop_requested()) {
        never.wait_for(lock, over, Patience::turn, [] { return false; });
        patience.look(Patience::Clock::now());
        if (!over.stop_requested() && patience.waited() > budget) ::kill(::getpid(), SIGALRM);
    }
}

std::string fault_of(const std::string& reason) {
    return reason.ends_with(fmt::format("signal {}", SIGALRM)) ? "hung and was killed" : reason;
}

}  // namespace

void run_in_processes(int count, int jobs, double most_seconds, const Worker& worker) {
    const auto budget = std::chrono::milliseconds(static_cast<long>(1000 * most_seconds));
    const std::filesystem::path folder = make_temporary_folder();
    // What a trial tells is in its file, which the pool's second attempt at one that died begins anew.
    const auto file_of = [&](int number) { return folder / fmt::format("{}", number); };
    const auto hear = [&](int number, const std::string& fault) {
        std::ifstream told(file_of(number));
        for (std::string line; std::getline(told, line);) worker.heard(number, line);
        worker.ended(number, fault);
        std::filesystem::remove(file_of(number));
    };
    PoolTask task;
    task.units.resize(static_cast<std::size_t>(count));
    std::iota(task.units.begin(), task.units.end(), 0);
    task.workers = jobs;
    task.fence = Fence::around_each;
    task.work = [&](int number, const std::function<void(int)>& tell) {
        std::ofstream file(file_of(number));
        const std::jthread beside([budget](const std::stop_token& over) { watch(over, budget); });
        try {
            worker.work(number, [&](const std::string& line) { file << line << std::flush; });
        } catch (...) {
            ::_exit(4);  // one failure, not the end of the run
        }
        file.close();
        tell(number);
    };
    task.told = [&](int number) { hear(number, ""); };
    task.lost = [&](int number, const std::string& reason) { hear(number, fault_of(reason)); };
    static_cast<void>(run_workers(task));
    std::filesystem::remove_all(folder);
}

}  // namespace camopt::soak

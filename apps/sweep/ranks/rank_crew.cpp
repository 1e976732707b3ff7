// SPDX-License-Identifier: MIT
#include "apps/sweep/ranks/rank_crew.hpp"

#include "apps/sweep/sweep_job.hpp"
#include "apps/sweep/sweep_solve.hpp"
#include "core/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <ctime>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace camopt::apps {

namespace {

// What a leader is given besides the numbers of chunks.
constexpr int begin_work = -1, no_more_chunks = -2;

/// File systems over a network may show other machines a new file only after a while.
constexpr std::chrono::seconds patience_with_network{30};

std::string machine_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown machine";
}

SweepFolder folder_of_rank_zero(const SweepRequest& request, const SweepJob& job, int rank) {
    const auto last = std::chrono::steady_clock::now() + patience_with_network;
    while (is_unused_sweep_folder(request.out) && std::chrono::steady_clock::now() < last)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const std::string who = fmt::format("rank {} on {}", rank, machine_name());
    if (is_unused_sweep_folder(request.out))
        throw InputError(
            fmt::format("{} does not see {}, where rank 0 works; allowed: --out on a file system "
                        "that all machines share",
                        who, request.out));
    SweepFolder folder = SweepFolder::open(request.out);
    const SweepIdentity& found = folder.identity();
    const std::string other = difference(found, job.identity(found.columns, found.chunking));
    if (!other.empty())
        throw InputError(
            fmt::format("{} and rank 0 do not mean the same sweep: {}; allowed: the same scene, "
                        "tables and camopt on all machines",
                        who, other));
    return folder;
}

/// The whole life of a leader.
void lead(const SweepRequest& request, int rank, int line) {
    using Kind = WorkerMessage::Kind;
    if (receive_number(line) != begin_work) return;
    SweepJob job(request);
    const SweepFolder folder = folder_of_rank_zero(request, job, rank);
    PoolTask task = chunk_task(folder, job.scenes());
    task.workers = request.workers.value_or(1);
    task.begin_worker = [line] { ::close(line); };
    task.done = [line](int chunk) { send_message(line, {Kind::done, chunk, {}}); };
    task.source = {line,
                   [line] {
                       send_message(line, {Kind::asks, 0, {}});
                   },
                   [line]() -> std::optional<int> {
                       const std::optional<int> number = receive_number(line);
                       return number && *number >= 0 ? number : std::nullopt;
                   }};
    (void)run_workers(task);
}

WorkerDuty duty_of_leader(const SweepRequest& request, int rank) {
    return {{}, {}, [&request, rank](int line) { lead(request, rank, line); }};
}

RankMessage as_rank_message(const WorkerMessage& message) {
    using Kind = RankMessage::Kind;
    switch (message.kind) {
        case WorkerMessage::Kind::asks:
            return {Kind::asks};
        case WorkerMessage::Kind::wrong_input:
            return {Kind::wrong_input, 0, message.text};
        case WorkerMessage::Kind::error:
            return {Kind::error, 0, message.text};
        case WorkerMessage::Kind::told:
        case WorkerMessage::Kind::done:
            break;
    }
    return {Kind::done, message.number};
}

}  // namespace

RankCrew::RankCrew(const SweepRequest& request, int rank)
    : leader_(std::in_place, duty_of_leader(request, rank), std::vector<int>{}) {}

void RankCrew::tell(const RankMessage& message) {
    using Kind = RankMessage::Kind;
    if (!leader_) return;
    if (message.kind == Kind::begin) leader_->give(begin_work);
    if (message.kind == Kind::chunk) leader_->give(message.number);
    if (message.kind == Kind::no_more) leader_->give(no_more_chunks);
    if (message.kind == Kind::stop) leader_.reset();
}

std::optional<RankMessage> RankCrew::listen(std::chrono::microseconds patience) {
    if (!leader_) {
        std::this_thread::sleep_for(patience);
        return std::nullopt;
    }
    pollfd line{leader_->line(), POLLIN, 0};
    const timespec longest{0, static_cast<long>(std::chrono::nanoseconds(patience).count())};
    if (::ppoll(&line, 1, &longest, nullptr) <= 0) return std::nullopt;
    const std::optional<WorkerMessage> message = leader_->listen();
    if (message) return as_rank_message(*message);
    const std::string cause = leader_->cause_of_death();
    leader_.reset();
    return RankMessage{RankMessage::Kind::gone, 0, cause};
}

}  // namespace camopt::apps

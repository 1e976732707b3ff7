// SPDX-License-Identifier: MIT
#include "apps/sweep/chunk_hand_out.hpp"
#include "apps/sweep/sweep_job.hpp"
#include "apps/sweep/sweep_progress.hpp"
#include "apps/sweep/worker_pool.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <poll.h>
#include <stdexcept>
#include <thread>
#include <unistd.h>

namespace camopt::apps {

namespace {

// The workers of one rank and the process that leads them.
//
// A process that has started MPI must not fork: so the leader is forked before, runs the same pool of workers
// as a sweep without MPI, and the rank itself only carries messages. A solve that crashes costs its worker,
// not the rank, for whose death mpirun ends the whole run.
class RankCrew {
 public:
    /// Forks the leader, which waits for `tell`({begin}).
    RankCrew(const SweepRequest& request, int rank);

    /// What rank 0 says to this rank: begin, chunk, no_more, stop. After stop no one is left.
    void tell(const RankMessage& message);
    /// What the leader says: asks, done, gone, wrong_input, error; waits at most so long. After `gone`,
    /// `wrong_input` and `error` nothing comes any more.
    [[nodiscard]] std::optional<RankMessage> listen(std::chrono::microseconds patience);

 private:
    std::optional<WorkerProcess> leader_;
};

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
            fmt::format("{} and rank 0 have different sweeps: {}; allowed: the same scene, "
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
    PoolTask task = chunk_task(folder, job);
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

using Kind = RankMessage::Kind;

/// How long to wait for the crew before MPI is asked again: short where something happens, and long enough
/// not to take the core from the worker where nothing does.
class Patience {
 public:
    [[nodiscard]] std::chrono::microseconds time() const { return time_; }
    void heard(bool something) { time_ = something ? shortest : std::min(2 * time_, longest); }

 private:
    static constexpr std::chrono::microseconds shortest{20}, longest{2000};
    std::chrono::microseconds time_ = shortest;
};

/// Rank 0 while there are chunks.
class HandingOut {
 public:
    HandingOut(const SweepFolder& folder, MessagePassing& messages, RankCrew& crew)
        : folder_(folder),
          messages_(messages),
          crew_(crew),
          chunks_(folder.missing_chunks(), messages.size()),
          progress_(folder.identity().chunking, folder.chunks(), folder.missing_chunks()),
          line_(terminal_progress()) {}

    PoolOutcome run() {
        tell_all({Kind::begin});
        Patience patience;
        while (!chunks_.finished()) {
            if (InterruptWatch::interrupted()) return PoolOutcome::stopped;
            patience.heard(listen(patience.time()));
            while (const std::optional<ChunkGiven> given = chunks_.next())
                tell(given->rank, {Kind::chunk, given->chunk});
            tick();
        }
        end_progress();
        tell_all({Kind::no_more});
        return PoolOutcome::finished;
    }

    void tell_all(const RankMessage& message) {
        for (int rank = 0; rank < messages_.size(); ++rank) tell(rank, message);
    }

 private:
    void tell(int rank, const RankMessage& message) {
        if (rank == messages_.rank())
            crew_.tell(message);
        else
            messages_.send(rank, rank_message_bytes(message));
    }

    bool listen(std::chrono::microseconds patience) {
        bool heard = false;
        if (const std::optional<RankMessage> message = crew_.listen(patience)) {
            take(messages_.rank(), *message);
            heard = true;
        }
        while (const std::optional<RankPacket> packet = messages_.receive()) {
            if (const std::optional<RankMessage> message = read_rank_message(packet->bytes))
                take(packet->from, *message);
            heard = true;
        }
        return heard;
    }

    void take(int rank, const RankMessage& message) {
        if (message.kind == Kind::wrong_input) throw InputError(message.text);
        if (message.kind == Kind::error) throw std::runtime_error(message.text);
        if (message.kind == Kind::asks) chunks_.ask(rank);
        if (message.kind == Kind::done) take_done(rank, message.number);
        if (message.kind == Kind::gone) {
            chunks_.gone(rank);
            if (!chunks_.anybody_left())
                throw std::runtime_error(
                    fmt::format("no worker is left on any rank; rank {}: {}", rank, message.text));
        }
    }

    void take_done(int rank, int chunk) {
        chunks_.done(rank, chunk);
        const RowRange rows = folder_.identity().chunking.range(chunk);
        for (int row = rows.begin; row < rows.end; ++row) progress_.add(row);
    }

    void tick() {
        using Clock = std::chrono::steady_clock;
        constexpr std::chrono::milliseconds between_looks{100};
        if (!line_ || Clock::now() - last_tick_ < between_looks) return;
        last_tick_ = Clock::now();
        line_(progress_.text());
    }

    const SweepFolder& folder_;
    MessagePassing& messages_;
    RankCrew& crew_;
    ChunkHandOut chunks_;
    SweepProgress progress_;
    std::function<void(std::string_view)> line_;
    std::chrono::steady_clock::time_point last_tick_;
};

/// Of rank 0 where it cannot go on: all others end as if there were no more to do.
void stop_others(MessagePassing& messages, RankCrew& crew) {
    crew.tell({Kind::stop});
    for (int rank = 1; rank < messages.size(); ++rank) messages.send(rank, rank_message_bytes({Kind::stop}));
    messages.finish();
}

PoolOutcome solve_by_all(const SweepFolder& folder, MessagePassing& messages, RankCrew& crew) {
    const InterruptWatch watch(InterruptWatch::Signals::termination_too);
    return HandingOut(folder, messages, crew).run();
}

ExitCode be_rank_zero(const SweepRequest& request, MessagePassing& messages, RankCrew& crew) {
    std::optional<SweepJob> job;
    std::optional<WorkFolder> work;
    try {
        job.emplace(request);
        work.emplace(request, *job);
        if (solve_by_all(work->folder(), messages, crew) == PoolOutcome::stopped) {
            const ExitCode code = tell_interruption(work->folder());
            messages.abandon(code);
            return code;
        }
    } catch (...) {
        stop_others(messages, crew);
        throw;
    }
    messages.finish();
    return finish_sweep(work->folder(), job->first_scene(), request.units);
}

/// Every other rank: carries messages between its crew and rank 0.
ExitCode be_other_rank(MessagePassing& messages, RankCrew& crew) {
    Patience patience;
    for (bool ended = false; !ended;) {
        bool heard = false;
        if (const std::optional<RankMessage> said = crew.listen(patience.time())) {
            messages.send(0, rank_message_bytes(*said));
            heard = true;
        }
        while (const std::optional<RankPacket> packet = ended ? std::nullopt : messages.receive()) {
            const std::optional<RankMessage> message = read_rank_message(packet->bytes);
            if (!message) continue;
            crew.tell(*message);
            ended = message->kind == Kind::no_more || message->kind == Kind::stop;
            heard = true;
        }
        patience.heard(heard);
    }
    crew.tell({Kind::stop});
    messages.finish();
    return success;
}

}  // namespace

ExitCode sweep_across_ranks(const SweepRequest& request, const RankLaunch& launch) {
    RankCrew crew(request, launch.rank);  // before MPI starts, after which nothing may fork
    const std::unique_ptr<MessagePassing> messages = start_message_passing(launch);
    return launch.rank == 0 ? be_rank_zero(request, *messages, crew) : be_other_rank(*messages, crew);
}

}  // namespace camopt::apps

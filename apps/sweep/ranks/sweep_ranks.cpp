// SPDX-License-Identifier: MIT
#include "apps/sweep/ranks/sweep_ranks.hpp"

#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/sweep/ranks/chunk_hand_out.hpp"
#include "apps/sweep/ranks/rank_crew.hpp"
#include "apps/sweep/sweep_finish.hpp"
#include "apps/sweep/sweep_job.hpp"
#include "apps/sweep/sweep_progress.hpp"
#include "apps/sweep/worker_pool.hpp"
#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace camopt::apps {

namespace {

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
                    fmt::format("no rank has a worker left; of rank {}: {}", rank, message.text));
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
    return finish_sweep(work->folder(), &job->scenes().scene(0), request.units);
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

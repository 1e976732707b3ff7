// SPDX-License-Identifier: MIT
// mpirun -np N hand_out_rate FOLDER: how many chunks a second rank 0 of a sweep hands out, and what it costs
// to write one. The other ranks solve nothing: each asks for as many chunks as a node has workers, and says
// of every one that it is done.
//
// Prints a line of CSV from rank 0: ranks, chunks asked for at a time by each, chunks, microseconds of rank 0
// a chunk, and the median milliseconds until a chunk's file of 8 kB stands in FOLDER and on its disk.
#include "apps/sweep/chunk_hand_out.hpp"
#include "apps/sweep/message_passing.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "core/text/text_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <vector>

namespace camopt::benchmarks {

namespace {

using namespace camopt::apps;
using Clock = std::chrono::steady_clock;
using Kind = RankMessage::Kind;

constexpr int chunks = 200'000, asked_at_a_time = 32, files = 200;
constexpr std::size_t bytes_of_file = 8000;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double milliseconds_to_write(const std::filesystem::path& folder) {
    std::vector<double> milliseconds;
    for (int i = 0; i < files; ++i) {
        const Clock::time_point begin = Clock::now();
        write_durable_text_file(folder / fmt::format("chunk_{:06}.csv", i), std::string(bytes_of_file, 'x'));
        milliseconds.push_back(1e3 * seconds_since(begin));
    }
    return median(milliseconds);
}

void hand_out(MessagePassing& messages, const std::filesystem::path& folder) {
    const double milliseconds = milliseconds_to_write(folder);
    std::vector<int> all(chunks);
    std::iota(all.begin(), all.end(), 0);
    ChunkHandOut queue(all, messages.size());
    for (int rank = 1; rank < messages.size(); ++rank) messages.send(rank, rank_message_bytes({Kind::begin}));
    const Clock::time_point begin = Clock::now();
    while (!queue.finished()) {
        while (const std::optional<RankPacket> packet = messages.receive()) {
            const std::optional<RankMessage> message = read_rank_message(packet->bytes);
            if (message && message->kind == Kind::asks) queue.ask(packet->from);
            if (message && message->kind == Kind::done) queue.done(packet->from, message->number);
        }
        while (const std::optional<ChunkGiven> given = queue.next())
            messages.send(given->rank, rank_message_bytes({Kind::chunk, given->chunk}));
    }
    const double seconds = seconds_since(begin);
    for (int rank = 1; rank < messages.size(); ++rank)
        messages.send(rank, rank_message_bytes({Kind::no_more}));
    fmt::print(
        "ranks,asked_at_a_time,chunks,microseconds_a_chunk,milliseconds_to_write\n{},{},{},{:.4g},{:.4g}\n",
        messages.size(), asked_at_a_time, chunks, 1e6 * seconds / chunks, milliseconds);
}

void ask_and_do_nothing(MessagePassing& messages) {
    for (bool ended = false; !ended;) {
        const std::optional<RankPacket> packet = messages.receive();
        const std::optional<RankMessage> message = packet ? read_rank_message(packet->bytes) : std::nullopt;
        if (!message) continue;
        if (message->kind == Kind::begin)
            for (int i = 0; i < asked_at_a_time; ++i) messages.send(0, rank_message_bytes({Kind::asks}));
        if (message->kind == Kind::chunk) {
            messages.send(0, rank_message_bytes({Kind::done, message->number}));
            messages.send(0, rank_message_bytes({Kind::asks}));
        }
        ended = message->kind == Kind::no_more;
    }
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    using namespace camopt::apps;
    const RankLaunch launch = rank_launch();
    if (count != 2 || launch.size < 2) {
        std::fputs("usage: mpirun -np N hand_out_rate FOLDER, N at least 2\n", stderr);
        return 2;
    }
    try {
        const std::unique_ptr<MessagePassing> messages = start_message_passing(launch);
        if (launch.rank == 0)
            camopt::benchmarks::hand_out(*messages, words[1]);
        else
            camopt::benchmarks::ask_and_do_nothing(*messages);
        messages->finish();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hand_out_rate: %s\n", error.what());
        return 1;
    }
}

// SPDX-License-Identifier: MIT
// Chunks handed out to ranks: each is done once, and what a rank had goes to others.
#include "apps/sweep/chunk_hand_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace camopt::apps {
namespace chunk_hand_out_test {

TEST(ChunkHandOut, FirstAskedFirstServed) {
    ChunkHandOut chunks({4, 7}, 2);
    EXPECT_FALSE(chunks.next());
    for (const int rank : {1, 0, 1}) chunks.ask(rank);
    const auto first = chunks.next(), second = chunks.next();
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->rank, 1);
    EXPECT_EQ(first->chunk, 4);
    EXPECT_EQ(second->rank, 0);
    EXPECT_EQ(second->chunk, 7);
    EXPECT_FALSE(chunks.next());  // rank 1 asks on
    chunks.done(1, 4);
    EXPECT_FALSE(chunks.finished());
    chunks.gone(0);  // its chunk goes to who asks already
    const auto again = chunks.next();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->rank, 1);
    EXPECT_EQ(again->chunk, 7);
    chunks.done(1, 7);
    EXPECT_TRUE(chunks.finished());
    EXPECT_TRUE(chunks.anybody_left());
    chunks.gone(1);
    EXPECT_FALSE(chunks.anybody_left());
}

TEST(ChunkHandOut, DepartedWorkersLoseNoChunk) {
    std::mt19937 generator(7);  // NOLINT(cert-msc51-cpp): the same every time
    for (int round = 0; round < 200; ++round) {
        constexpr int ranks = 6, count = 40;
        std::vector<int> all(count);
        for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)] = i;
        ChunkHandOut chunks(all, ranks);
        std::map<int, int> done;
        std::vector<ChunkGiven> out;
        std::vector<int> here = {0, 1, 2, 3, 4, 5};
        for (const int rank : here) chunks.ask(rank);
        while (!chunks.finished()) {
            while (const auto given = chunks.next()) out.push_back(*given);
            ASSERT_FALSE(out.empty());
            const std::size_t at = generator() % out.size();
            const ChunkGiven one = out[at];
            if (here.size() > 1 && generator() % 8 == 0) {
                chunks.gone(one.rank);
                std::erase(here, one.rank);
                std::erase_if(out, [&](const ChunkGiven& other) { return other.rank == one.rank; });
            } else {
                chunks.done(one.rank, one.chunk);
                chunks.ask(one.rank);
                ++done[one.chunk];
                out.erase(out.begin() + static_cast<std::ptrdiff_t>(at));
            }
        }
        EXPECT_EQ(done.size(), static_cast<std::size_t>(count));
        for (const auto& [chunk, times] : done) EXPECT_EQ(times, 1) << chunk;
    }
}

TEST(RankMessage, RoundTripsAndRefusesNonsense) {
    const auto message = read_rank_message(rank_message_bytes({RankMessage::Kind::error, -7, "φ ≤ 30°"}));
    ASSERT_TRUE(message);
    EXPECT_EQ(message->kind, RankMessage::Kind::error);
    EXPECT_EQ(message->number, -7);
    EXPECT_EQ(message->text, "φ ≤ 30°");
    EXPECT_FALSE(read_rank_message("short"));
    EXPECT_FALSE(read_rank_message(std::string(12, '\x7f')));
}

}  // namespace chunk_hand_out_test
}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
#include "apps/sweep/ranks/chunk_hand_out.hpp"

#include <algorithm>

namespace camopt::apps {

ChunkHandOut::ChunkHandOut(std::vector<int> chunks, int ranks)
    : waiting_(chunks.begin(), chunks.end()), left_(ranks) {}

void ChunkHandOut::ask(int rank) {
    asking_.push_back(rank);
}

void ChunkHandOut::done(int rank, int chunk) {
    const auto place = std::ranges::find_if(
        out_, [&](const ChunkGiven& one) { return one.rank == rank && one.chunk == chunk; });
    if (place != out_.end()) out_.erase(place);
}

void ChunkHandOut::gone(int rank) {
    --left_;
    std::erase(asking_, rank);
    for (const ChunkGiven& one : out_)
        if (one.rank == rank) waiting_.push_front(one.chunk);
    std::erase_if(out_, [&](const ChunkGiven& one) { return one.rank == rank; });
}

std::optional<ChunkGiven> ChunkHandOut::next() {
    if (waiting_.empty() || asking_.empty()) return std::nullopt;
    const ChunkGiven given{asking_.front(), waiting_.front()};
    asking_.pop_front();
    waiting_.pop_front();
    out_.push_back(given);
    return given;
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
#include "apps/sweep/chunk_hand_out.hpp"

#include <cstring>

namespace camopt::apps {

namespace {

using RankMessageHead = std::array<int, 2>;  // kind, number; all ranks run the same program

}  // namespace

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

std::string rank_message_bytes(const RankMessage& message) {
    const RankMessageHead head = {static_cast<int>(message.kind), message.number};
    std::string bytes(sizeof head, '\0');
    std::memcpy(bytes.data(), head.data(), sizeof head);
    return bytes + message.text;
}

std::optional<RankMessage> read_rank_message(std::string_view bytes) {
    RankMessageHead head{};
    if (bytes.size() < sizeof head) return std::nullopt;
    std::memcpy(head.data(), bytes.data(), sizeof head);
    if (head[0] < 0 || head[0] > static_cast<int>(RankMessage::Kind::error)) return std::nullopt;
    return RankMessage{static_cast<RankMessage::Kind>(head[0]), head[1],
                       std::string(bytes.substr(sizeof head))};
}

}  // namespace camopt::apps

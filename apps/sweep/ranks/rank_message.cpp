// SPDX-License-Identifier: MIT
#include "apps/sweep/ranks/rank_message.hpp"

#include <array>
#include <cstring>

namespace camopt::apps {

namespace {

using RankMessageHead = std::array<int, 2>;  // kind, number; all ranks run the same program

}  // namespace

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

// SPDX-License-Identifier: MIT
// What ranks of a sweep say to one another.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace camopt::apps {

struct RankMessage {
    enum class Kind {
        begin,        ///< from rank 0: the folder stands
        chunk,        ///< from rank 0: solve this one
        no_more,      ///< from rank 0: every chunk is done
        stop,         ///< from rank 0: leave what you are doing
        asks,         ///< a worker is free
        done,         ///< a chunk is in the folder
        gone,         ///< no worker of this rank is left; text: why
        wrong_input,  ///< text: what and what is allowed
        error         ///< text: what went wrong
    };
    Kind kind = Kind::begin;
    int number = 0;  ///< chunk, done: of the chunk
    std::string text = {};
};

[[nodiscard]] std::string rank_message_bytes(const RankMessage& message);
/// None for what is no such message.
[[nodiscard]] std::optional<RankMessage> read_rank_message(std::string_view bytes);

}  // namespace camopt::apps

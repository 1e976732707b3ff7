// SPDX-License-Identifier: MIT
// Who gets which chunk: a queue, and what is out. Knows no messages.
#pragma once

#include "core/base/standard.hpp"

#include <deque>

namespace camopt::apps {

/// A rank that is to be told of its next chunk.
struct ChunkGiven {
    int rank = 0;
    int chunk = 0;
};

class ChunkHandOut {
 public:
    ChunkHandOut(std::vector<int> chunks, int ranks);

    /// A rank has a free worker. It gets the next chunk now or, where others might give theirs back, later.
    void ask(int rank);
    void done(int rank, int chunk);
    /// A rank does nothing any more: what it had goes to others, first.
    void gone(int rank);

    /// Whom to tell; each once.
    [[nodiscard]] std::optional<ChunkGiven> next();
    /// Nothing waits and nothing is out.
    [[nodiscard]] bool finished() const { return waiting_.empty() && out_.empty(); }
    [[nodiscard]] bool anybody_left() const { return left_ > 0; }

 private:
    std::deque<int> waiting_;
    std::deque<int> asking_;       ///< ranks, one entry a free worker
    std::vector<ChunkGiven> out_;  ///< as many as workers, not as chunks
    int left_;
};

// What ranks of a sweep say to one another.
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

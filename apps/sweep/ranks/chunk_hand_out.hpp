// SPDX-License-Identifier: MIT
// Who gets which chunk: a queue, and what is out. Knows no messages.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

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

}  // namespace camopt::apps

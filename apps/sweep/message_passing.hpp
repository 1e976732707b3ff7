// SPDX-License-Identifier: MIT
// Short messages between the processes ("ranks") that mpirun started together.
//
// The program knows this interface alone; the module camopt_mpi.so implements it over MPI and is loaded where
// mpirun started the program and nowhere else, so camopt starts and runs where there is no MPI.
#pragma once

#include "core/base/standard.hpp"

namespace camopt::apps {

/// Of one message; longer texts are cut. Below what every MPI sends without waiting for the receiver.
inline constexpr std::size_t longest_rank_message = 1024;

struct RankPacket {
    int from = 0;  ///< rank of the sender
    std::string bytes;
};

class MessagePassing {
 public:
    MessagePassing() = default;
    virtual ~MessagePassing() = default;
    MessagePassing(const MessagePassing&) = delete;
    MessagePassing& operator=(const MessagePassing&) = delete;

    [[nodiscard]] virtual int rank() const = 0;  ///< 0 … size() − 1
    [[nodiscard]] virtual int size() const = 0;
    virtual void send(int rank, std::string_view bytes) = 0;
    /// The oldest message that has come; none: nothing has. Never waits.
    [[nodiscard]] virtual std::optional<RankPacket> receive() = 0;
    /// Waits until every rank has called it. Nothing is sent or received afterwards.
    virtual void finish() = 0;
    /// Ends every rank at once.
    virtual void abandon(int exit_code) = 0;
};

/// The name and type of the one function of the module; null: MPI could not be started.
inline constexpr const char* message_passing_entry = "camopt_start_message_passing";
using StartMessagePassing = MessagePassing* (*)();

// Whether mpirun started this program, and the way to the other ranks.

/// What mpirun says in the environment of every process it starts.
struct RankLaunch {
    int rank = 0;
    int size = 1;  ///< 1: no one else, as without mpirun
};

/// Reads the environment of OpenMPI's mpirun and, for others, of the process managers PMI and PMIx.
[[nodiscard]] RankLaunch rank_launch();

/// Loads camopt_mpi.so from beside the program or from where it is installed, and starts MPI. Throws
/// InputError, with what to do, where this camopt was built without MPI or the module does not load.
[[nodiscard]] std::unique_ptr<MessagePassing> start_message_passing(const RankLaunch& launch);

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// Messages over MPI: the module camopt_mpi.so. The one source that knows MPI.
#include "apps/sweep/message_passing.hpp"

#include <mpi.h>

namespace camopt::apps {

namespace {

constexpr int message_tag = 1;

class MpiMessages final : public MessagePassing {
 public:
    MpiMessages() {
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }

    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return size_; }

    void send(int rank, std::string_view bytes) override {
        const auto length = static_cast<int>(std::min(bytes.size(), longest_rank_message));
        MPI_Send(bytes.data(), length, MPI_BYTE, rank, message_tag, MPI_COMM_WORLD);
    }

    [[nodiscard]] std::optional<RankPacket> receive() override {
        int has_come = 0, length = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, message_tag, MPI_COMM_WORLD, &has_come, &status);
        if (has_come == 0) return std::nullopt;
        MPI_Get_count(&status, MPI_BYTE, &length);
        RankPacket packet{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
        MPI_Recv(packet.bytes.data(), length, MPI_BYTE, packet.from, message_tag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        return packet;
    }

    void finish() override { MPI_Finalize(); }
    void abandon(int exit_code) override { MPI_Abort(MPI_COMM_WORLD, exit_code); }

 private:
    int rank_ = 0, size_ = 1;
};

}  // namespace

}  // namespace camopt::apps

extern "C" [[gnu::visibility("default")]] camopt::apps::MessagePassing* camopt_start_message_passing() {
    if (MPI_Init(nullptr, nullptr) != MPI_SUCCESS) return nullptr;
    return new camopt::apps::MpiMessages;
}

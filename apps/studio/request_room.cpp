// SPDX-License-Identifier: MIT
#include "apps/studio/request_room.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <iterator>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace camopt::apps {

RequestRoom::RequestRoom(const Limits& limits, std::function<void(Connection)> arrived)
    : limits_(limits), arrived_(std::move(arrived)), bell_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (bell_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
    thread_ = std::thread([this] { wait(); });
}

RequestRoom::~RequestRoom() {
    stopping_ = true;
    wake();
    thread_.join();
    let_in();
    for (const Connection& connection : waiting_) ::close(connection.socket);
    ::close(bell_);
}

void RequestRoom::take(int socket) {
    const auto time =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.seconds));
    {
        const std::lock_guard lock(mutex_);
        newcomers_.push_back({socket, Clock::now() + time});
    }
    wake();
}

void RequestRoom::wake() const {
    const std::uint64_t once = 1;
    [[maybe_unused]] const ssize_t written = ::write(bell_, &once, sizeof once);  // full: it rings already
}

void RequestRoom::let_in() {
    const std::lock_guard lock(mutex_);
    std::ranges::move(newcomers_, std::back_inserter(waiting_));
    newcomers_.clear();
    while (waiting_.size() > limits_.connections) {
        ::close(waiting_.front().socket);
        waiting_.erase(waiting_.begin());
    }
}

bool RequestRoom::waits_on(Connection& connection, bool readable) {
    if (readable) {
        std::array<char, 4096> part{};
        const ssize_t got = ::recv(connection.socket, part.data(), part.size(), MSG_DONTWAIT);
        if (got > 0) connection.bytes.append(part.data(), static_cast<std::size_t>(got));
        const bool whole = connection.bytes.find("\r\n\r\n") != std::string::npos;
        if (whole || connection.bytes.size() >= limits_.bytes) {
            arrived_(std::move(connection));
            return false;
        }
        const bool later = got < 0 && (errno == EAGAIN || errno == EINTR);
        if (got <= 0 && !later) connection.end = {};
    }
    if (Clock::now() < connection.end) return true;
    ::close(connection.socket);
    return false;
}

void RequestRoom::wait() {
    while (!stopping_) {
        let_in();
        std::vector<pollfd> looked_at = {{bell_, POLLIN, 0}};
        for (const Connection& connection : waiting_) looked_at.push_back({connection.socket, POLLIN, 0});
        if (::poll(looked_at.data(), looked_at.size(), look_ms) < 0) continue;
        std::uint64_t rung = 0;
        [[maybe_unused]] const ssize_t heard = ::read(bell_, &rung, sizeof rung);
        std::vector<Connection> left;
        for (std::size_t i = 0; i < waiting_.size(); ++i)
            if (waits_on(waiting_[i], looked_at[i + 1].revents != 0)) left.push_back(std::move(waiting_[i]));
        waiting_ = std::move(left);
    }
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// Connections that send nothing, or half a head, hold nobody up and are closed in their time.
#include "apps/studio/request_room.hpp"

#include <gtest/gtest.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace camopt::apps {
namespace request_room_test {

/// Both ends of a connection; the far one is given away.
struct Line {
    Line() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0); }
    ~Line() { ::close(ends[0]); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;
    void send(std::string_view text) const { EXPECT_GT(::send(ends[0], text.data(), text.size(), 0), 0); }
    /// Waits until the other side has closed it.
    [[nodiscard]] bool is_closed() const {
        const timeval most{5, 0};
        ::setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
        char byte = 0;
        return ::recv(ends[0], &byte, 1, 0) == 0;
    }
    std::array<int, 2> ends = {};
};

/// Who has arrived.
class Arrivals {
 public:
    void add(RequestRoom::Connection connection) {
        const std::lock_guard lock(mutex_);
        ::close(connection.socket);
        arrived_.push_back(std::move(connection));
        changed_.notify_all();
    }
    /// Of the first; empty: nobody within some seconds.
    std::string first() {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, std::chrono::seconds(5), [&] { return !arrived_.empty(); });
        return arrived_.empty() ? "" : arrived_.front().bytes;
    }
    std::size_t count() {
        const std::lock_guard lock(mutex_);
        return arrived_.size();
    }

 private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<RequestRoom::Connection> arrived_;
};

constexpr std::string_view request = "GET / HTTP/1.1\r\nHost: a\r\n\r\nbody";

TEST(RequestRoom, HalfOpenConnectionsAreClosed) {
    Arrivals arrivals;
    RequestRoom room({.seconds = 0.15}, [&](auto connection) { arrivals.add(std::move(connection)); });
    std::vector<Line> idle(64);
    for (std::size_t i = 0; i < idle.size(); ++i) {
        room.take(idle[i].ends[1]);
        if (i % 2 == 0) idle[i].send("GET / HTTP/1.1\r\nHo");
    }
    const Line whole;
    whole.send(request.substr(0, 20));
    room.take(whole.ends[1]);
    whole.send(request.substr(20));
    EXPECT_EQ(arrivals.first(), request);
    for (const Line& line : idle) EXPECT_TRUE(line.is_closed());
    EXPECT_EQ(arrivals.count(), 1U);
}

TEST(RequestRoom, LimitsConnectionsAndBytes) {
    Arrivals arrivals;
    RequestRoom room({.seconds = 60.0, .bytes = 10, .connections = 2},
                     [&](auto connection) { arrivals.add(std::move(connection)); });
    std::vector<Line> idle(3);
    for (const Line& line : idle) room.take(line.ends[1]);
    EXPECT_TRUE(idle.front().is_closed());  // the one that waits longest
    idle.back().send("0123456789");
    EXPECT_EQ(arrivals.first(), "0123456789");  // handed on to be refused
}

TEST(RequestRoom, ClosesWhatWaitsWhenItEnds) {
    Arrivals arrivals;
    const Line idle;
    {
        RequestRoom room({.seconds = 60.0}, [&](auto connection) { arrivals.add(std::move(connection)); });
        room.take(idle.ends[1]);
    }
    EXPECT_TRUE(idle.is_closed());
    EXPECT_EQ(arrivals.count(), 0U);
}

}  // namespace request_room_test
}  // namespace camopt::apps

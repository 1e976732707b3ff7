// SPDX-License-Identifier: MIT
#include "apps/studio/request_stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

namespace camopt::apps {

namespace {

RequestStream::Clock::time_point after_seconds(double seconds) {
    return RequestStream::Clock::now() +
           std::chrono::duration_cast<RequestStream::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

RequestStream::RequestStream(RequestRoom::Connection begun, const Limits& limits,
                             const std::atomic<bool>& stopping)
    : from_(std::move(begun)),
      stopping_(stopping),
      write_seconds_(limits.write_seconds),
      bytes_left_(limits.bytes - std::min(limits.bytes, from_.bytes.size())) {}

bool RequestStream::wait_for(short what, Clock::time_point end) const {
    while (!stopping_ && Clock::now() < end) {
        pollfd entry{from_.socket, what, 0};
        const int ready = poll(&entry, 1, RequestRoom::look_ms);
        if (ready > 0) return (entry.revents & (POLLERR | POLLNVAL)) == 0;
        if (ready < 0 && errno != EINTR) return false;
    }
    return false;
}

bool RequestStream::is_readable() const {
    return begin_ < from_.bytes.size() || wait_for(POLLIN, from_.end);
}

bool RequestStream::is_writable() const {
    return wait_for(POLLOUT,
                    write_end_ == Clock::time_point{} ? after_seconds(write_seconds_.count()) : write_end_);
}

ssize_t RequestStream::read(char* target, size_t size) {
    if (begin_ == from_.bytes.size()) {
        if (bytes_left_ == 0 || !wait_for(POLLIN, from_.end)) return -1;
        constexpr std::size_t part = 4096;
        from_.bytes.resize(std::min(part, bytes_left_));
        const ssize_t got = recv(from_.socket, from_.bytes.data(), from_.bytes.size(), 0);
        from_.bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        begin_ = 0;
        if (got <= 0) return got;
        bytes_left_ -= from_.bytes.size();
    }
    const std::size_t count = std::min(size, from_.bytes.size() - begin_);
    std::memcpy(target, from_.bytes.data() + begin_, count);
    begin_ += count;
    return static_cast<ssize_t>(count);
}

ssize_t RequestStream::write(const char* source, size_t size) {
    if (write_end_ == Clock::time_point{}) write_end_ = after_seconds(write_seconds_.count());
    if (!wait_for(POLLOUT, write_end_)) return -1;
    return send(from_.socket, source, size, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void RequestStream::get_remote_ip_and_port(std::string& ip, int& port) const {
    ip = "127.0.0.1";
    port = 0;
}

void RequestStream::get_local_ip_and_port(std::string& ip, int& port) const {
    get_remote_ip_and_port(ip, port);
}

}  // namespace camopt::apps

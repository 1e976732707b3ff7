// SPDX-License-Identifier: MIT
#include "apps/studio/request_stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>

namespace camopt::apps {

namespace {

constexpr int look_ms = 100;  // how often a waiting connection looks whether the studio ends

RequestStream::Clock::time_point after_seconds(double seconds) {
    return RequestStream::Clock::now() +
           std::chrono::duration_cast<RequestStream::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

RequestStream::RequestStream(socket_t socket, const Limits& limits, const std::atomic<bool>& stopping)
    : socket_(socket),
      stopping_(stopping),
      read_end_(after_seconds(limits.read_seconds)),
      write_seconds_(limits.write_seconds),
      bytes_left_(limits.bytes) {}

bool RequestStream::wait_for(short what, Clock::time_point end) const {
    while (!stopping_ && Clock::now() < end) {
        pollfd entry{socket_, what, 0};
        const int ready = poll(&entry, 1, look_ms);
        if (ready > 0) return (entry.revents & (POLLERR | POLLNVAL)) == 0;
        if (ready < 0 && errno != EINTR) return false;
    }
    return false;
}

bool RequestStream::is_readable() const {
    return begin_ < end_ || wait_for(POLLIN, read_end_);
}

bool RequestStream::is_writable() const {
    return wait_for(POLLOUT,
                    write_end_ == Clock::time_point{} ? after_seconds(write_seconds_.count()) : write_end_);
}

ssize_t RequestStream::read(char* target, size_t size) {
    if (begin_ == end_) {
        if (bytes_left_ == 0 || !wait_for(POLLIN, read_end_)) return -1;
        const ssize_t got = recv(socket_, buffer_.data(), std::min(buffer_.size(), bytes_left_), 0);
        if (got <= 0) return got;
        begin_ = 0;
        end_ = static_cast<std::size_t>(got);
        bytes_left_ -= end_;
    }
    const std::size_t count = std::min(size, end_ - begin_);
    std::memcpy(target, buffer_.data() + begin_, count);
    begin_ += count;
    return static_cast<ssize_t>(count);
}

ssize_t RequestStream::write(const char* source, size_t size) {
    if (write_end_ == Clock::time_point{}) write_end_ = after_seconds(write_seconds_.count());
    if (!wait_for(POLLOUT, write_end_)) return -1;
    return send(socket_, source, size, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void RequestStream::get_remote_ip_and_port(std::string& ip, int& port) const {
    ip = "127.0.0.1";
    port = 0;
}

void RequestStream::get_local_ip_and_port(std::string& ip, int& port) const {
    get_remote_ip_and_port(ip, port);
}

}  // namespace camopt::apps

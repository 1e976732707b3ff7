// SPDX-License-Identifier: MIT
// One connection that carries one request: so many bytes, within so many seconds, until the studio ends.
// The HTTP library limits each single read alone: a byte now and then would hold its thread for ever.
// Internal to studio_server.cpp.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <httplib.h>

namespace camopt::apps {

class RequestStream final : public httplib::Stream {
 public:
    using Clock = std::chrono::steady_clock;
    struct Limits {
        double read_seconds = 0.0, write_seconds = 0.0;
        std::size_t bytes = 0;  ///< read in all
    };

    RequestStream(socket_t socket, const Limits& limits, const std::atomic<bool>& stopping);

    [[nodiscard]] bool is_readable() const override;
    [[nodiscard]] bool is_writable() const override;
    ssize_t read(char* target, size_t size) override;
    ssize_t write(const char* source, size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
    [[nodiscard]] bool wait_for(short what, Clock::time_point end) const;

    socket_t socket_;
    const std::atomic<bool>& stopping_;
    Clock::time_point read_end_;
    std::chrono::duration<double> write_seconds_;
    Clock::time_point write_end_ = {};  ///< from the first byte of the answer on
    std::size_t bytes_left_;
    std::array<char, 4096> buffer_ = {};
    std::size_t begin_ = 0, end_ = 0;  ///< what of the buffer was not read yet
};

}  // namespace camopt::apps

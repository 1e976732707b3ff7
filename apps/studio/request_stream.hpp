// SPDX-License-Identifier: MIT
// One connection that carries one request: so many bytes, within so many seconds, until the studio ends.
// The HTTP library limits each single read alone: a byte now and then would hold its thread for ever.
// Internal to studio_server.cpp.
#pragma once

#include "apps/studio/request_room.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <httplib.h>

namespace camopt::apps {

class RequestStream final : public httplib::Stream {
 public:
    using Clock = std::chrono::steady_clock;
    struct Limits {
        double write_seconds = 0.0;
        std::size_t bytes = 0;  ///< read in all
    };

    /// `begun`: what of the request has come already, and when the rest must have.
    RequestStream(RequestRoom::Connection begun, const Limits& limits, const std::atomic<bool>& stopping);

    [[nodiscard]] bool is_readable() const override;
    [[nodiscard]] bool is_writable() const override;
    ssize_t read(char* target, size_t size) override;
    ssize_t write(const char* source, size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    [[nodiscard]] socket_t socket() const override { return from_.socket; }

 private:
    [[nodiscard]] bool wait_for(short what, Clock::time_point end) const;

    RequestRoom::Connection from_;
    const std::atomic<bool>& stopping_;
    std::chrono::duration<double> write_seconds_;
    Clock::time_point write_end_ = {};  ///< from the first byte of the answer on
    std::size_t bytes_left_;
    std::size_t begin_ = 0;  ///< what of from_.bytes was not read yet
};

}  // namespace camopt::apps

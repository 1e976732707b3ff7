// SPDX-License-Identifier: MIT
// The part "http": a separate module, or a part of camopt_studio.
#include "apps/studio/request_room.hpp"
#include "apps/studio/studio_server.hpp"
#include "core/errors.hpp"
#include "core/platform/part_entry.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace camopt::apps {

namespace {

/// One connection that carries one request: so many bytes, within so many seconds, until the studio ends.
/// The HTTP library limits each single read alone: a byte now and then would hold its thread for ever.
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

RequestStream::Clock::time_point after_seconds(double seconds) {
    return RequestStream::Clock::now() +
           std::chrono::duration_cast<RequestStream::Clock::duration>(std::chrono::duration<double>(seconds));
}

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

constexpr const char* loopback = "127.0.0.1";
constexpr const char* nothing_runs = "default-src 'none'; frame-ancestors 'none'";

/// What the library would do in its own thread is done at once: it only takes a connection on.
class AtOnce final : public httplib::TaskQueue {
 public:
    void enqueue(std::function<void()> work) override { work(); }
    void shutdown() override {}
};

/// Serves one request a connection. What follows the head of a refused request is never read, so no second
/// one could hide in it; and no thread waits on a connection no one uses.
class LoopbackServer final : public httplib::Server {
 public:
    explicit LoopbackServer(const StudioServerOptions& options)
        : options_(options),
          serving_(static_cast<std::size_t>(options.threads)),
          room_(std::make_unique<RequestRoom>(
              RequestRoom::Limits{options.request_seconds, options.header_bytes},
              [this](RequestRoom::Connection begun) {
                  serving_.enqueue([this, begun = std::move(begun)] { serve(begun); });
              })) {
        new_task_queue = [] { return new AtOnce; };
    }
    ~LoopbackServer() override {
        room_.reset();  // nothing more comes to be served
        serving_.shutdown();
    }
    LoopbackServer(const LoopbackServer&) = delete;
    LoopbackServer& operator=(const LoopbackServer&) = delete;

    void end() {
        stopping_ = true;
        stop();
    }

 private:
    bool process_and_close_socket(socket_t socket) override {
        room_->take(socket);
        return true;
    }

    void serve(const RequestRoom::Connection& begun) {
        RequestStream stream(begun, {options_.answer_seconds, options_.header_bytes + options_.body_bytes},
                             stopping_);
        bool closed = false;
        // Nothing is compressed, or sent in parts, for a reader on the same machine.
        (void)process_request(stream, true, closed, [](httplib::Request& request) {
            request.headers.erase("Accept-Encoding");
            request.headers.erase("Range");
            request.ranges.clear();
        });
        linger_and_close(begun.socket);
    }

    /// Closing while unread bytes lie there would take the answer back: what comes is drained for a moment.
    static void linger_and_close(socket_t socket) {
        shutdown(socket, SHUT_WR);
        const timeval moment{0, 200'000};
        setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &moment, sizeof moment);
        char buffer[4096];
        constexpr int most_reads = 1024;
        for (int i = 0; i < most_reads && recv(socket, buffer, sizeof buffer, 0) > 0; ++i) {
        }
        close(socket);
    }

    StudioServerOptions options_;
    std::atomic<bool> stopping_{false};
    httplib::ThreadPool serving_;
    std::unique_ptr<RequestRoom> room_;
};

RequestHead head_of(const httplib::Request& request) {
    RequestHead head{request.method, request.target, {}};
    for (const auto& [name, value] : request.headers) head.headers.emplace_back(name, value);
    return head;
}

httplib::Headers fixed_headers() {
    return {{"Cache-Control", "no-store"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Referrer-Policy", "no-referrer"},
            {"X-Content-Type-Options", "nosniff"},
            {"X-Frame-Options", "DENY"}};
}

void refuse(httplib::Response& response, int status) {
    response.status = status;
    response.set_header("Content-Security-Policy", nothing_runs);
    response.set_content("refused\n", "text/plain");
}

void fill(httplib::Response& response, StudioAnswer answer) {
    response.status = answer.status;
    response.set_header("Content-Security-Policy",
                        answer.content_policy.empty() ? nothing_runs : answer.content_policy);
    if (!answer.file_name.empty())
        response.set_header("Content-Disposition",
                            fmt::format("attachment; filename=\"{}\"", answer.file_name));
    response.body = std::move(answer.body);
    response.set_header("Content-Type", answer.type);
}

void set_up(httplib::Server& server, const StudioServerOptions& options) {
    server.set_default_headers(fixed_headers());
    server.set_tcp_nodelay(true);
    server.set_payload_max_length(options.body_bytes);
    // The library would let a second program listen on the same port.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_exception_handler([](const httplib::Request&, httplib::Response& response,
                                    const std::exception_ptr&) { refuse(response, 500); });
    server.set_expect_100_continue_handler([](const httplib::Request&, httplib::Response&) { return 417; });
}

class LoopbackStudio final : public StudioServer {
 public:
    LoopbackStudio(StudioHandlers handlers, const StudioServerOptions& options, std::string token);
    ~LoopbackStudio() override;
    LoopbackStudio(const LoopbackStudio&) = delete;
    LoopbackStudio& operator=(const LoopbackStudio&) = delete;

    [[nodiscard]] std::string address() const override { return place_.origin() + place_.target(""); }
    [[nodiscard]] bool running() const override { return server_.is_running(); }

 private:
    StudioHandlers handlers_;
    StudioPlace place_;
    LoopbackServer server_;
    std::thread listener_;
};

LoopbackStudio::LoopbackStudio(StudioHandlers handlers, const StudioServerOptions& options, std::string token)
    : handlers_(std::move(handlers)), server_(options) {
    set_up(server_, options);
    if (options.port == 0)
        place_.port = server_.bind_to_any_port(loopback);
    else if (server_.bind_to_port(loopback, options.port))
        place_.port = options.port;
    if (place_.port <= 0)
        throw InputError(
            fmt::format("--port {}: the port is taken or may not be used; allowed: a free one from "
                        "1024 on, or leave the option out",
                        options.port));
    place_.token = std::move(token);
    place_.body_bytes = options.body_bytes;
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        const int status = refusal_of(head_of(request), place_);
        if (status == 0) return httplib::Server::HandlerResponse::Unhandled;
        refuse(response, status);
        return httplib::Server::HandlerResponse::Handled;
    });
    server_.Get(place_.target(""), [this](const httplib::Request&, httplib::Response& response) {
        fill(response, handlers_.page());
    });
    server_.Post(place_.target("solve"),
                 [this](const httplib::Request& request, httplib::Response& response) {
                     fill(response, handlers_.solve(request.body));
                 });
    server_.Post(place_.target("export"),
                 [this](const httplib::Request& request, httplib::Response& response) {
                     fill(response, handlers_.download(request.body));
                 });
    listener_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::yield();
}

LoopbackStudio::~LoopbackStudio() {
    server_.end();
    if (listener_.joinable()) listener_.join();
}

constexpr StudioPart http_table = {[](StudioHandlers handlers, const StudioServerOptions& options,
                                      std::string token) -> std::unique_ptr<StudioServer> {
    return std::make_unique<LoopbackStudio>(std::move(handlers), options, std::move(token));
}};

}  // namespace

}  // namespace camopt::apps

extern "C" const void* camopt_part_http(const char* build);
const void* camopt_part_http(const char* build) {
    return camopt::part_for(build, &camopt::apps::http_table);
}

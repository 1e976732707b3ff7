// SPDX-License-Identifier: MIT
#include "apps/studio/studio_server.hpp"

#include "apps/studio/request_room.hpp"
#include "apps/studio/request_stream.hpp"
#include "core/errors.hpp"

#include <fmt/format.h>

#include <httplib.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace camopt::apps {

namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr const char* nothing_runs = "default-src 'none'; frame-ancestors 'none'";

/// What the library would do in a thread of its own is done at once: it only takes a connection on.
class AtOnce final : public httplib::TaskQueue {
 public:
    void enqueue(std::function<void()> work) override { work(); }
    void shutdown() override {}
};

/// Serves one request a connection. What follows the head of a refused request is never read, so no second
/// one could hide in it; and no thread waits on a connection nobody uses.
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

}  // namespace

struct StudioServer::State {
    State(StudioHandlers given, const StudioServerOptions& options)
        : handlers(std::move(given)), server(options) {}

    StudioHandlers handlers;
    StudioPlace place;
    LoopbackServer server;
    std::thread listener;
};

namespace {

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

}  // namespace

StudioServer::StudioServer(StudioHandlers handlers, const StudioServerOptions& options)
    : state_(std::make_unique<State>(std::move(handlers), options)) {
    State& state = *state_;
    set_up(state.server, options);
    if (options.port == 0)
        state.place.port = state.server.bind_to_any_port(loopback);
    else if (state.server.bind_to_port(loopback, options.port))
        state.place.port = options.port;
    if (state.place.port <= 0)
        throw InputError(
            fmt::format("--port {}: the port is taken or may not be used; allowed: a free one from "
                        "1024 on, or leave the option out",
                        options.port));
    state.place.token = random_token();
    state.place.body_bytes = options.body_bytes;
    state.server.set_pre_routing_handler(
        [&state](const httplib::Request& request, httplib::Response& response) {
            const int status = refusal_of(head_of(request), state.place);
            if (status == 0) return httplib::Server::HandlerResponse::Unhandled;
            refuse(response, status);
            return httplib::Server::HandlerResponse::Handled;
        });
    state.server.Get(state.place.target(""), [&state](const httplib::Request&, httplib::Response& response) {
        fill(response, state.handlers.page());
    });
    state.server.Post(state.place.target("solve"),
                      [&state](const httplib::Request& request, httplib::Response& response) {
                          fill(response, state.handlers.solve(request.body));
                      });
    state.server.Post(state.place.target("export"),
                      [&state](const httplib::Request& request, httplib::Response& response) {
                          fill(response, state.handlers.download(request.body));
                      });
    state.listener = std::thread([&state] { state.server.listen_after_bind(); });
    while (!state.server.is_running()) std::this_thread::yield();
}

StudioServer::~StudioServer() {
    state_->server.end();
    if (state_->listener.joinable()) state_->listener.join();
}

std::string StudioServer::address() const {
    return state_->place.origin() + state_->place.target("");
}

bool StudioServer::running() const {
    return state_->server.is_running();
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// Where connections wait until the head of their request has come. One thread waits for all of them: those
// that send nothing, or not all of it (a browser opens some in advance), hold none of the threads that serve.
// Internal to loopback_server.cpp.
#pragma once

#include "core/base/standard.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace camopt::apps {

class RequestRoom {
 public:
    using Clock = std::chrono::steady_clock;
    /// How often who waits for a connection looks at deadlines, and whether the studio ends.
    static constexpr int look_ms = 100;

    struct Limits {
        double seconds = 10.0;          ///< from the connection on; who has not sent a head by then is closed
        std::size_t bytes = 32'000;     ///< of a head; what is longer is handed on as it is, to be refused
        std::size_t connections = 256;  ///< that wait; one more closes the one that waits longest
    };

    struct Connection {
        int socket = -1;
        Clock::time_point end = {};  ///< by when all of its request must have come
        std::string bytes = {};      ///< that have come: the head, and perhaps more
    };

    /// `arrived` takes the socket over. It is called by the room's thread and must not wait.
    RequestRoom(const Limits& limits, std::function<void(Connection)> arrived);
    /// Closes every connection that waits.
    ~RequestRoom();
    RequestRoom(const RequestRoom&) = delete;
    RequestRoom& operator=(const RequestRoom&) = delete;

    /// Takes the socket over. From any thread.
    void take(int socket);

 private:
    void wait();
    void let_in();
    void wake() const;
    /// True: it waits on. False: it was handed on or closed.
    bool waits_on(Connection& connection, bool readable);

    Limits limits_;
    std::function<void(Connection)> arrived_;
    int bell_;  ///< an eventfd that ends a wait
    std::atomic<bool> stopping_{false};
    std::mutex mutex_;
    std::vector<Connection> newcomers_;
    std::vector<Connection> waiting_;  ///< of the room's thread; in the order they came
    std::thread thread_;
};

// Which requests the studio answers. A page of another origin, open in the same browser, can send requests to
// this port, and can give its own name this machine's address (DNS rebinding): Host, Origin and
// Sec-Fetch-Site say so, and the token is what it does not know.

/// A request before its body is read.
struct RequestHead {
    std::string method, target;
    std::vector<std::pair<std::string, std::string>> headers;  ///< names in any case

    /// All values of a header.
    [[nodiscard]] std::vector<std::string> values(std::string_view name) const;
};

struct StudioPlace {
    int port = 0;
    std::string token;
    std::size_t body_bytes = 0;  ///< the most a request may carry

    [[nodiscard]] std::string host() const;                         ///< "127.0.0.1:41234"
    [[nodiscard]] std::string origin() const;                       ///< "http://127.0.0.1:41234"
    [[nodiscard]] std::string target(std::string_view what) const;  ///< "/TOKEN/solve"
};

/// 0: to be answered. Else the status of the refusal:
///   403  another Host than this one; a foreign Origin; Sec-Fetch-Site says another site
///   404  no such target: another token, anything behind the page but solve and export
///   405  the target is there, for another method
///   411  a body without a length (chunked, or none given)
///   413  a longer body than is read
///   415  a body that is no JSON, or a compressed one
///   417  an expectation
///   400  a header twice that may stand once, a length that is no number
[[nodiscard]] int refusal_of(const RequestHead& request, const StudioPlace& place);

}  // namespace camopt::apps

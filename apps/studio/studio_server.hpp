// SPDX-License-Identifier: MIT
// The studio's HTTP server: this machine's loopback alone, one token in the address, two things to ask.
//
//   GET  /TOKEN/          the page
//   POST /TOKEN/solve     a scene solved, JSON to JSON
//   POST /TOKEN/export    a file of it
//
// Everything else is refused (request_room.hpp) before its body is read, with no word of what is there. Each
// connection carries one request, within a number of seconds and bytes. Files are never touched.
// studio_absent.cpp stands in where the build has no HTTP library.
#pragma once

#include "core/base/standard.hpp"

namespace camopt::apps {

/// What a handler gives back.
struct StudioAnswer {
    int status = 200;
    std::string type = "application/json";
    std::string body;
    std::string content_policy = {};  ///< of the page; empty: nothing may run
    std::string file_name = {};       ///< of a download; empty: none
};

/// Called from several threads at once.
struct StudioHandlers {
    std::function<StudioAnswer()> page;
    std::function<StudioAnswer(const std::string&body)> solve, download;
};

struct StudioServerOptions {
    int port = 0;                        ///< 0: any free one
    double request_seconds = 10.0;       ///< in which a request must have come
    double answer_seconds = 60.0;        ///< in which an answer must have been taken
    std::size_t body_bytes = 1'000'000;  ///< of a request: hundreds of times a scene
    std::size_t header_bytes = 32'000;   ///< of a request
    int threads = 16;  ///< requests answered at the same time; those still coming wait apart
};

class StudioServer {
 public:
    /// This build has the HTTP library.
    [[nodiscard]] static bool available();
    /// Binds and serves at once. Throws InputError for a port that is taken, UnavailableError where the build
    /// has no HTTP library.
    StudioServer(StudioHandlers handlers, const StudioServerOptions& options = {});
    /// Ends every connection and waits for the handlers, which are to be told before.
    ~StudioServer();
    StudioServer(const StudioServer&) = delete;
    StudioServer& operator=(const StudioServer&) = delete;

    /// "http://127.0.0.1:41234/0123…/"
    [[nodiscard]] std::string address() const;
    /// False once it has stopped by itself.
    [[nodiscard]] bool running() const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace camopt::apps

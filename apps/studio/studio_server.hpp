// SPDX-License-Identifier: MIT
// The studio's HTTP server: this machine's loopback alone, one token in the address, two things to ask.
//
//   GET  /TOKEN/          the page
//   POST /TOKEN/solve     a scene solved, JSON to JSON
//   POST /TOKEN/export    a file of it
//
// Everything else is refused (request_room.hpp) before its body is read, with no word of what is there. Each
// connection carries one request, within a number of seconds and bytes. Files are never touched.
// The HTTP library stands behind the part "http" (core/platform/parts.hpp).
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
    /// Ends every connection and waits for the handlers, which are to be told before.
    virtual ~StudioServer() = default;
    StudioServer(const StudioServer&) = delete;
    StudioServer& operator=(const StudioServer&) = delete;

    /// "http://127.0.0.1:41234/0123…/"
    [[nodiscard]] virtual std::string address() const = 0;
    /// False once it has stopped by itself.
    [[nodiscard]] virtual bool running() const = 0;

 protected:
    StudioServer() = default;
};

/// False where the build has no HTTP library, or its part is not there.
[[nodiscard]] bool studio_server_available();

/// What to do where it is not available, without a full stop.
[[nodiscard]] std::string studio_server_remedy();

/// Binds and serves at once. Throws InputError for a port that is taken, UnavailableError where no server is
/// available.
[[nodiscard]] std::unique_ptr<StudioServer> serve_studio(StudioHandlers handlers,
                                                         const StudioServerOptions& options = {});

/// The part "http". `token`: random_token(), in every address.
struct StudioPart {
    std::unique_ptr<StudioServer> (*serve)(StudioHandlers handlers, const StudioServerOptions& options,
                                           std::string token);
};

}  // namespace camopt::apps

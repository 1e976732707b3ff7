// SPDX-License-Identifier: MIT
// camopt studio: the page of a scene, served on this machine's loopback until Ctrl-C.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/studio/studio_page.hpp"
#include "apps/studio/studio_server.hpp"
#include "apps/terminal.hpp"

#include <fmt/format.h>

#include <csignal>

namespace camopt::apps {

namespace {

/// What ends the program is waited for instead of handled; threads begun while this lives leave it alone.
class EndSignals {
 public:
    EndSignals() {
        sigemptyset(&awaited_);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&awaited_, signal);
        pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
    }
    ~EndSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    /// True: one came within so many milliseconds.
    [[nodiscard]] bool came_within(long milliseconds) const {
        const timespec time{milliseconds / 1000, milliseconds % 1000 * 1'000'000};
        return sigtimedwait(&awaited_, nullptr, &time) > 0;
    }

 private:
    sigset_t awaited_ = {}, before_ = {};
};

/// The scene of the command line, with its settings, or one to begin with.
StudioStart start_of(const StudioRequest& request) {
    if (request.scene.empty()) return first_scene();
    return {request.scene, load_scene_and_text(request.scene, request.settings).text};
}

}  // namespace

ExitCode studio_command(const StudioRequest& request) {
    const StudioStart start = start_of(request);
    const EndSignals signals;
    StudioSession session;
    const StudioServer server({.page = [&] { return studio_page(start, session.first(start.scene)); },
                               .solve = [&](const std::string& body) { return session.solve(body); },
                               .download = [&](const std::string& body) { return session.download(body); }},
                              {.port = request.port});
    print(fmt::format("camopt studio: {}\nOpen it in a browser on this machine. Ctrl-C ends it.\n",
                      server.address()));
    constexpr long look_ms = 500;
    while (server.running() && !signals.came_within(look_ms)) {
    }
    session.stop();
    return server.running() ? success : failure;
}

}  // namespace camopt::apps

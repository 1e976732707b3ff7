// SPDX-License-Identifier: MIT
// camopt studio: the page of a scene, served on this machine's loopback until Ctrl-C, or as a file that holds
// the solver too.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/studio/studio_page.hpp"
#include "apps/studio/studio_server.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/platform/files.hpp"
#include "core/text/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <thread>

namespace camopt::apps {

namespace {

/// The scene of the command line, with its settings, or one to begin with.
StudioStart start_of(const StudioRequest& request) {
    if (request.scene.empty()) return first_scene();
    return {request.scene, load_scene_and_text(request.scene, request.settings).text};
}

/// The page that holds the solver too, as it is installed; with `opening` in the place of none.
std::string offline_page(const nlohmann::json& opening) {
    constexpr std::string_view name = "camopt.html";
    const std::string id = "opening-scene", none = page_block({id, "null"});
    const std::filesystem::path program = program_folder();
    for (const std::filesystem::path& place : {program / name, program / "../share/camopt" / name}) {
        if (!std::filesystem::is_regular_file(place)) continue;
        std::string page = read_text_file(place);
        const std::size_t at = page.find(none);
        if (at == std::string::npos)
            throw InputError(place.string() +
                             ": found no element opening-scene; allowed: the page of this camopt");
        return page.replace(at, none.size(), page_block({id, opening.dump()}));
    }
    throw UnavailableError(fmt::format(
        "camopt studio: found no {0} next to the program or in share/camopt; {1}. `camopt solve "
        "SCENE --out DIR` "
        "writes a report without it",
        name,
        studio_server_available() ? "without --offline the studio is served instead"
                                  : "to have the studio served instead, " + studio_server_remedy()));
}

ExitCode open_offline_page(const StudioStart& start) {
    const std::string page = offline_page({{"name", start.name}, {"scene", start.scene}});
    const std::filesystem::path file = make_temporary_folder() / "camopt.html";
    write_text_file(file, page);
    print(fmt::format("camopt studio: {}\n{}", file.string(),
                      open_in_browser(file) ? "" : "Open it in a browser on this machine.\n"));
    return success;
}

}  // namespace

ExitCode studio_command(const StudioRequest& request) {
    const StudioStart start = start_of(request);
    if (request.offline || !studio_server_available()) return open_offline_page(start);
    const InterruptWatch watch(InterruptWatch::Signals::hangup_too);
    StudioSession session;
    const std::unique_ptr<StudioServer> server =
        serve_studio({.page = [&] { return studio_page(start, session.first(start.scene)); },
                      .solve = [&](const std::string& body) { return session.solve(body); },
                      .download = [&](const std::string& body) { return session.download(body); }},
                     {.port = request.port});
    print(fmt::format("camopt studio: {}\nOpen it in a browser on this machine. Ctrl-C ends it.\n",
                      server->address()));
    constexpr std::chrono::milliseconds look(100);
    while (server->running() && !InterruptWatch::interrupted()) std::this_thread::sleep_for(look);
    session.stop();
    return server->running() ? success : failure;
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// The studio's page: the page of a report with controls beside it, everything in one document.
#pragma once

#include "apps/studio/studio_server.hpp"
#include "report/page/page_html.hpp"
#include "scene/scene.hpp"
#include "solvers/solver.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace camopt::apps {

// The scene a page asks about: the text of a scene file and what its controls set since.
struct StudioScene {
    Scene scene;       ///< ready to be solved
    std::string text;  ///< the same as one scene file
};

/// `settings`: an object, KEY: value, applied in its order. A number, true, false or a text is set as `--set
/// KEY=VALUE` does; an object { "min": …, "max": … } is a range; null takes the key or the entry of a list
/// out; { "insert": { … } } is a new entry of a list before the one of that index. `unit`: the text is then
/// written in it (scene_in_units), and the scene is shown in it. Throws InputError for all that the reader of
/// scene files refuses, in its words, and for values of other kinds; `name` stands in the place of the file.
/// The text is all there is: nothing in it makes camopt open a file.
[[nodiscard]] StudioScene studio_scene(const std::string& text, const nlohmann::ordered_json& settings,
                                       const std::string& name, std::optional<LengthUnit> unit = {});

/// What a fresh page begins with.
struct StudioStart {
    std::string name;   ///< of the scene file, for people
    std::string scene;  ///< TOML
};

/// A rise between two dwells, for who comes without a scene.
[[nodiscard]] StudioStart first_scene();

/// answer: to the first solve (studio_session.cpp). With a content policy that lets this document's own
/// scripts run and no others, and connect to nothing but this server.
[[nodiscard]] StudioAnswer studio_page(const StudioStart& start, const std::string& answer);

/// The same page before it is written: studio_page() adds the policy of a server, make_offline_page() the
/// engine.
[[nodiscard]] PageHtml studio_html(const StudioStart& start, const std::string& answer);

/// camopt.html: the studio's page, the engine and the scenes of a folder that it can solve as examples, in
/// one document that needs no server. `engine`: apps/studio/offline/engine.cpp, compiled for WebAssembly,
/// gzip; `licenses`: of all that it contains. The same input gives the same bytes. Throws InputError for a
/// folder without scenes; `left_out` is told of each scene that is no example, and why.
[[nodiscard]] std::string make_offline_page(std::string_view engine, std::string_view licenses,
                                            const std::filesystem::path& scenes,
                                            const std::function<void(const std::string&)>& left_out);

// Files of a scene, made in memory: a request names one of a list, never a path.

struct DownloadName {
    std::string name;   ///< "drawing_pdf", "plc_codesys": what a request may ask for
    std::string words;  ///< "Workshop drawing (PDF)"
};

[[nodiscard]] std::vector<DownloadName> download_names();

/// Those that exist for this scene once it has a motion.
[[nodiscard]] std::vector<std::string> downloads_of(const Scene& scene);

/// The file, solved for where it needs a solve. Throws InputError for a name that is none, and for a file
/// this scene has not (the cam of a scene without one, anything of a scene without a motion).
[[nodiscard]] StudioAnswer studio_download(const std::string& what, const StudioScene& given,
                                           const SolveControl& control);

}  // namespace camopt::apps

namespace camopt {

// The files under assets/, compiled in.

/// "studio.js". Throws ModelError for a name that is not there.
[[nodiscard]] std::string_view studio_asset(std::string_view name);

}  // namespace camopt

namespace camopt::apps {

// What stands behind the studio's page: scenes in, solutions out, one solve at a time for each open page.
//
// A newer request of a page cancels the older one, which answers 409. Requests are JSON:
//
//   solve   { "page": its own name, "scene": TOML, "set": { KEY: value, … }, "units": "mm" | "in",
//             "laws": [key, …], "stage": … }
//   export  { "page", "scene", "set", "units", "what": one of download_names() }
//
// `set`, `units` (the scene's own), `laws` and `stage` may be left out. `stage` is "curve" (a look, to 1e-6
// instead of the scene's tolerance), "proof" (the default) or "rest" (what follows the proof; of the scene
// proved last nothing is solved again). The answer to `solve` is the object that studio_session.cpp
// describes. What is wrong with a scene answers 422, with a request 400: { "error": text }.

// What a request may take of this machine.
struct StudioLimits {
    double solve_seconds = 10.0;     ///< wall time of a solve, instead of the scene's solver.max_seconds
    double download_seconds = 60.0;  ///< of a solve whose file is asked for
    std::size_t pages = 8;           ///< open at the same time; the one not heard of for longest is forgotten
    std::size_t settings = 200;      ///< of a request
    std::size_t laws = 40;           ///< drawn beside the optimum
};

class StudioSession {
 public:
    explicit StudioSession(const StudioLimits& limits = {});
    ~StudioSession();
    StudioSession(const StudioSession&) = delete;
    StudioSession& operator=(const StudioSession&) = delete;

    /// Called from several threads at once; never throw for what a request holds.
    [[nodiscard]] StudioAnswer solve(const std::string& body);
    [[nodiscard]] StudioAnswer download(const std::string& body);

    /// The answer to `solve` of a page that opens; throws what is wrong with its scene.
    [[nodiscard]] std::string first(const std::string& scene);

    /// Running solves end soon; later ones answer 503.
    void stop();

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace camopt::apps

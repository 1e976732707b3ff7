// SPDX-License-Identifier: MIT
// What stands behind the studio's page: scenes in, solutions out, one solve at a time for each open page.
//
// A newer request of a page cancels the older one, which answers 409. Requests are JSON:
//
//   solve   { "page": its own name, "scene": TOML, "set": { KEY: value, … }, "laws": [key, …], "stage": … }
//   export  { "page", "scene", "set", "what": one of the names of studio_page.hpp }
//
// `set`, `laws` and `stage` may be left out. `stage` is "curve" (a look, to 1e-6 instead of the scene's
// tolerance), "proof" (the default) or "rest" (what follows the proof; of the scene proved last nothing is
// solved again). The answer to `solve` is the object that studio_session.cpp describes. What is wrong with a
// scene answers 422, with a request 400: { "error": text }.
#pragma once

#include "apps/studio/studio_server.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace camopt::apps {

// What a request may take of this machine.
struct StudioLimits {
    double solve_seconds = 10.0;     ///< wall time of a solve, whatever solver.max_seconds of the scene says
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

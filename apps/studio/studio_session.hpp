// SPDX-License-Identifier: MIT
// What stands behind the studio's page: scenes in, solutions out, one solve at a time for each open page.
//
// A newer request of a page cancels the older one, which answers 409. Requests are JSON:
//
//   solve   { "page": its own name, "scene": TOML, "set": { KEY: value, … }, "laws": [key, …], "stage": … }
//   export  { "page", "scene", "set", "what": one of the names of studio_downloads.hpp }
//
// `set`, `laws` and `stage` may be left out. `stage` is "curve" (a look, to 1e-6 instead of the scene's
// tolerance), "proof" (the default) or "rest" (what follows the proof; of the scene proved last nothing is
// solved again). The answer to `solve` is the object that studio_answer.hpp describes. What is wrong with a
// scene answers 422, with a request 400: { "error": text }.
#pragma once

#include "apps/studio/studio_limits.hpp"
#include "apps/studio/studio_server.hpp"

#include <memory>
#include <string>

namespace camopt::apps {

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

// SPDX-License-Identifier: MIT
// The studio's page: the page of a report with controls beside it, everything in one document.
#pragma once

#include "apps/studio/studio_server.hpp"

#include <string>

namespace camopt::apps {

/// What a fresh page begins with.
struct StudioStart {
    std::string name;   ///< of the scene file, for people
    std::string scene;  ///< TOML
};

/// A rise between two dwells, for who comes without a scene.
[[nodiscard]] StudioStart first_scene();

/// answer: to the first solve (studio_answer.hpp). With a content policy that lets this document's own
/// scripts run and no others, and connect to nothing but this server.
[[nodiscard]] StudioAnswer studio_page(const StudioStart& start, const std::string& answer);

}  // namespace camopt::apps

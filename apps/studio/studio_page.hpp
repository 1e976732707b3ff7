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

/// With a content policy that lets this document's own scripts and styles run, and no others.
[[nodiscard]] StudioAnswer studio_page(const StudioStart& start);

}  // namespace camopt::apps

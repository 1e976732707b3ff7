// SPDX-License-Identifier: MIT
// In the place of studio_server.cpp where the build has no HTTP library.
#include "apps/studio/studio_server.hpp"
#include "core/errors.hpp"

namespace camopt::apps {

struct StudioServer::State {};

StudioServer::StudioServer(StudioHandlers, const StudioServerOptions&) {
    throw UnavailableError(
        "camopt studio: this camopt was built without cpp-httplib, which serves the page; install "
        "libcpp-httplib-dev and build again. `camopt solve SCENE --out DIR` writes a report without it");
}

StudioServer::~StudioServer() = default;

std::string StudioServer::address() const {
    return {};
}

bool StudioServer::running() const {
    return false;
}

}  // namespace camopt::apps

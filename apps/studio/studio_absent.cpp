// SPDX-License-Identifier: MIT
// In the place of studio_server.cpp where the build has no HTTP library.
#include "apps/studio/studio_server.hpp"
#include "core/errors.hpp"

namespace camopt::apps {

struct StudioServer::State {};

bool StudioServer::available() {
    return false;
}

StudioServer::StudioServer(StudioHandlers, const StudioServerOptions&) {
    throw UnavailableError(
        "this camopt was built without cpp-httplib (libcpp-httplib-dev), which serves the studio");
}

StudioServer::~StudioServer() = default;

std::string StudioServer::address() const {
    return {};
}

bool StudioServer::running() const {
    return false;
}

}  // namespace camopt::apps

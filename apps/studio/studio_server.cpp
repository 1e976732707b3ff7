// SPDX-License-Identifier: MIT
#include "apps/studio/studio_server.hpp"

#include "apps/studio/random_token.hpp"
#include "core/platform/parts.hpp"

extern "C" const void* camopt_part_http(const char* build);  // loopback_server.cpp

namespace camopt::apps {

namespace {

constexpr PartInfo http_info = {"http",
                                "pages of the studio",
                                "cpp-httplib",
                                "camopt-parts",
                                "libcpp-httplib-dev",
                                "CAMOPT_WITH_HTTPLIB",
                                PartBuild::CAMOPT_PART_HTTP};

const StudioPart& http_part() {
    return opened_part<StudioPart, http_info, camopt_part_http>();
}

}  // namespace

bool studio_server_available() {
    return part_available(http_info);
}

std::string studio_server_remedy() {
    return part_remedy(http_info);
}

std::unique_ptr<StudioServer> serve_studio(StudioHandlers handlers, const StudioServerOptions& options) {
    return http_part().serve(std::move(handlers), options, random_token());
}

}  // namespace camopt::apps

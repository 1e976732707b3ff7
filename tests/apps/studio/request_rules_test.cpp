// SPDX-License-Identifier: MIT
#include "apps/studio/request_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace camopt::apps {
namespace request_rules_test {

const StudioPlace place{.port = 4000, .token = "0123456789abcdef", .body_bytes = 100};

RequestHead page_request() {
    return {"GET", "/0123456789abcdef/", {{"Host", "127.0.0.1:4000"}}};
}

RequestHead solve_request() {
    return {"POST",
            "/0123456789abcdef/solve",
            {{"Host", "127.0.0.1:4000"}, {"Content-Type", "application/json"}, {"Content-Length", "12"}}};
}

int with(RequestHead request, const std::string& name, const std::string& value) {
    std::erase_if(request.headers, [&](const auto& header) { return header.first == name; });
    request.headers.emplace_back(name, value);
    return refusal_of(request, place);
}

TEST(RequestRules, AdmitItsOwnPage) {
    EXPECT_EQ(refusal_of(page_request(), place), 0);
    EXPECT_EQ(refusal_of(solve_request(), place), 0);
    EXPECT_EQ(with(solve_request(), "origin", "http://127.0.0.1:4000"), 0);
    EXPECT_EQ(with(page_request(), "Sec-Fetch-Site", "none"), 0);
}

TEST(RequestRules, RefuseWhatComesFromElsewhere) {
    for (const char* host : {"localhost:4000", "127.0.0.1", "127.0.0.1:4001", "evil.example:4000", ""})
        EXPECT_EQ(with(page_request(), "Host", host), 403) << host;
    RequestHead nameless = page_request();
    nameless.headers.clear();
    EXPECT_EQ(refusal_of(nameless, place), 403);
    RequestHead two = page_request();
    two.headers.emplace_back("host", "127.0.0.1:4000");
    EXPECT_EQ(refusal_of(two, place), 403);
    for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1:4000", "http://127.0.0.1"})
        EXPECT_EQ(with(solve_request(), "Origin", origin), 403) << origin;
    EXPECT_EQ(with(page_request(), "sec-fetch-site", "same-site"), 403);
}

TEST(RequestRules, RefuseForeignOriginBeforeTokenCheck) {
    RequestHead lost = page_request();
    lost.target = "/0/";
    EXPECT_EQ(refusal_of(lost, place), 404);
    EXPECT_EQ(with(lost, "Host", "evil.example"), 403);
    EXPECT_EQ(with(page_request(), "Host", "evil.example"), 403);
}

TEST(RequestRules, KnowThreeTargets) {
    for (const char* target : {"", "/", "/0123456789abcdef", "/0123456789abcdeF/", "/0123456789abcdef/page",
                               "/0123456789abcdef/?", "/0123456789abcdef/solve/", "/0123456789abcde/"}) {
        RequestHead request = page_request();
        request.target = target;
        EXPECT_EQ(refusal_of(request, place), 404) << target;
    }
    RequestHead wrong = solve_request();
    wrong.method = "PUT";
    EXPECT_EQ(refusal_of(wrong, place), 405);
}

TEST(RequestRules, RefuseUnfitBodies) {
    EXPECT_EQ(with(solve_request(), "Content-Length", "100"), 0);
    EXPECT_EQ(with(solve_request(), "Content-Length", "101"), 413);
    EXPECT_EQ(with(solve_request(), "Content-Length", "99999999999999999999999"), 413);
    for (const char* length : {"", "-1", "1x", " 1", "0x10"})
        EXPECT_EQ(with(solve_request(), "Content-Length", length), 400) << length;
    EXPECT_EQ(with(solve_request(), "Content-Type", "text/plain"), 415);
    EXPECT_EQ(with(solve_request(), "Content-Encoding", "gzip"), 415);
    EXPECT_EQ(with(solve_request(), "Transfer-Encoding", "chunked"), 411);
    EXPECT_EQ(with(solve_request(), "Expect", "100-continue"), 417);
    EXPECT_EQ(with(page_request(), "Content-Length", "5"), 400);
    RequestHead endless = solve_request();
    std::erase_if(endless.headers, [](const auto& header) { return header.first == "Content-Length"; });
    EXPECT_EQ(refusal_of(endless, place), 411);
}

}  // namespace request_rules_test
}  // namespace camopt::apps

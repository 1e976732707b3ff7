// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"

#include "apps/studio/random_token.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

using Json = nlohmann::ordered_json;

/// Every law by key and title.
Json catalogue_json() {
    Json laws = Json::array();
    for (const LawInfo& law : law_catalogue()) laws.push_back({{"key", law.key}, {"title", law.title}});
    return laws;
}

}  // namespace

StudioStart first_scene() {
    return {"new scene", R"(title = "A rise between two dwells"

[motion]
type = "DRD"
lift_mm = 10
rise_deg = 120
speed_rpm = 300

[spline]
degree = 3
segments = 32

[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
)"};
}

PageHtml studio_html(const StudioStart& start, const std::string& answer) {
    Json data = Json::parse(answer);
    // The page's own data, and beside it what the studio's scripts begin with.
    Json page = std::move(data["data"]);
    data.erase("data");
    data["name"] = start.name;
    data["catalogue"] = catalogue_json();
    data["files"] = Json::array();
    for (const DownloadName& file : download_names())
        data["files"].push_back({{"name", file.name}, {"words", file.words}});
    page["studio"] = std::move(data);
    PageHtml html;
    html.title = "camopt studio";
    html.data = page.dump(-1, ' ', false, Json::error_handler_t::replace);
    html.solids = true;  // the next scene may be three-dimensional
    for (const char* const name : {"controls.js", "handles.js", "panel.js", "studio.js", "gallery.js"})
        html.scripts.emplace_back(studio_asset(name));
    html.styles.emplace_back(studio_asset("studio.css"));
    return html;
}

StudioAnswer studio_page(const StudioStart& start, const std::string& answer) {
    PageHtml html = studio_html(start, answer);
    html.connect = "'self'";
    html.nonce = random_token();
    return {
        .type = "text/html; charset=utf-8",
        .body = page_html(html),
        .content_policy = fmt::format("default-src 'none'; script-src 'nonce-{}'; style-src 'unsafe-inline'; "
                                      "img-src data: blob:; connect-src 'self'; base-uri 'none'; "
                                      "form-action 'none'; frame-ancestors 'none'",
                                      html.nonce)};
}

}  // namespace camopt::apps

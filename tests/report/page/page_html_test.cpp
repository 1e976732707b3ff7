// SPDX-License-Identifier: MIT
// The page around the data: nothing of a scene ends it early, nothing is loaded from anywhere.
#include "report/page/result_page.hpp"
#include "tests/report/page/page_reading.hpp"
#include "tests/report/sample_solution.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace page_html_test {

using testing_support::count_of;
using testing_support::data_of;
using testing_support::data_text;

TEST(PageHtml, HoldsTheDataAsTheyAre) {
    const Solution solution = test::cam_solution();
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", "title = \"x\"\n"};
    EXPECT_EQ(data_of(report_html(solution, origin)), nlohmann::json::parse(page_data(solution, origin)));
}

TEST(PageHtml, ScriptEndInSceneIsHarmless) {
    Solution solution = test::cam_solution();
    const std::string hostile =
        "</script><script>alert(1)</script><!-- <SCRIPT> \"'&@DATA@ @SCRIPTS@ @TITLE@";
    const std::string plain = report_html(solution, {"scene.toml", "", "title = 1\n"});
    solution.scene.title = hostile;
    solution.notes = {hostile};
    const std::string html = report_html(solution, {hostile, hostile, hostile + "\n"});
    EXPECT_EQ(count_of(html, "<script"), count_of(plain, "<script"));
    EXPECT_EQ(count_of(html, "</script"), count_of(plain, "</script"));
    EXPECT_EQ(count_of(html, "<!--"), count_of(plain, "<!--"));
    const nlohmann::json data = data_of(html);
    EXPECT_EQ(data.at("scene").at("text"), hostile + "\n");
    EXPECT_EQ(data.at("title"), hostile);
    EXPECT_EQ(data.at("appendix").at("command"), hostile);
    EXPECT_EQ(data_text(html).find('<'), std::string::npos);
    EXPECT_NE(html.find("<title>&lt;/script&gt;"), std::string::npos);
    EXPECT_EQ(count_of(html, "</html>"), 1);
}

TEST(PageHtml, InvalidBytesAreReplaced) {
    Solution solution = test::sample_solution();
    solution.scene.title = "cut \xff off \xe2\x80";
    EXPECT_EQ(data_of(report_html(solution)).at("title"), "cut \xef\xbf\xbd off \xef\xbf\xbd");
}

TEST(PageHtml, LoadsNothing) {
    PageHtml page{"solid", page_data(test::cam_solution()), true};
    const std::string html = page_html(page);
    for (const char* const outside : {"<img", "<iframe", "src=\"", "href=\"http", "@import", "url(http"})
        EXPECT_EQ(count_of(html, outside), 0) << outside;
    EXPECT_EQ(count_of(html, "<link"),
              count_of(html, "<link rel=\"icon\" href=\"data:"));  // no icon is asked for
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    EXPECT_NE(html.find("connect-src 'none'"), std::string::npos);
}

TEST(PageHtml, StaysSmallWhereNothingIsSolid) {
    constexpr std::size_t most = 400'000;
    EXPECT_LT(report_html(test::cam_solution()).size(), most);
    EXPECT_FALSE(page_needs_solids(test::cam_solution()));
    EXPECT_EQ(report_html(test::cam_solution()).find("CamoptThree="), std::string::npos);
}

TEST(PageHtml, ShowsNearestMotionWhereNoneExists) {
    Solution solution = test::infeasible_cam_solution();
    solution.scene.limits.pressure_angle->value = 5.0 * units::degree;
    const std::string html = report_html(solution);
    EXPECT_NE(html.find("The curves show the motion that violates the limits least"), std::string::npos);
    EXPECT_NE(html.find("\"key\":\"acceleration\""), std::string::npos);
    EXPECT_FALSE(solution.motion);
}

TEST(PageHtml, CarriesTheLicencesOfItsLibraries) {
    const std::string html = page_html({"solid", "{}", true});
    for (const char* const holder : {"Leon Sorokin", "three.js authors", "Permission is hereby granted"})
        EXPECT_GT(count_of(html, holder), 0) << holder;
}

TEST(PageHtml, MoreScriptsRunAfterItsOwn) {
    PageHtml page{"studio", "{}", false};
    page.scripts = {"window.more = true;"};
    page.styles = {".more{}"};
    page.connect = "'self'";
    const std::string html = page_html(page);
    EXPECT_GT(html.find("window.more"), html.find("camopt.report ="));
    EXPECT_NE(html.find("connect-src 'self';"), std::string::npos);
}

}  // namespace page_html_test
}  // namespace camopt

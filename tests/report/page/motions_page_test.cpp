// SPDX-License-Identifier: MIT
// Pages of many motions: every row with its numbers, its marks, its scene.
#include "report/compare/comparison_document.hpp"
#include "report/page/page_html.hpp"
#include "report/sweep/pareto_document.hpp"
#include "report/sweep/sweep_document.hpp"
#include "tests/report/page/page_reading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace camopt {
namespace motions_page_test {

using nlohmann::json;
using testing_support::count_of;
using testing_support::data_of;

constexpr const char* scene_text =
    "title = \"front\"\n[motion]\ntype = \"DRD\"\n[objective]\nvelocity = 1\nacceleration = 1\n";

Scene small_scene() {
    Scene scene;
    scene.title = "front";
    scene.motion.type = MotionType::drd;
    scene.objective.velocity = 1.0;
    scene.objective.acceleration = 1.0;
    return scene;
}

/// As the page's script puts it together.
std::string scene_of(const json& data, std::size_t item) {
    std::vector<std::string> lines(1);
    for (const char c : data.at("scenes").at("base").get<std::string>()) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    }
    for (const json& edit : data.at("scenes").at("edits").at(item)) {
        if (edit[0].get<int>() < 0) return edit[1].get<std::string>();
        lines[edit[0].get<std::size_t>()] = edit[1].get<std::string>();
    }
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? "\n" : "") + lines[i];
    return text;
}

/// The table of motions of a page.
json motions_of(const std::string& html) {
    return data_of(html).at("tables").at(0);
}

json motions_of(const Comparison& comparison, const RunOrigin& origin = {}) {
    return motions_of(document_html(comparison_document(comparison, origin), origin));
}

/// A number, or a number and its text.
json column(const json& data, const std::string& key) {
    for (const json& one : data.at("columns")) {
        if (one.at("key") != key) continue;
        json values = json::array();
        for (const json& value : one.at("values")) values.push_back(value.is_array() ? value[0] : value);
        return values;
    }
    throw std::runtime_error("no column " + key);
}

TEST(ComparisonHtml, ContainsEveryLawAndScene) {
    const Comparison comparison = compare(small_scene());
    const json data = motions_of(comparison, {"front.toml", "", scene_text});
    ASSERT_EQ(data.at("items").at("names").size(), comparison.rows.size());
    for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
        const ComparisonRow& row = comparison.rows[i];
        if (row.motion) {
            EXPECT_NEAR(column(data, "peaks.velocity.value")[i].get<double>(), row.peaks.velocity.value,
                        1e-6);
        }
        const std::string scene = scene_of(data, i);
        if (row.is_optimum()) {
            EXPECT_EQ(scene, scene_text);
        } else if (!row.feasible) {
            EXPECT_EQ(scene.find("\"" + row.key + "\""), std::string::npos) << row.key;
        } else {
            EXPECT_NE(scene.find("\"" + row.key + "\""), std::string::npos) << row.key;
        }
    }
    const json& overlay = data.at("overlay").at("curves").at(1);
    ASSERT_EQ(overlay.at("lines").size(), comparison.rows.size());
}

TEST(ComparisonHtml, AnInfinitePeakIsASign) {
    const Comparison comparison = compare(small_scene());
    const json data = motions_of(comparison);
    EXPECT_TRUE(data.at("scenes").is_null());
    int infinite = 0;
    for (const json& value : column(data, "peaks.jerk.value")) infinite += value == "∞" ? 1 : 0;
    EXPECT_GT(infinite, 0);
}

TEST(ParetoHtml, ThePointsHaveTheirScenes) {
    const Scene scene = small_scene();
    FrontRequest request;
    request.points = 4;
    const ParetoFront front = pareto_front(scene, request);
    const ParetoPicture picture{front, scene};
    SweepIdentity identity;
    identity.scene_file = "front.toml";
    const std::string html =
        document_html(pareto_document(picture, identity), {"front.toml", "", scene_text});
    const json data = motions_of(html);
    ASSERT_EQ(data.at("items").at("names").size(), front.points.size());
    EXPECT_EQ(count_of(data_of(html).at("pictures").at(0).get<std::string>(), "<svg"), 1);
    for (std::size_t i = 0; i < front.points.size(); ++i) {
        EXPECT_NEAR(column(data, "first")[i].get<double>(), front.points[i].value[0], 1e-6);
        const std::string text = scene_of(data, i);
        EXPECT_EQ(text.find("velocity") != std::string::npos, true);
        if (front.points[i].cap) {
            EXPECT_NE(text.find("[limits]"), std::string::npos) << text;
        }
    }
}

TEST(SweepHtml, RowsContainSettingsAndEscapedText) {
    SweepTable table;
    table.columns.keys = {"objective.velocity"};
    for (int i = 0; i < 4; ++i) {
        SweepRow row;
        row.number = i;
        row.settings = {0.25 * (i + 1)};
        row.verdict = i == 3 ? Verdict::failed : Verdict::optimal;
        row.reason = i == 3 ? "signal 11 </script>" : "";
        if (i < 3) row.objective = 1.0 + i;
        row.figures = {1.5, 6.0, 50.0};
        table.rows.push_back(row);
    }
    SweepIdentity identity;
    identity.scene_file = "front.toml";
    identity.scene_text = scene_text;
    identity.axes = {"--vary objective.velocity=0.25:1:4"};
    const Scene scene = small_scene();
    const json data =
        motions_of(document_html(sweep_document({table, scene}, identity), {"front.toml", "", scene_text}));
    ASSERT_EQ(data.at("items").at("names").size(), 4U);
    EXPECT_EQ(column(data, "reason")[3], "signal 11 </script>");
    EXPECT_NE(scene_of(data, 1).find("0.5"), std::string::npos);
    EXPECT_EQ(data.at("items").at("tones")[3], "bad");
}

}  // namespace motions_page_test
}  // namespace camopt

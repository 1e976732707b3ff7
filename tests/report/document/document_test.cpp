// SPDX-License-Identifier: MIT
// Documents: what a filler adds in one line appears in every format.
#include "report/page/page_html.hpp"
#include "tests/report/page/page_reading.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace camopt {
namespace document_test {

using testing_support::data_of;
using Json = nlohmann::json;
using Kind = Sentence::Kind;

Document sample() {
    Document document{"Sample"};
    Section& section = document.sections.emplace_back();
    section.sentences = {{Kind::headline, "speed", "As fast as it gets"}, {Kind::note, "", "of a test"}};
    section.tables = {
        {"rollers", "Rollers", {{.key = "name", .left = true}, {"radius", {}, millimetres_shown}}}};
    section.tables.front().rows = {{Cell("first"), Cell(0.0125)}};
    return document;
}

TEST(Document, NewFigureIsInEveryFormat) {
    Document document = sample();
    document.sections.front().figures.push_back(
        {{"speed", "largest speed", rpm_shown}, Cell(16.0, rpm_shown)});
    const std::string number = round_trip_text(rpm_shown.of(16.0));
    EXPECT_NE(console_text(document).find("largest speed: 152.789 rpm"), std::string::npos);
    EXPECT_NE(document_markdown(document, {}).find("largest speed: 152.789 rpm"), std::string::npos);
    const Json figure = data_of(document_html(document))["figures"][0];
    EXPECT_EQ(figure["name"], "largest speed");
    EXPECT_EQ(figure["value"], "152.789 rpm");
    EXPECT_NE(cells_csv(document).find("figures,speed,speed_rpm," + number + ",rpm\n"), std::string::npos);
    EXPECT_EQ(Json::parse(document_json(document))["speed_rpm"], rpm_shown.of(16.0));
}

TEST(Document, NewRowIsInEveryFormat) {
    Document document = sample();
    document.sections.front().tables.front().rows.push_back({Cell("second"), Cell(0.0375)});
    EXPECT_NE(console_text(document).find("second       37.5\n"), std::string::npos)
        << console_text(document);
    EXPECT_NE(document_markdown(document, {}).find("| second | 37.5 |"), std::string::npos);
    const Json rows = data_of(document_html(document))["tables"][0]["rows"];
    EXPECT_EQ(rows[1], (Json{"second", "37.5"}));
    EXPECT_NE(cells_csv(document).find("rollers,2,radius_mm,37.5,mm\n"), std::string::npos);
    EXPECT_EQ(Json::parse(document_json(document))["rollers"][1],
              (Json{{"name", "second"}, {"radius_mm", 37.5}}));
}

TEST(Document, FigureWithoutTitleIsOnlyInFiles) {
    Document document = sample();
    document.sections.front().figures.push_back({{"noise", {}, millimetres_shown}, Cell(0.5)});
    EXPECT_EQ(console_text(document), console_text(sample()));
    EXPECT_EQ(Json::parse(document_json(document))["noise_mm"], 500.0);
}

TEST(Document, NumberNamesUnitThatColumnLacks) {
    Document document = sample();
    Cell cell(std::optional(2.0), ShownUnit("m/s²"));
    cell.bound = Bound::at_most;
    document.sections.front().figures.push_back({{"given", "given"}, cell});
    EXPECT_NE(console_text(document).find("given: at most 2 m/s²"), std::string::npos);
    EXPECT_EQ(Json::parse(document_json(document))["given"], (Json{{"value", 2}, {"unit", "m/s²"}}));
    EXPECT_NE(cells_csv(document).find("figures,given,given,2,m/s²\n"), std::string::npos);
}

TEST(Document, WordsReplaceNumberExceptInFiles) {
    Document document = sample();
    document.sections.front().figures.push_back(
        {{"turn", "turn", degrees_shown}, Cell(units::turn).in_words("all")});
    EXPECT_NE(console_text(document).find("turn: all\n"), std::string::npos);
    EXPECT_EQ(Json::parse(document_json(document))["turn_deg"], 360);
}

TEST(Document, ColumnWithoutValuesIsNotShown) {
    Document document = sample();
    Table& table = document.sections.front().tables.front();
    table.columns.push_back({"torque"});
    table.rows.front().push_back(Cell());
    EXPECT_EQ(console_text(document), console_text(sample()));
    EXPECT_EQ(document_markdown(document, {}), document_markdown(sample(), {}));
    EXPECT_TRUE(Json::parse(document_json(document))["rollers"][0]["torque"].is_null());
}

TEST(Document, PartsReachOnlyTheirReaders) {
    Document document = sample();
    Section& section = document.sections.front();
    section.sentences.push_back({Kind::remark, "", "for the terminal", Where::console});
    section.figures.push_back({{.key = "gap", .title = "gap", .where = Where::markdown}, Cell(0.5)});
    section.tables.front().columns.push_back({.key = "part", .left = true, .where = Where::page});
    section.tables.front().rows.front().emplace_back("left one");
    const std::string console = console_text(document), markdown = document_markdown(document, {});
    const std::string page = data_of(document_html(document)).dump();
    const auto readers = [&](const char* words) {
        return (console.find(words) != std::string::npos ? Where::console : 0) +
               (markdown.find(words) != std::string::npos ? Where::markdown : 0) +
               (page.find(words) != std::string::npos ? Where::page : 0);
    };
    EXPECT_EQ(readers("for the terminal"), Where::console);
    EXPECT_EQ(readers("gap"), Where::markdown);
    EXPECT_EQ(readers("left one"), Where::page);
    EXPECT_EQ(readers("first"), Where::everywhere);
}

TEST(Document, TitledSectionIsAList) {
    Document document = sample();
    document.sections.push_back({.title = "The motor", .sentences = {{Kind::remark, "", "It turns."}}});
    EXPECT_NE(console_text(document).find("\nThe motor\n  It turns.\n"), std::string::npos);
    EXPECT_NE(document_markdown(document, {}).find("\n## The motor\n\n- It turns.\n"), std::string::npos);
    const Json list = data_of(document_html(document))["lists"][0];
    EXPECT_EQ(list["title"], "The motor");
    EXPECT_EQ(list["sentences"], Json{"It turns."});
}

TEST(Document, RowsLeadToTheirResultFolders) {
    Document document = sample();
    document.sections.front().tables.front().folders = {"one"};
    EXPECT_NE(document_markdown(document, {}).find("| [first](one/report.md) |"), std::string::npos);
    EXPECT_EQ(data_of(document_html(document))["tables"][0]["folders"], Json{"one"});
}

TEST(Document, CurvesArePictureAndTable) {
    Document document = sample();
    Curves& curves = document.sections.front().curves.emplace();
    curves.key = "lifts";
    curves.angle_key = "crank";
    curves.angles = {0.0, 90.0};
    Curve curve{"intake", "Lifts", "Intake", "l", millimetres_shown};
    curve.values = {1.5, std::nan("")};
    curves.curves = {curve};
    std::map<std::string, std::string> files;
    for (const FolderFile& file : document_files(document, {})) files[file.name] = file.text;
    EXPECT_EQ(files.at("lifts.csv"), "crank_deg,intake_mm\n0,1.5\n90,\n");
    EXPECT_TRUE(files.contains("lifts.svg") && files.contains("report.md") && files.contains("report.html") &&
                files.contains("document.json") && files.contains("tables.csv"));
}

}  // namespace document_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// A paper's report as text, Markdown, JSON, CSV and picture, against a small one made by hand.
#include "benchmarks/papers/paper_json.hpp"
#include "output/papers/paper_output.hpp"
#include "tests/output/well_formed.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {

namespace paper_report_test {

PaperReport small_report() {
    PaperReport report;
    report.id = "000";
    report.title = "A small report";
    report.source = "Nobody, \"Nothing\"";
    report.introduction = "Made by hand.";
    report.assumptions = {"a radius of 0.5 in"};
    report.tables = {{"table_1",
                      "Table 1",
                      "Of two rows.",
                      {{"time_s", "time", "s", 3}, {"words", "words", ""}, {"value_in", "value", "in", 4}},
                      {{1.0 / 3.0, std::string("as printed, \"rounded\""), 2.0},
                       {0.5, std::string("none"), PaperCell{}},
                       {0.75, std::string("not a number"), std::nan("")}}}};
    report.figures = {{"figure_1", "Fig. 1 <&>", "x", "y", {{"a line", {0, 1, 2}, {0, std::nan(""), 3}}}},
                      {"figure_2", "Fig. 2", "x", "y", {{"points", {1, 10, 0}, {1e-3, 1e2, 5}, true}}}};
    report.figures[1].logarithmic = true;
    report.notes = {"A note."};
    return report;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(PaperReportText, SaysEverythingAndWarns) {
    PaperReport report = small_report();
    const std::string text = paper_report_text(report);
    for (const char* words : {"Paper 000: A small report", "Nobody", "time [s]", "0.333", "as printed",
                              "1. a radius", "figure_1.svg", "1. A note."})
        EXPECT_TRUE(holds(text, words)) << words;
    EXPECT_FALSE(holds(text, "NOT COMPUTED"));
    EXPECT_FALSE(holds(text, "nan"));
    report.faults = {"a row is missing"};
    EXPECT_TRUE(holds(paper_report_text(report), "NOT COMPUTED OR NOT PROVED\n1. a row is missing"));
    EXPECT_TRUE(holds(paper_report_markdown(report), "](figure_2.svg)"));
}

TEST(PaperReportJson, ReadsBackExactly) {
    const auto json = nlohmann::json::parse(paper_report_json(small_report()));
    EXPECT_EQ(json["paper"], "000");
    const auto& rows = json["tables"][0]["rows"];
    EXPECT_EQ(rows[0]["time_s"].get<double>(), 1.0 / 3.0);
    EXPECT_EQ(rows[0]["words"], "as printed, \"rounded\"");
    EXPECT_TRUE(rows[1]["value_in"].is_null());
    EXPECT_TRUE(rows[2]["value_in"].is_null());
    EXPECT_TRUE(json["figures"][0]["series"][0]["y"][1].is_null());
    EXPECT_EQ(json["assumptions"].size(), 1U);
}

TEST(PaperReportCsv, OneLineARow) {
    const PaperReport report = small_report();
    EXPECT_EQ(paper_table_csv(report.tables[0]),
              "time_s,words,value_in\n0.3333333333333333,\"as printed, \"\"rounded\"\"\",2\n0.5,none,\n"
              "0.75,not a number,\n");
    EXPECT_EQ(paper_figure_csv(report.figures[0]), "series,x,y\na line,0,0\na line,1,\na line,2,3\n");
}

TEST(PaperFigureSvg, OmitsNonfiniteValues) {
    for (const PaperFigure& figure : small_report().figures) {
        const std::string svg = paper_figure_svg(figure);
        EXPECT_EQ(testing_support::xml_fault(svg), "");
        EXPECT_FALSE(holds(svg, "nan"));
        EXPECT_FALSE(holds(svg, "inf"));
    }
    // Two finite points on both sides of a gap: the line is broken into two.
    const std::string broken = paper_figure_svg(small_report().figures[0]);
    const std::string path = broken.substr(broken.find("<path"));
    EXPECT_EQ(std::count(path.begin(), path.begin() + static_cast<long>(path.find("/>")), 'M'), 2);
    // A point at x = 0 has no place on a logarithmic axis; one more circle is the legend's.
    const std::string points = paper_figure_svg(small_report().figures[1]);
    std::size_t circles = 0;
    for (std::size_t at = points.find("<circle"); at != std::string::npos;
         at = points.find("<circle", at + 1))
        ++circles;
    EXPECT_EQ(circles, 3U);
    EXPECT_EQ(testing_support::xml_fault(paper_figure_svg({"empty", "Empty", "x", "y", {}})), "");
}

}  // namespace paper_report_test

}  // namespace camopt

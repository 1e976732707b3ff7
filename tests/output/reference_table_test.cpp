// SPDX-License-Identifier: MIT
// The reference table as JSON and as a report, against a small table made by hand: one row proved, one
// failed, one infinite jerk.
#include "studies/papers/reference_table.hpp"

#include "output/papers/paper_output.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace camopt {

namespace reference_table_test {

using Json = nlohmann::json;

Solution proved_solution() {
    Solution solution;
    const SplineSpace space = SplineSpace::uniform(3, 2, 4, 1.0);
    Eigen::VectorXd control(space.dimension());
    control << 0, 0, 0, 0.5, 1, 1, 1;
    solution.curve = SplineCurve::from_coefficients(space, control);
    solution.peaks.velocity.value = 2.0;
    solution.peaks.acceleration.value = 8.0;
    solution.peaks.jerk.value = 32.0;
    solution.certificate.verdict = Verdict::optimal;
    solution.certificate.objective = 1.0 / 3.0;  // needs all digits
    solution.certificate.lower_bound = 1.0 / 3.0 - 1e-12;
    solution.certificate.gap = 1e-12;
    return solution;
}

Solution failed_solution() {
    Solution solution;
    solution.certificate.reason = Reason::time_limit;
    return solution;
}

ReferenceTable small_table() {
    ReferenceTable table;
    ConvergenceRow proved;
    proved.segments = 12;
    proved.printed = PeakFigures{2.0, 8.0, 32.0, 1.126};
    proved.printed_points = {0.0, 0.25, 0.5, 0.75, 1.0};
    proved.optimum = proved_solution();
    proved.optimum_points = {0.0, 0.125, 0.5, 0.875, 1.0};
    proved.note = "as printed, \"rounded\"";
    ConvergenceRow failed;
    failed.segments = 6;
    failed.optimum = failed_solution();
    table.convergence = {proved, failed};
    table.laws = {{"Parabolic",
                   "parabolic",
                   PeakFigures{2.0, 4.0, infinity, 0.0},
                   PeakFigures{2.0, 4.0, infinity, infinity},
                   {}},
                  {"Modified cycloidal", "", PeakFigures{1.76, 5.89, 67.0, 0.0}, {}, {}}};
    table.modified_sine_exact = {1.76, 5.53, 69.5, 1.0};
    table.limit = {0.9371963699, 1.7455851, 5.2837114, 54.609086};
    WeightEffectRow weight;
    weight.velocity = 0.4;
    weight.acceleration = 0.4;
    weight.jerk = 0.2;
    weight.optimum = failed_solution();
    table.weights = {weight};
    table.notes = {"A first note.", "A second one."};
    return table;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(ReferenceTableJson, InfiniteAndAbsentAreNull) {
    const Json json = Json::parse(reference_table_json(small_table()));
    const Json& parabolic = json.at("laws").at(0);
    EXPECT_TRUE(parabolic.at("exact").at("jerk").is_null());
    EXPECT_TRUE(parabolic.at("exact").at("objective").is_null());
    EXPECT_TRUE(parabolic.at("printed").at("jerk").is_null());
    EXPECT_TRUE(parabolic.at("loss_percent").is_null());
    EXPECT_TRUE(json.at("laws").at(1).at("exact").is_null());
    EXPECT_TRUE(json.at("laws").at(1).at("key").is_null());
    const Json& failed = json.at("convergence").at(1);
    EXPECT_TRUE(failed.at("printed").is_null());
    EXPECT_TRUE(failed.at("optimum").at("objective").is_null());
    EXPECT_TRUE(failed.at("optimum").at("peaks").is_null());
}

TEST(ReferenceTableJson, NumbersRoundTripExactly) {
    const Json json = Json::parse(reference_table_json(small_table()));
    const Json& row = json.at("convergence").at(0);
    EXPECT_EQ(row.at("optimum").at("objective").get<double>(), 1.0 / 3.0);
    EXPECT_EQ(row.at("optimum").at("bound").at("lower").get<double>(), 1.0 / 3.0 - 1e-12);
    EXPECT_EQ(row.at("optimum_points").at(1).get<double>(), 0.125);
    EXPECT_EQ(json.at("limit").at("objective").get<double>(), 0.9371963699);
    EXPECT_EQ(json.at("notes").size(), 2u);
}

TEST(ReferenceTableOutput, UnprovedRowsAreReported) {
    const ReferenceTable table = small_table();
    const Json json = Json::parse(reference_table_json(table));
    EXPECT_FALSE(json.at("all_optimal").get<bool>());
    EXPECT_EQ(json.at("unproved").size(), 2u);
    EXPECT_EQ(json.at("convergence").at(1).at("optimum").at("verdict"), "failed");
    EXPECT_EQ(json.at("convergence").at(1).at("optimum").at("reason"), "time_limit");
    const PaperReport report = paper_004_report(table);
    for (const std::string& text : {paper_report_text(report), paper_report_markdown(report)})
        for (const char* words : {"1. not proved optimal: n = 6 (failed: time_limit)",
                                  "2. not proved optimal: weights 0.4, 0.4, 0.2 (failed: time_limit)"})
            EXPECT_TRUE(holds(text, words)) << text;
    EXPECT_TRUE(holds(paper_table_csv(report.tables[1]), ",failed,"));
    EXPECT_TRUE(holds(paper_table_csv(report.tables[3]), ",failed\n"));
}

TEST(ReferenceTableOutput, ProvedTableHasNoWarning) {
    ReferenceTable table = small_table();
    table.convergence.pop_back();
    table.weights.clear();
    EXPECT_TRUE(Json::parse(reference_table_json(table)).at("all_optimal").get<bool>());
    EXPECT_TRUE(paper_004_report(table).faults.empty());
}

TEST(ReferenceTableText, ShowsPrintedValuesAndNotes) {
    const std::string text = paper_report_text(paper_004_report(small_table()));
    for (const char* words :
         {"V printed", "0.333333333", "0.937196370", "54.6090860", "∞", "optimal", "2. A second one."})
        EXPECT_TRUE(holds(text, words)) << words;
    EXPECT_FALSE(holds(text, "nan"));
    EXPECT_FALSE(holds(text, " inf "));
}

TEST(ReferenceTableFiles, MissingValuesAreEmptyCells) {
    const PaperReport report = paper_004_report(small_table());
    const auto rows_of = [&](std::size_t table) { return lines(paper_table_csv(report.tables[table])); };
    EXPECT_EQ(rows_of(0), 3u);
    EXPECT_EQ(rows_of(1), 3u);
    EXPECT_EQ(rows_of(2), 3u);
    EXPECT_EQ(rows_of(3), 2u);
    EXPECT_TRUE(holds(paper_table_csv(report.tables[2]), "Parabolic,2,2,4,4,,,\n"));
    for (const auto& [name, text] : paper_report_files(report)) {
        if (!name.ends_with(".csv")) continue;
        EXPECT_TRUE(holds(name, "table_") || holds(name, "figure_"));
        EXPECT_FALSE(holds(text, "inf")) << name;
    }
}

}  // namespace reference_table_test
}  // namespace camopt

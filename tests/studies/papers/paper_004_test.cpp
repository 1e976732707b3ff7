// SPDX-License-Identifier: MIT
// Paper 004 as a report: the printed figures beside those of the reference table; the catalogue of papers.
#include "benchmarks/papers/papers.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace camopt {

namespace paper_004_test {

TEST(Paper004, ReportHoldsTheReferenceTable) {
    const ReferenceTable reference = spline_versus_modified_sine();
    const PaperReport report = paper_004_report(reference);
    EXPECT_TRUE(report.faults.empty());
    ASSERT_EQ(report.tables.size(), 4U);
    EXPECT_EQ(report.figures.size(), 8U);
    const PaperTable& convergence = report.tables[1];
    ASSERT_EQ(convergence.rows.size(), reference.convergence.size());
    const auto place = [&](const std::string& key) {
        return static_cast<std::size_t>(std::ranges::find(convergence.columns, key, &PaperColumn::key) -
                                        convergence.columns.begin());
    };
    const auto& twelve = *std::ranges::find_if(
        convergence.rows, [](const auto& row) { return std::get<double>(row[0]) == 12.0; });
    EXPECT_EQ(std::get<double>(twelve[place("objective_printed")]), 0.9423);
    EXPECT_NEAR(std::get<double>(twelve[place("objective_ours")]), 0.940489277, 5e-9);
    EXPECT_NEAR(std::get<double>(twelve[place("difference")]), 0.940489277 - 0.9423, 5e-9);
    EXPECT_NEAR(std::get<double>(twelve[place("above_limit_percent")]), 100 * (0.940489277 / 0.937196370 - 1),
                1e-5);
    EXPECT_EQ(std::get<std::string>(twelve[place("verdict")]), "optimal");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(convergence.rows.back()[place("objective_printed")]));
    for (const PaperTable& table : report.tables)
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.key;
}

TEST(Paper004, AnUnprovedRowIsAFault) {
    ReferenceTable reference;
    reference.convergence.emplace_back();
    reference.convergence.back().segments = 12;
    EXPECT_EQ(paper_004_report(reference).faults.size(), 1U);
}

TEST(PaperCatalogue, FindsByIdAndListsKnown) {
    EXPECT_EQ(find_paper("004").id, "004");
    EXPECT_TRUE(std::ranges::is_sorted(paper_catalogue(), {}, &PaperInfo::id));
    EXPECT_NE(testing_support::refusal([] { (void)find_paper("007"); }).find("004"), std::string::npos);
}

TEST(PaperReport, ComparisonTakesTheDifference) {
    const PaperTable table =
        comparison_table("t", "T", {{"speed", "m/s", 2.0, 2.5, "chosen"}, {"none", "", {}, 1.0, ""}});
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(std::get<double>(table.rows[0][4]), 0.5);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[1][4]));
}

}  // namespace paper_004_test

}  // namespace camopt

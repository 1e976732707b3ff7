// SPDX-License-Identifier: MIT
// Pictures of sweeps and fronts, against tables made by hand.
#include "output/chart/sweep/sweep_svg.hpp"

#include "output/chart/studies/study_svg.hpp"
#include "output/csv/sweep_csv.hpp"
#include "tests/output/well_formed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

namespace camopt {
namespace sweep_svg_test {

using testing_support::count_of;
using testing_support::xml_fault;

SweepRow row_of(int number, std::vector<double> settings, double size) {
    SweepRow row;
    row.number = number;
    row.settings = std::move(settings);
    row.verdict = Verdict::optimal;
    row.objective = size;
    row.gap = 1e-9;
    row.any_curve_limit = 0.9 * size;
    row.figures = {1.5 + 0.1 * size, 6.0 - 0.2 * size, 50.0 + size, 8.0, 4.0, 30.0};
    row.on_front = number % 2 == 0;
    return row;
}

SweepTable weight_table() {
    SweepTable table;
    table.columns.keys = {"objective.velocity", "objective.acceleration", "objective.jerk"};
    int number = 0;
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; i + j <= 4; ++j)
            table.rows.push_back(
                row_of(number++, {i / 4.0, j / 4.0, (4 - i - j) / 4.0}, 1.0 + i * 0.1 + j * 0.2));
    return table;
}

SweepTable key_table() {
    SweepTable table;
    table.columns.keys = {"cam.base_radius_mm"};
    table.columns.dimensions = {DimensionIndex::base_radius};
    for (int i = 0; i < 6; ++i) {
        table.rows.push_back(row_of(i, {20.0 + i}, 2.0 - 0.1 * i));
        table.rows.back().dimensions[0] = 0.02;
    }
    for (const int shut : {0, 3}) {
        const std::vector<double> settings = table.rows[shut].settings;
        table.rows[shut] = {};
        table.rows[shut].number = shut;
        table.rows[shut].settings = settings;
    }
    table.rows[0].verdict = Verdict::infeasible;
    table.rows[3].reason = "worker died: signal 11 <&>";
    return table;
}

void empty_rows(SweepTable& table, Verdict verdict) {
    for (SweepRow& row : table.rows) {
        SweepRow empty;
        empty.number = row.number;
        empty.settings = row.settings;
        empty.verdict = verdict;
        row = empty;
    }
}

LawLosses some_losses() {
    LawLosses losses;
    losses.reference = {1.76, 5.53, 69.0};
    losses.laws.push_back({"near",
                           "Near <law>",
                           {1.7, 5.6, 55.0},
                           true,
                           4.0,
                           ClosestApproach{{0.2, 0.3, 0.5}, 2.5, true},
                           {1.6, 5.5, 40.0}});
    losses.laws.push_back({"far", "Far law", {1.6, 6.0, 500.0}, false, std::nullopt, std::nullopt, {}});
    losses.complete = true;
    return losses;
}

void expect_sound(const std::string& text) {
    EXPECT_EQ(xml_fault(text), "");
    EXPECT_FALSE(std::regex_search(text, std::regex("[^a-zA-Z](nan|inf)[^a-zA-Z]")));
}

std::set<int> marked_rows(const std::string& text) {
    std::set<int> rows;
    const std::regex mark("class=\"[^\"]*\\br(\\d+)\"");
    for (std::sregex_iterator found(text.begin(), text.end(), mark), end; found != end; ++found)
        rows.insert(std::stoi((*found)[1]));
    return rows;
}

TEST(XmlFault, FindsFaults) {
    EXPECT_EQ(xml_fault("<a><b x=\"1\"/>&amp;</a>"), "");
    EXPECT_NE(xml_fault("<a><b></a>"), "");
    EXPECT_NE(xml_fault("<a>&nbsp;</a>"), "");
    EXPECT_NE(xml_fault("<a x=\"></a>"), "");
}

TEST(SweepSvg, PeakWeightGrowsTowardsCorner) {
    SweepTable table = weight_table();
    table.rows = {row_of(0, {1, 0, 0}, 1.0), row_of(1, {0, 1, 0}, 2.0), row_of(2, {0, 0, 5}, 3.0),
                  row_of(3, {0, 0, 0}, 3.0)};
    const std::string svg = sweep_svg({table, Scene{}});
    std::array<double, 3> x{}, y{};
    const std::regex circle(
        "<circle cx=\"([^\"]*)\" cy=\"([^\"]*)\" r=\"[^\"]*\" class=\"cell c\\d+ r(\\d)\"");
    int found = 0;
    for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end && found < 3;
         ++at, ++found) {
        x[std::stoul((*at)[3])] = std::stod((*at)[1]);
        y[std::stoul((*at)[3])] = std::stod((*at)[2]);
    }
    ASSERT_EQ(found, 3);  // the row without weights has no place
    EXPECT_LT(x[0], x[2]);
    EXPECT_LT(x[2], x[1]);
    EXPECT_LT(y[2], y[0]);
    EXPECT_EQ(y[0], y[1]);
}

TEST(SweepSvg, CamPropertiesHavePanels) {
    SweepTable table = key_table();
    for (SweepRow& row : table.rows)
        if (row.is_feasible()) row.cam = {0.5 - 0.02 * row.number, 0.0127 * row.number, {}};
    const std::string svg = sweep_svg({table, Scene{}});
    expect_sound(svg);
    EXPECT_EQ(count_of(svg, "class=\"shut r0\""), 5 + 2);
    EXPECT_EQ(count_of(svg, "largest pressure angle (deg)"), 1);
    EXPECT_EQ(count_of(svg, "least convex radius of the cam (mm)"), 1);
    EXPECT_EQ(count_of(svg, "concave radius"), 0);  // no row has one

    table.columns.length_unit = LengthUnit::inch;
    const std::vector<SweepQuantity> quantities = drawn_quantities(table);
    ASSERT_EQ(quantities.size(), 7U);
    EXPECT_NEAR(*quantities[5].value(table.rows[2]), 0.46 * 180.0 / std::acos(-1.0), 1e-12);
    EXPECT_EQ(quantities[6].title, "least convex radius of the cam (in)");
    EXPECT_NEAR(*quantities[6].value(table.rows[2]), 1.0, 1e-12);
    EXPECT_FALSE(quantities[6].value(table.rows[0]));  // infeasible

    for (SweepRow& row : table.rows) row.cam.pressure_angle = 0.0;  // a flat face
    EXPECT_EQ(drawn_quantities(table).size(), 6U);

    table.columns.keys = {"limits.velocity"};  // one cam for every row
    table.columns.dimensions.clear();
    EXPECT_EQ(drawn_quantities(table).size(), 4U);
}

TEST(SweepSvg, TwoGridKeysGiveMaps) {
    SweepTable table = key_table();
    table.columns.keys = {"cam.base_radius_mm", "limits.pressure_angle_deg"};
    for (SweepRow& row : table.rows) row.settings = {20.0 + row.number / 3, 25.0 + row.number % 3};
    const std::string svg = sweep_svg({table, Scene{}});
    expect_sound(svg);
    EXPECT_EQ(count_of(svg, "class=\"cell c"), 5 * 4);
    EXPECT_EQ(marked_rows(svg).size(), 6U);
    table.rows[5].settings = {40.0, 40.0};  // no grid any more
    const std::string scattered = sweep_svg({table, Scene{}});
    expect_sound(scattered);
    EXPECT_EQ(marked_rows(scattered).size(), 6U);
}

TEST(SweepSvg, NothingFeasibleIsDrawn) {
    SweepTable table = key_table();
    empty_rows(table, Verdict::infeasible);
    expect_sound(sweep_svg({table, Scene{}}));
    SweepTable weights = weight_table();
    empty_rows(weights, Verdict::failed);
    const LawLosses losses = some_losses();
    expect_sound(sweep_svg({weights, Scene{}, &losses}));
}

class ParetoOutput : public testing::Test {
 protected:
    ParetoOutput() {
        scene.motion.type = MotionType::drd;
        scene.objective.velocity = 1.0;
        FrontRequest request;
        request.points = 5;
        front = pareto_front(scene, request);
    }
    Scene scene;
    ParetoFront front;
};

/// The limit no curve passes lies below the front: at the same acceleration its velocity is less.
TEST_F(ParetoOutput, TheLimitLiesBelowTheFront) {
    int seen = 0;
    for (const FrontPoint& point : front.points) {
        const auto limit = any_curve_point(front, point);
        if (!limit || !point.cap) continue;  // at the ends the limit goes on
        ++seen;
        EXPECT_LE((*limit)[0], point.value[0] + 1e-6);
        EXPECT_LE((*limit)[1], point.value[1] + 1e-6);
    }
    EXPECT_EQ(seen, static_cast<int>(front.points.size()) - 2);
}

}  // namespace sweep_svg_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Pictures of sweeps and fronts, of tables made by hand. What a picture holds: tests/golden/texts.cpp.
#include "report/chart/sweep/sweep_svg.hpp"

#include "report/chart/studies/pareto_svg.hpp"
#include "report/csv/sweep_csv.hpp"
#include "tests/report/sample_sweeps.hpp"
#include "tests/report/well_formed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>
#include <string>

namespace camopt {
namespace sweep_svg_test {

using testing_support::xml_fault;

void empty_rows(SweepTable& table, Verdict verdict) {
    for (SweepRow& row : table.rows) test::empty_row(row, verdict);
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
    SweepTable table = test::weight_table();
    table.rows = {test::sweep_row(0, {1, 0, 0}, 1.0), test::sweep_row(1, {0, 1, 0}, 2.0),
                  test::sweep_row(2, {0, 0, 5}, 3.0), test::sweep_row(3, {0, 0, 0}, 3.0)};
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
    SweepTable table = test::key_table();
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

TEST(SweepSvg, KeysOffTheirGridAreScattered) {
    SweepTable table = test::map_table();
    table.rows[5].settings = {40.0, 40.0};
    const std::string scattered = sweep_svg({table, Scene{}});
    expect_sound(scattered);
    EXPECT_EQ(marked_rows(scattered).size(), 6U);
}

TEST(SweepSvg, NothingFeasibleIsDrawn) {
    SweepTable table = test::key_table();
    empty_rows(table, Verdict::infeasible);
    expect_sound(sweep_svg({table, Scene{}}));
    SweepTable weights = test::weight_table();
    empty_rows(weights, Verdict::failed);
    const LawLosses losses = test::some_losses();
    expect_sound(sweep_svg({weights, Scene{}, &losses}));
}

/// The limit no curve passes lies below the front: at the same acceleration its velocity is less.
TEST(ParetoOutput, TheLimitLiesBelowTheFront) {
    Scene scene;
    scene.motion.type = MotionType::drd;
    scene.objective.velocity = 1.0;
    FrontRequest request;
    request.points = 5;
    const ParetoFront front = pareto_front(scene, request);
    int seen = 0;
    for (const FrontPoint& point : front.points) {
        const SweepFrontPlace& limit = point.row.front;
        if (!limit.limit_first || !point.cap) continue;  // at the ends the limit goes on
        ++seen;
        EXPECT_LE(*limit.limit_first, point.value[0] + 1e-6);
        EXPECT_LE(*limit.limit_second, point.value[1] + 1e-6);
    }
    EXPECT_EQ(seen, static_cast<int>(front.points.size()) - 2);
}

}  // namespace sweep_svg_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "solvers/structured/range_rows.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace camopt::structured {
namespace range_rows_test {

ConvexModel model_of(const Eigen::MatrixXd& rows, const Eigen::VectorXd& lower,
                     const Eigen::VectorXd& upper) {
    ConvexModel model;
    model.rows = rows.sparseView();
    model.row_lower = lower;
    model.row_upper = upper;
    model.x_lower = Eigen::VectorXd::Constant(rows.cols(), -infinity);
    model.x_upper = Eigen::VectorXd::Constant(rows.cols(), infinity);
    return model;
}

/// Gaps of all sides that exist, by what they were: row and sign.
void expect_gaps(const ConvexModel& model, const Eigen::VectorXd& x) {
    const RangeRows ranges(model);
    const Eigen::VectorXd image = ranges.matrix * x;
    Eigen::VectorXd slides(ranges.sides());
    ranges.slides(x, image, slides);
    const Eigen::VectorXd rows = model.rows * x;
    int seen = 0;
    for (Eigen::Index b = 0; b < ranges.sides(); ++b) {
        if (ranges.present[b] == 0.0) continue;
        ++seen;
        const RangeRows::Source& from = ranges.source[static_cast<std::size_t>(b)];
        const double value = from.row >= 0 ? rows[from.row] : x[from.variable];
        const double low = from.row >= 0 ? model.row_lower[from.row] : model.x_lower[from.variable];
        const double high = from.row >= 0 ? model.row_upper[from.row] : model.x_upper[from.variable];
        const double gap = from.sign > 0.0 ? value - low : high - value;
        EXPECT_NEAR(slides[b] - ranges.limit[b], gap, 1e-14) << "side " << b;
    }
    EXPECT_EQ(seen, ranges.sides_present);
}

TEST(RangeRows, TwinsFormRangeWithWidth) {
    Eigen::MatrixXd rows(4, 3);
    rows << 2, -1, -1,  //  2a − b − V <= 0
        0, 1, -1,       //
        -2, 1, -1,      // −2a + b − V <= 0
        0, 1, 1;        // b + V >= 0, that is −b − V <= 0
    const ConvexModel model = model_of(rows, Eigen::Vector4d(-infinity, -infinity, -infinity, 0),
                                       Eigen::Vector4d(0, 0.5, 0, infinity));
    const RangeRows ranges(model);
    EXPECT_EQ(ranges.ranges(), 2);
    ASSERT_EQ(ranges.groups.size(), 1U);
    EXPECT_EQ(ranges.groups[0].variable, 2);
    EXPECT_EQ(ranges.sides_present, 4);
    expect_gaps(model, Eigen::Vector3d(0.3, -0.7, 2.0));
}

TEST(RangeRows, OppositeRowsFormRangeWithoutWidth) {
    const ConvexModel model = model_of((Eigen::MatrixXd(2, 2) << 1, 3, -1, -3).finished(),
                                       Eigen::Vector2d(-infinity, -infinity), Eigen::Vector2d(2, 1));
    const RangeRows ranges(model);
    EXPECT_EQ(ranges.ranges(), 1);
    EXPECT_TRUE(ranges.groups.empty());
    expect_gaps(model, Eigen::Vector2d(0.5, 0.25));
}

TEST(RangeRows, SimilarRowsStaySeparate) {
    Eigen::MatrixXd rows(5, 3);
    rows << 1, 2, -1,  //
        -1, 2.5, -1,   // another size
        1, 2, -1,      // the same row again
        -1, -2, -1,    // twin of one of them
        1, -2, -1;     // two signs the same
    ConvexModel model = model_of(rows, Eigen::VectorXd::Constant(5, -infinity), Eigen::VectorXd::Ones(5));
    model.x_lower[0] = -3.0;
    model.x_upper[2] = 4.0;
    expect_gaps(model, Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_EQ(RangeRows(model).sides_present, 7);
}

TEST(RangeRows, MultipliersGoBackToTheirRows) {
    Eigen::MatrixXd rows(3, 2);
    rows << 1, -1, 1, 1, -1, -1;  // a − V <= 0; a + V = 5; −a − V <= 0
    const ConvexModel model =
        model_of(rows, Eigen::Vector3d(-infinity, 5, -infinity), Eigen::Vector3d(0, 5, 0));
    const RangeRows ranges(model);
    ASSERT_EQ(ranges.ranges(), 1);
    const Eigen::VectorXd multipliers =
        ranges.row_multipliers(Eigen::VectorXd::Constant(1, 7.0), Eigen::Vector2d(2.0, 3.0));
    EXPECT_EQ(multipliers, Eigen::Vector3d(3.0, 7.0, 2.0));
}

}  // namespace range_rows_test
}  // namespace camopt::structured

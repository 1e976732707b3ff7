// SPDX-License-Identifier: MIT
#include "splines/curve.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace curve_test {

using testing_support::refusal;

struct Shape {
    int degree, continuity, segments;
};

/// de Boor's algorithm on the knots, written here on its own so that the library is not checked against
/// itself.
double de_boor(const std::vector<double>& knots, const Eigen::VectorXd& c, int p, double x) {
    int k = p;
    while (k + 1 < static_cast<int>(c.size()) && knots[k + 1] <= x) ++k;
    std::vector<double> d(p + 1);
    for (int j = 0; j <= p; ++j) d[j] = c[j + k - p];
    for (int r = 1; r <= p; ++r) {
        for (int j = p; j >= r; --j) {
            const double left = knots[j + k - p];
            const double alpha = (x - left) / (knots[j + 1 + k - r] - left);
            d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j];
        }
    }
    return d[p];
}

class CurveTest : public testing::TestWithParam<Shape> {
 protected:
    SplineSpace random_space() {
        std::uniform_real_distribution<double> width(0.3, 1.7);
        std::vector<double> breakpoints{0.0};
        for (int i = 0; i < GetParam().segments; ++i) {
            breakpoints.push_back(breakpoints.back() + width(random_) / GetParam().segments);
        }
        return {GetParam().degree, GetParam().continuity, breakpoints};
    }
    Eigen::VectorXd random_vector(int size) {
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        Eigen::VectorXd vector(size);
        for (double& value : vector) value = number(random_);
        return vector;
    }
    std::mt19937 random_{42};
};

TEST_P(CurveTest, AgreesWithDeBoorsAlgorithm) {
    const SplineSpace space = random_space();
    const Eigen::VectorXd c = random_vector(space.dimension());
    const SplineCurve curve = SplineCurve::from_coefficients(space, c);
    for (int k = 0; k < 200; ++k) {
        const double x = space.end() * k / 200.0;
        EXPECT_NEAR(curve.at(x).derivative[0], de_boor(space.knots(), c, space.degree(), x), 1e-12);
    }
}

TEST_P(CurveTest, CoefficientsSurviveTheRoundTrip) {
    const SplineSpace space = random_space();
    const Eigen::VectorXd c = random_vector(space.dimension());
    const Eigen::VectorXd back = SplineCurve::from_coefficients(space, c).coefficients();
    EXPECT_LT((back - c).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_P(CurveTest, JumpsOnlyAboveContinuityOrder) {
    const SplineSpace space = random_space();
    const SplineCurve curve = SplineCurve::from_coefficients(space, random_vector(space.dimension()));
    ASSERT_EQ(space.segments(), GetParam().segments);  // one segment has no joint
    for (int i = 1; i < space.segments(); ++i) {
        const double x = space.breakpoints()[i];
        double scale = 1.0;
        for (int r = 0; r <= space.degree(); ++r) {
            const double jump = curve.derivative(x, r, Side::right) - curve.derivative(x, r, Side::left);
            scale *= 4.0 * space.degree() * GetParam().segments;
            if (r <= space.continuity()) {
                EXPECT_LT(std::abs(jump), 1e-12 * scale) << "order " << r;
            } else if (r == space.continuity() + 1) {
                EXPECT_GT(std::abs(jump), 1e-9) << "order " << r;
            }
        }
    }
}

TEST_P(CurveTest, DerivativesAgreeWithCentralDifferences) {
    const SplineSpace space = random_space();
    const SplineCurve curve = SplineCurve::from_coefficients(space, random_vector(space.dimension()));
    const double step = 1e-5 / GetParam().segments;
    for (int i = 0; i < space.segments(); ++i) {
        const double x = space.breakpoints()[i] + 0.37 * space.width(i);
        for (int r = 1; r <= 3; ++r) {
            const double difference =
                (curve.derivative(x + step, r - 1) - curve.derivative(x - step, r - 1)) / (2.0 * step);
            const double exact = curve.derivative(x, r);
            const double scale = std::pow(2.0 * space.degree() * GetParam().segments, r);
            EXPECT_NEAR(difference, exact, 1e-7 * scale) << "order " << r;
        }
    }
}

TEST_P(CurveTest, PeaksAreReachedAndNotPassed) {
    const SplineSpace space = random_space();
    const SplineCurve curve = SplineCurve::from_coefficients(space, random_vector(space.dimension()));
    const Peaks peaks = peaks_of(curve);
    const std::array<Extremum, 4> found = {peaks.velocity, peaks.acceleration, peaks.jerk, peaks.torque};
    std::array<double, 4> sampled{};
    constexpr int samples = 20000;
    for (int k = 0; k <= samples; ++k) {
        for (const Side side : {Side::left, Side::right}) {
            const MotionPoint p = curve.at(space.end() * k / samples, side);
            for (int r = 0; r < 3; ++r) sampled[r] = std::max(sampled[r], std::abs(p.derivative[r + 1]));
            sampled[3] = std::max(sampled[3], std::abs(p.derivative[1] * p.derivative[2]));
        }
    }
    for (int r = 0; r < 4; ++r) {
        EXPECT_GE(found[r].value, sampled[r] * (1.0 - 1e-13));
        EXPECT_LT(found[r].value, sampled[r] * (1.0 + 2e-2));
        const MotionPoint p = curve.at(found[r].at, found[r].side);
        const double reached = r < 3 ? p.derivative[r + 1] : p.derivative[1] * p.derivative[2];
        EXPECT_NEAR(std::abs(reached), found[r].value, 1e-12 * found[r].value);
    }
}

// y'' is piecewise linear with two tops: 1 at 0.25 and 1 + excess at 0.75.
SplineCurve curve_of_two_tops(double excess) {
    Eigen::MatrixXd pieces = Eigen::MatrixXd::Zero(4, 4);
    const std::array<double, 5> bend{0.0, 1.0, 0.0, 1.0 + excess, 0.0};
    for (int i = 0; i < 4; ++i) {
        const double slope = (bend[i + 1] - bend[i]) / 0.25;
        pieces(2, i) = bend[i] / 2.0;
        pieces(3, i) = slope / 6.0;
        if (i == 3) break;
        pieces(0, i + 1) = pieces(0, i) + 0.25 * (pieces(1, i) + 0.25 * (pieces(2, i) + 0.25 * pieces(3, i)));
        pieces(1, i + 1) = pieces(1, i) + 0.25 * (2.0 * pieces(2, i) + 0.75 * pieces(3, i));
    }
    return {SplineSpace(3, 2, {0.0, 0.25, 0.5, 0.75, 1.0}), pieces};
}

TEST(Curve, RoundedDuplicatePeakReportsFirstLocation) {
    for (const double excess : {-1e-9, 0.0, 1e-9}) {
        const Extremum peak = peak_of(curve_of_two_tops(excess), 2);
        EXPECT_EQ(peak.at, 0.25) << excess;
        EXPECT_EQ(peak.value, std::max(1.0, 1.0 + excess));
    }
    EXPECT_EQ(peak_of(curve_of_two_tops(1e-6), 2).at, 0.75);
}

TEST(Curve, PeakLocationIsTrueMaximum) {
    // A breakpoint lies 1e-6 before the summit, where y' is lower by 1e-12.
    const SplineSpace space(3, 2, {0.0, 0.5 - 1e-6, 1.0});
    Eigen::MatrixXd pieces(4, 2);
    const double x = 0.5 - 1e-6;
    pieces.col(0) << 0.0, 0.0, 0.5, -1.0 / 3.0;  // y' = x − x², greatest at 1/2
    pieces.col(1) << x * x / 2.0 - x * x * x / 3.0, x - x * x, 0.5 - x, -1.0 / 3.0;
    EXPECT_NEAR(peak_of(SplineCurve(space, pieces), 1).at, 0.5, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CurveTest,
                         testing::Values(Shape{3, 2, 1}, Shape{3, 2, 2}, Shape{3, 2, 12}, Shape{5, 4, 1},
                                         Shape{5, 4, 8}, Shape{5, 3, 6}, Shape{5, 2, 5}, Shape{3, 2, 64}),
                         [](const auto& shape) {
                             return "degree" + std::to_string(shape.param.degree) + "_C" +
                                    std::to_string(shape.param.continuity) + "_n" +
                                    std::to_string(shape.param.segments);
                         });

TEST(Curve, RefusesMismatchedCoefficients) {
    const SplineSpace space = SplineSpace::uniform(3, 2, 4, 1.0);
    EXPECT_EQ(refusal([&] { SplineCurve(space, Eigen::MatrixXd::Zero(4, 3)); }),
              "pieces: found 4 x 3; allowed: 4 x 4");
    EXPECT_EQ(refusal([&] { (void)SplineCurve::from_coefficients(space, Eigen::VectorXd::Zero(6)); }),
              "coefficients: found 6; allowed: 7");
    EXPECT_EQ(refusal([&] { SplineCurve(space, Eigen::MatrixXd::Constant(4, 4, std::nan(""))); }),
              "pieces: found a value that is not finite");
    const SplineCurve curve(space, Eigen::MatrixXd::Zero(4, 4));
    EXPECT_EQ(refusal([&] { (void)curve.at(1.1); }), "x: found 1.1; allowed: 0 … 1");
    EXPECT_EQ(refusal([&] { (void)curve.at(-0.1); }), "x: found -0.1; allowed: 0 … 1");
}

TEST(Curve, DerivativesAboveTheDegreeAreZero) {
    const SplineSpace space = SplineSpace::uniform(3, 2, 4, 1.0);
    const SplineCurve curve = SplineCurve::from_coefficients(space, Eigen::VectorXd::LinSpaced(7, 0.0, 3.0));
    EXPECT_EQ(curve.derivative(0.3, 4), 0.0);
    EXPECT_EQ(curve.derivative(0.3, 7), 0.0);
}

}  // namespace curve_test
}  // namespace camopt

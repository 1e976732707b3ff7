// SPDX-License-Identifier: MIT
#include "splines/design_vector.hpp"

#include "core/errors.hpp"
#include "splines/gram.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace design_vector_test {

using testing_support::refusal;

DesignRequest rise(DesignKind kind, int degree, int segments, int continuity = -1) {
    const int smooth = continuity < 0 ? degree - 1 : continuity;
    return {
        SplineSpace::uniform(degree, smooth, segments, 1.0), kind, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {}, {}};
}

/// A random admissible point: the nearest one to random numbers that meets the equalities.
Eigen::VectorXd admissible(const DesignVector& design, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    Eigen::VectorXd x(design.size());
    for (double& value : x) value = number(random);
    const auto rows = static_cast<Eigen::Index>(design.equalities().size());
    if (rows == 0) return x;
    // Rows and entries by their size: weights of high derivatives are powers of the number of segments.
    Eigen::VectorXd size(x.size());
    for (int j = 0; j < size.size(); ++j) size[j] = std::pow(10.0, design.order(j));
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, x.size());
    for (Eigen::Index i = 0; i < rows; ++i) {
        const AffineRow& row = design.equalities()[i].row;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            matrix(i, row.columns[k]) = row.weights[k] * size[row.columns[k]];
    }
    const Eigen::VectorXd norm = matrix.rowwise().norm();
    const auto factor = (norm.cwiseInverse().asDiagonal() * matrix).eval().completeOrthogonalDecomposition();
    for (int step = 0; step < 3; ++step) {
        Eigen::VectorXd defect(rows);
        for (Eigen::Index i = 0; i < rows; ++i) defect[i] = design.equalities()[i].row.value(x) / norm[i];
        x -= size.cwiseProduct(factor.solve(defect));
    }
    return x;
}

constexpr std::array<DesignKind, 3> kinds = {DesignKind::ordinates, DesignKind::coefficients,
                                             DesignKind::states};

TEST(DesignVector, HasTheFreedomOfThePaper) {
    for (const DesignKind kind : kinds) {
        EXPECT_EQ(DesignVector::make(rise(kind, 3, 12)).freedom(), 12 - 3) << name_of(kind);
        EXPECT_EQ(DesignVector::make(rise(kind, 5, 12)).freedom(), 12 - 1) << name_of(kind);
        EXPECT_EQ(DesignVector::make(rise(kind, 7, 12)).freedom(), 12 + 1) << name_of(kind);
        DesignRequest symmetric = rise(kind, 3, 12);
        symmetric.symmetry = Symmetry::odd;
        EXPECT_EQ(DesignVector::make(symmetric).freedom(), 12 / 2 - 2) << name_of(kind);
    }
    for (const int continuity : {2, 3}) {
        const int expected = 6 + 11 * (5 - continuity) - 6;
        EXPECT_EQ(DesignVector::make(rise(DesignKind::states, 5, 12, continuity)).freedom(), expected);
        EXPECT_EQ(DesignVector::make(rise(DesignKind::coefficients, 5, 12, continuity)).freedom(), expected);
    }
    for (const int continuity : {3, 4, 5}) {
        const int expected = 8 + 11 * (7 - continuity) - 6;
        EXPECT_EQ(DesignVector::make(rise(DesignKind::states, 7, 12, continuity)).freedom(), expected);
        EXPECT_EQ(DesignVector::make(rise(DesignKind::coefficients, 7, 12, continuity)).freedom(), expected);
    }
}

/// C3 states have no rows: each segment is the polynomial of degree 7 with the states at its ends.
TEST(DesignVector, SepticStatesAreDerivativesAtBreakpoints) {
    DesignRequest request = rise(DesignKind::states, 7, 5, 3);
    request.space = SplineSpace(7, 3, {0.0, 0.1, 0.35, 0.7, 0.82, 1.0});
    const DesignVector design = DesignVector::make(request);
    EXPECT_TRUE(design.equalities().empty());
    ASSERT_EQ(design.size(), 2 + 4 * 4);
    const Eigen::VectorXd x = admissible(design, 17);
    const SplineCurve curve = design.curve(x);
    for (int j = 0; j < design.size(); ++j) {
        const double at = design.place(j);
        for (const Side side : {Side::left, Side::right}) {
            if ((at == 0.0 && side == Side::left) || (at == 1.0 && side == Side::right)) continue;
            const double size = std::pow(30.0, design.order(j));
            EXPECT_NEAR(curve.derivative(at, design.order(j), side), x[j], 1e-12 * size) << design.name(j);
        }
    }
    // The states of one polynomial of degree 7 give that polynomial: y = x⁴ (35 − 84 x + 70 x² − 20 x³).
    const SplineCurve one(SplineSpace(7, 6, {0.0, 1.0}),
                          (Eigen::VectorXd(8) << 0, 0, 0, 0, 35, -84, 70, -20).finished());
    Eigen::VectorXd states(design.size());
    for (int j = 0; j < design.size(); ++j) states[j] = one.derivative(design.place(j), design.order(j));
    const SplineCurve same = design.curve(states);
    for (int k = 0; k <= 100; ++k) {
        const double at = k / 100.0;
        for (int order = 0; order < 8; ++order)
            EXPECT_NEAR(same.derivative(at, order), one.derivative(at, order), 1e-13 * std::pow(100.0, order))
                << at;
    }
}

TEST(DesignVector, RestMakesHigherDerivativesZero) {
    for (const DesignKind kind : kinds) {
        for (const int degree : {5, 7}) {
            for (int rest = 2; rest < degree; ++rest) {
                SCOPED_TRACE(std::string(name_of(kind)) + " degree " + std::to_string(degree) + " rest " +
                             std::to_string(rest));
                DesignRequest request = rise(kind, degree, 11);
                for (const auto& [at, side] : {std::pair(0.0, Side::right), std::pair(1.0, Side::left)})
                    for (PointCondition& condition : rest_conditions(at, side, rest))
                        request.conditions.push_back(std::move(condition));
                const DesignVector design = DesignVector::make(request);
                EXPECT_TRUE(design.contradictions().empty());
                EXPECT_EQ(design.freedom(), degree + 11 - 6 - 2 * (rest - 2));
                const SplineCurve curve = design.curve(admissible(design, 3));
                for (int order = 3; order < degree; ++order) {
                    const double size = peak_of(curve, order).value;
                    for (const double end :
                         {curve.derivative(0.0, order), curve.derivative(1.0, order, Side::left)})
                        EXPECT_EQ(std::abs(end) < 1e-8 * size, order <= rest) << order << ": " << end;
                }
            }
        }
    }
    EXPECT_EQ(rest_conditions(0.0, Side::right, 3).front().name, "spline.end_jerk at x = 0");
    EXPECT_EQ(rest_conditions(1.5, Side::left, 4).back().name, "spline.rest at x = 1.5");
}

TEST(DesignVector, ReportsThePapersFreeOrdinates) {
    DesignRequest request = rise(DesignKind::ordinates, 3, 12);
    EXPECT_EQ(DesignVector::make(request).reported_entries().size(), 9u);
    request.symmetry = Symmetry::odd;
    EXPECT_EQ(DesignVector::make(request).reported_entries(), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(DesignVector::make(rise(DesignKind::ordinates, 5, 12)).reported_entries().size(), 11u);
    const DesignVector septic = DesignVector::make(rise(DesignKind::ordinates, 7, 12));
    EXPECT_EQ(septic.reported_entries().size(), 13u);
    EXPECT_EQ(septic.name(0), "y'''[0]");
    EXPECT_EQ(septic.name(12), "y'''[12]");
}

TEST(DesignVector, SixSegmentsFollowThePapersRelation) {
    // Antisymmetric cubic, n = 6: y2 = 4 y1 + 1/12.
    DesignRequest request = rise(DesignKind::ordinates, 3, 6);
    request.symmetry = Symmetry::odd;
    const DesignVector design = DesignVector::make(request);
    for (unsigned seed = 1; seed < 5; ++seed) {
        const Eigen::VectorXd x = admissible(design, seed);
        EXPECT_NEAR(x[1], 4.0 * x[0] + 1.0 / 12.0, 1e-12);
    }
}

TEST(DesignVector, CurvesMeetEndStatesAndContinuity) {
    for (const DesignKind kind : kinds) {
        for (const int degree : {3, 5, 7}) {
            const DesignVector design = DesignVector::make(rise(kind, degree, 9));
            const SplineCurve curve = design.curve(admissible(design, 3));
            const MotionPoint begin = curve.at(0.0);
            const MotionPoint end = curve.at(1.0, Side::left);
            for (int r = 0; r < 3; ++r) {
                EXPECT_NEAR(begin.derivative[r], 0.0, 1e-9) << name_of(kind) << degree;
                EXPECT_NEAR(end.derivative[r], r == 0 ? 1.0 : 0.0, 1e-9) << name_of(kind) << degree;
            }
            for (int i = 1; i < 9; ++i) {
                for (int r = 0; r < degree; ++r) {
                    const double x = design.space().breakpoints()[i];
                    EXPECT_NEAR(curve.derivative(x, r, Side::left), curve.derivative(x, r, Side::right),
                                1e-9 * std::pow(30.0, r))
                        << name_of(kind) << degree << " order " << r;
                }
            }
        }
    }
}

/// Beside a segment of 1/2000 the weights of the far ordinates are 1e-13 of the largest in the row, but
/// their ordinates are 1e10 times as large: none is rounding.
TEST(DesignVector, OrdinateRowsReproduceCurve) {
    DesignRequest request = rise(DesignKind::ordinates, 3, 12);
    std::vector<double> points = {0.0, 0.0005};
    for (int i = 1; i <= 20; ++i) points.push_back(i / 20.0);
    request.space = SplineSpace(3, 2, points);
    const DesignVector design = DesignVector::make(request);
    ASSERT_EQ(design.equalities().size(), 2u);
    Eigen::VectorXd x(design.size());
    for (int j = 0; j < design.size(); ++j) {
        const double at = points[static_cast<std::size_t>(j) + 1];
        x[j] = at * at * at * (10.0 - at * (15.0 - 6.0 * at));
    }
    const SplineCurve curve = design.curve(x);
    for (const auto& [at, side] : {std::pair(0.0, Side::right), std::pair(1.0, Side::left)}) {
        const double bend = curve.derivative(at, 2, side);
        double nearest = 1.0;
        for (const Equality& equality : design.equalities()) {
            const AffineRow& row = equality.row;
            const AffineRow own = design.functional(at, 2, side);
            double factor = 0.0;
            for (std::size_t k = 0; k < row.columns.size(); ++k)
                if (std::abs(row.weights[k]) > std::abs(factor)) factor = row.weights[k];
            double most = 0.0;
            for (const double weight : own.weights)
                if (std::abs(weight) > std::abs(most)) most = weight;
            nearest = std::min(nearest, std::abs(row.value(x) * most / factor - bend));
        }
        EXPECT_LT(nearest, 1e-9) << at;
    }
}

/// Displacements of nearly 1 meet there with weights of 10 / h³: what is left of their difference must not be
/// rounding.
TEST(DesignVector, ANarrowSegmentEndsAtRest) {
    constexpr double narrow = 6.5e-4;
    for (const int degree : {3, 5}) {
        DesignRequest request = rise(DesignKind::states, degree, 12);
        request.space = SplineSpace(degree, 2, {0.0, 0.2, 0.45, 0.7, 1.0 - narrow, 1.0});
        const DesignVector design = DesignVector::make(request);
        Eigen::VectorXd x(design.size());
        for (int j = 0; j < design.size(); ++j) {
            const double at = request.space.breakpoints()[static_cast<std::size_t>(1 + j / 3)];
            const double left = 1.0 - at;
            x[j] = j % 3 == 0   ? at * at * at * (10.0 - at * (15.0 - 6.0 * at))
                   : j % 3 == 1 ? 30.0 * at * at * left * left
                                : 60.0 * at * left * (1.0 - 2.0 * at);
        }
        const SplineCurve curve = design.curve(x);
        EXPECT_NEAR(curve.derivative(1.0, 2, Side::left), 0.0, 1e-9) << degree;
        if (degree == 5) {
            EXPECT_NEAR(curve.derivative(1.0, 1, Side::left), 0.0, 1e-13);
        }
    }
}

/// Of the control points as they are published.
TEST(DesignVector, UnevenQuinticsEndAtRest) {
    DesignRequest request = rise(DesignKind::ordinates, 5, 12);
    request.space = SplineSpace(
        5, 4, {0.0,    0.0369, 0.0433, 0.1164, 0.1555, 0.1917, 0.21,   0.3036, 0.344,  0.3871, 0.4425,
               0.4566, 0.4618, 0.5427, 0.6222, 0.6301, 0.735,  0.8404, 0.8555, 0.9875, 0.9944, 1.0});
    const DesignVector design = DesignVector::make(request);
    Eigen::VectorXd x(design.size());
    for (int j = 0; j < design.size(); ++j) {
        const double at = request.space.breakpoints()[static_cast<std::size_t>(j) + 1];
        x[j] = at * at * at * (10.0 - at * (15.0 - 6.0 * at)) + 1e-3 * std::sin(20.0 * at) * at * (1.0 - at);
    }
    const SplineCurve curve = design.curve(x);
    // Three control points at either end are its displacement.
    const Eigen::VectorXd points = curve.coefficients();
    for (Eigen::Index k = 0; k < 3; ++k) {
        EXPECT_NEAR(points[k], 0.0, 1e-16) << k;
        EXPECT_NEAR(points[points.size() - 1 - k], 1.0, 2e-15) << k;
    }
}

TEST(DesignVector, FunctionalsAreTheCurvesDerivatives) {
    for (const DesignKind kind : kinds) {
        for (const int degree : {3, 5, 7}) {
            const DesignVector design = DesignVector::make(rise(kind, degree, 7));
            const Eigen::VectorXd x = admissible(design, 11);
            const SplineCurve curve = design.curve(x);
            for (int order = 0; order < 4; ++order) {
                for (const double at : {0.0, 0.1, 2.0 / 7.0, 0.5, 0.93, 1.0}) {
                    for (const Side side : {Side::left, Side::right}) {
                        const double exact = curve.derivative(at, order, side);
                        EXPECT_NEAR(design.functional(at, order, side).value(x), exact,
                                    1e-10 * std::pow(40.0, order));
                    }
                }
            }
        }
    }
}

TEST(DesignVector, FormsExchangeCurves) {
    for (const int degree : {3, 5, 7}) {
        const DesignVector states = DesignVector::make(rise(DesignKind::states, degree, 8));
        const SplineCurve curve = states.curve(admissible(states, 5));
        for (const DesignKind kind : kinds) {
            const DesignVector design = DesignVector::make(rise(kind, degree, 8));
            const SplineCurve same = design.curve(design.values_of(curve));
            for (const double at : {0.05, 0.33, 0.71}) {
                EXPECT_NEAR(same.at(at).derivative[0], curve.at(at).derivative[0], 1e-9);
                EXPECT_NEAR(same.at(at).derivative[2], curve.at(at).derivative[2], 1e-6);
            }
        }
    }
}

TEST(DesignVector, EqualitiesAreIndependentInEveryForm) {
    for (const DesignKind kind : kinds) {
        for (const int degree : {3, 5, 7}) {
            for (int continuity = 2; continuity < degree; ++continuity) {
                if (kind == DesignKind::ordinates && continuity != degree - 1) continue;
                if (kind == DesignKind::states && degree == 7 && continuity == 2) continue;
                for (const int segments : {6, 7, 8, 9}) {
                    for (const Symmetry symmetry : {Symmetry::none, Symmetry::odd, Symmetry::even}) {
                        SCOPED_TRACE(std::string(name_of(kind)) + " degree " + std::to_string(degree) + " C" +
                                     std::to_string(continuity) + " n " + std::to_string(segments) +
                                     " symmetry " + std::to_string(static_cast<int>(symmetry)));
                        DesignRequest request = rise(kind, degree, segments, continuity);
                        request.symmetry = symmetry;
                        if (symmetry == Symmetry::even) request.end_state = {0.0, 0.0, 0.0};
                        request.conditions = {{0.3, 0, Side::right, 0.2, "point"}};
                        const DesignVector design = DesignVector::make(request);
                        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(
                            static_cast<Eigen::Index>(design.equalities().size()), design.size());
                        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
                            const AffineRow& row = design.equalities()[i].row;
                            for (std::size_t k = 0; k < row.columns.size(); ++k) {
                                matrix(i, row.columns[k]) = row.weights[k];
                            }
                            matrix.row(i).normalize();
                        }
                        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix.transpose());
                        qr.setThreshold(1e-9);
                        EXPECT_EQ(qr.rank(), matrix.rows());
                        const int dimension = degree + 1 + (segments - 1) * (degree - continuity);
                        if (symmetry == Symmetry::none) {
                            EXPECT_EQ(design.freedom(), dimension - 6 - 1);  // six end states and the point
                        }
                        // The curve is symmetric everywhere, not only where it was told to be.
                        const SplineCurve curve = design.curve(admissible(design, 7));
                        for (const double x : {0.05, 0.21, 0.44}) {
                            const double here = curve.at(x).derivative[0];
                            const double there = curve.at(1.0 - x).derivative[0];
                            if (symmetry == Symmetry::odd) {
                                EXPECT_NEAR(here + there, 1.0, 1e-8);
                            } else if (symmetry == Symmetry::even) {
                                EXPECT_NEAR(here, there, 1e-8);
                            }
                        }
                    }
                }
            }
        }
    }
}

TEST(DesignVector, SetPointsAreMet) {
    for (const DesignKind kind : kinds) {
        DesignRequest request = rise(kind, 3, 10);
        request.conditions = {{0.5, 0, Side::right, 0.4, "half"}, {0.33, 1, Side::right, 1.5, "speed"}};
        const DesignVector design = DesignVector::make(request);
        EXPECT_EQ(design.freedom(), 5);
        const SplineCurve curve = design.curve(admissible(design, 2));
        EXPECT_NEAR(curve.at(0.5).derivative[0], 0.4, 1e-10);
        EXPECT_NEAR(curve.at(0.33).derivative[1], 1.5, 1e-9);
    }
}

TEST(DesignVector, NamesRedundantAndContradictoryConditions) {
    for (const DesignKind kind : kinds) {
        DesignRequest request = rise(kind, 3, 8);
        request.symmetry = Symmetry::odd;
        request.conditions = {{0.5, 0, Side::right, 0.5, "middle"}};
        const DesignVector redundant = DesignVector::make(request);
        ASSERT_EQ(redundant.redundant().size(), 1u) << name_of(kind);
        EXPECT_EQ(redundant.redundant()[0].condition, "middle");
        EXPECT_TRUE(redundant.contradictions().empty());

        request.conditions[0].value = 0.6;
        const DesignVector contradicting = DesignVector::make(request);
        ASSERT_EQ(contradicting.contradictions().size(), 1u) << name_of(kind);
        EXPECT_EQ(contradicting.contradictions()[0].condition, "middle");
        double offset = 0.0;
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(contradicting.space().dimension());
        for (const ConflictRow& row : contradicting.contradictions()[0].rows) {
            offset += row.multiplier * row.row.offset;
            for (std::size_t k = 0; k < row.row.columns.size(); ++k) {
                weights[row.row.columns[k]] += row.multiplier * row.row.weights[k];
            }
        }
        EXPECT_GT(offset, 0.05);
        EXPECT_LT(weights.cwiseAbs().maxCoeff(), 1e-14);
    }
    DesignRequest crowded = rise(DesignKind::states, 3, 4);  // one number free, three points asked for
    crowded.conditions = {
        {0.25, 0, Side::right, 0.1, "a"}, {0.5, 0, Side::right, 0.5, "b"}, {0.75, 0, Side::right, 0.95, "c"}};
    EXPECT_FALSE(DesignVector::make(crowded).contradictions().empty());
}

TEST(DesignVector, TooFewSegmentsContradictTheEnds) {
    for (const DesignKind kind : kinds) {
        EXPECT_FALSE(DesignVector::make(rise(kind, 3, 2)).contradictions().empty()) << name_of(kind);
        EXPECT_FALSE(DesignVector::make(rise(kind, 3, 1)).contradictions().empty()) << name_of(kind);
        EXPECT_TRUE(DesignVector::make(rise(kind, 3, 3)).contradictions().empty()) << name_of(kind);
        EXPECT_TRUE(DesignVector::make(rise(kind, 5, 1)).contradictions().empty()) << name_of(kind);
        // Rest of order 6 leaves nothing of seven segments: they have 14 numbers and 14 conditions.
        for (const auto& [segments, crowded] : {std::pair(6, true), std::pair(7, false)}) {
            DesignRequest request = rise(kind, 7, segments);
            for (const auto& [at, side] : {std::pair(0.0, Side::right), std::pair(1.0, Side::left)})
                for (PointCondition& condition : rest_conditions(at, side, 6))
                    request.conditions.push_back(std::move(condition));
            EXPECT_EQ(!DesignVector::make(request).contradictions().empty(), crowded)
                << name_of(kind) << segments;
        }
    }
}

TEST(DesignVector, RefusesFormsNotSpanningSpace) {
    EXPECT_EQ(refusal([&] { (void)DesignVector::make(rise(DesignKind::ordinates, 5, 8, 3)); }),
              "design \"ordinates\": found degree 5 with continuity 3; allowed: degree 3, 5 or 7 with "
              "continuity degree − 1 (the ordinates alone do not fix a rougher spline)");
    DesignRequest lopsided{SplineSpace(3, 2, {0.0, 0.2, 0.5, 0.6, 1.0}),
                           DesignKind::states,
                           {},
                           {1.0, 0.0, 0.0},
                           {},
                           Symmetry::odd};
    EXPECT_EQ(refusal([&] { (void)DesignVector::make(lopsided); }),
              "symmetry: the breakpoints are not symmetric about the middle");
}

/// Mean square of the derivative of `order` over the whole spline.
QuadraticForm mean_square_form(const DesignVector& design, int order) {
    const SplineSpace& space = design.space();
    EnergySum sum(design.size());
    for (int i = 0; i < space.segments(); ++i) sum.add(design.local_map(i), order, space.width(i), 1.0);
    return sum.form(1.0 / (space.end() - space.begin()));
}

TEST(Gram, IsTheIntegralOfTheSquare) {
    for (const DesignKind kind : kinds) {
        for (const int degree : {3, 5, 7}) {
            const DesignVector design = DesignVector::make(rise(kind, degree, 6));
            const Eigen::VectorXd x = admissible(design, 9);
            const SplineCurve curve = design.curve(x);
            for (int order = 1; order <= 3; ++order) {
                double integral = 0.0;  // midpoint rule, fine enough for six digits
                constexpr int samples = 60000;
                for (int k = 0; k < samples; ++k) {
                    const double value = curve.derivative((k + 0.5) / samples, order);
                    integral += value * value / samples;
                }
                EXPECT_NEAR(mean_square_form(design, order).value(x), integral, 1e-6 * integral);
            }
        }
    }
}

}  // namespace design_vector_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Families of motions: rows, motions and energies of dwells, shapes and splines agree with each other.
#include "splines/motion_family.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace camopt {
namespace motion_family_test {

using testing_support::refusal;

using Kind = StretchRequest::Kind;

/// 3-4-5 polynomial: at rest at both ends, with a kink of y''' there.
class Shape final : public Motion {
 public:
    [[nodiscard]] double begin() const override { return 0.0; }
    [[nodiscard]] double end() const override { return 1.0; }
    [[nodiscard]] MotionPoint at(double x, Side) const override {
        return {x,
                {x * x * x * (10 - 15 * x + 6 * x * x), 30 * x * x * (1 - x) * (1 - x),
                 60 * x * (1 - x) * (1 - 2 * x), 60 * (1 - 6 * x + 6 * x * x)}};
    }
    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, 1.0}; }
};

StretchRequest dwell(double begin, double end) {
    return {Kind::dwell, begin, end, nullptr, {}, {}, {}};
}
StretchRequest shape(double begin, double end, std::optional<double> to) {
    return {Kind::shape, begin, end, std::make_shared<Shape>(), {}, to, {}};
}
StretchRequest spline(double begin, double end, int segments, std::optional<double> to) {
    std::vector<double> points;
    for (int i = 0; i <= segments; ++i) points.push_back(begin + (end - begin) * i / segments);
    return {Kind::spline, begin, end, nullptr, points, to, {}};
}

/// Entries that meet every equality, else random.
Eigen::VectorXd admissible(const MotionFamily& family, unsigned seed) {
    std::mt19937 random(seed);
    Eigen::VectorXd x(family.size());
    for (double& value : x) value = static_cast<double>(random()) / 4294967295.0 - 0.5;
    Eigen::MatrixXd rows =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(family.equalities().size()), family.size());
    if (rows.rows() == 0) return x;
    // Rows and entries by their size: weights of high derivatives are powers of the number of segments.
    Eigen::VectorXd size(x.size());
    for (int j = 0; j < size.size(); ++j) size[j] = std::pow(10.0, family.order(j));
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const AffineRow& row = family.equalities()[static_cast<std::size_t>(i)].row;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            rows(i, row.columns[k]) = row.weights[k] * size[row.columns[k]];
    }
    const Eigen::VectorXd norm = rows.rowwise().norm();
    const auto factor = (norm.cwiseInverse().asDiagonal() * rows).eval().completeOrthogonalDecomposition();
    for (int step = 0; step < 3; ++step) {
        Eigen::VectorXd defect(rows.rows());
        for (Eigen::Index i = 0; i < rows.rows(); ++i)
            defect[i] = family.equalities()[static_cast<std::size_t>(i)].row.value(x) / norm[i];
        x -= size.cwiseProduct(factor.solve(defect));
    }
    return x;
}

std::vector<FamilyRequest> requests() {
    std::vector<FamilyRequest> all;
    for (const int degree : {3, 5, 7}) {
        for (const DesignKind kind : {DesignKind::states, DesignKind::coefficients}) {
            FamilyRequest request{degree, degree - 1, kind, {}, true, false};
            // A run across the end, a given displacement inside a run, a shape with a free beginning.
            request.stretches = {spline(0, 1, 4, 1.0), spline(1, 1.7, 3, {}), shape(1.7, 2.2, 0.4),
                                 dwell(2.2, 2.5), spline(2.5, 3.1, 4, {})};
            all.push_back(request);
            // A dwell at a free displacement.
            request.stretches = {spline(0, 1, 4, {}), dwell(1, 1.5), spline(1.5, 2.5, 4, 0.0), dwell(2.5, 3)};
            all.push_back(request);
            request.stretches = {spline(0, 1, 4, 1.0), spline(1, 2, 4, {})};
            all.push_back(request);
            request.closed = false;
            all.push_back(request);
        }
    }
    return all;
}

TEST(MotionFamily, RowsAreTheMotion) {
    for (const FamilyRequest& request : requests()) {
        const MotionFamily family = MotionFamily::make(request);
        const Eigen::VectorXd x = admissible(family, 7);
        const MotionChain motion = family.motion(x);
        for (int k = 0; k <= 400; ++k) {
            const double at = family.begin() + (family.end() - family.begin()) * k / 400.0;
            for (const Side side : {Side::left, Side::right}) {
                const MotionPoint point = motion.at(at, side);
                for (int order = 0; order < 4; ++order) {
                    const double value = family.functional(at, order, side).value(x);
                    EXPECT_NEAR(value, point.derivative[order], 1e-9 * std::max(1.0, std::abs(value))) << at;
                }
            }
        }
    }
}

TEST(MotionFamily, JointsAreSmoothAndMeetDisplacements) {
    for (const FamilyRequest& request : requests()) {
        const MotionFamily family = MotionFamily::make(request);
        EXPECT_TRUE(family.contradictions().empty());
        const MotionChain motion = family.motion(admissible(family, 11));
        for (std::size_t i = 0; i < request.stretches.size(); ++i) {
            const StretchRequest& stretch = request.stretches[i];
            if (stretch.to) {
                EXPECT_NEAR(motion.at(stretch.end, Side::left).derivative[0], *stretch.to, 1e-9);
            }
            const bool last = i + 1 == request.stretches.size();
            if (last && !request.closed) continue;
            const double next = last ? family.begin() : stretch.end;
            const bool both =
                stretch.kind == Kind::spline && request.stretches[last ? 0 : i + 1].kind == Kind::spline;
            for (int order = 0; order <= (both ? request.continuity : 2) && order < 4; ++order) {
                const double left = motion.at(stretch.end, Side::left).derivative[order];
                const double right = motion.at(next, Side::right).derivative[order];
                EXPECT_NEAR(left, right, 1e-7 * std::max(1.0, std::abs(left))) << i << " order " << order;
            }
        }
        EXPECT_NEAR(motion.at(family.begin()).derivative[0], 0.0, 1e-12);
    }
}

TEST(MotionFamily, MeanSquaresAreIntegrals) {
    const MotionFamily family = MotionFamily::make(requests().front());
    const Eigen::VectorXd x = admissible(family, 13);
    const MotionChain motion = family.motion(x);
    const std::vector<double> weights = {2.0, 0.5, 1.0, 1.0, 3.0};
    double integral = 0.0, length = 0.0;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (piece.segment < 0) continue;
        constexpr int steps = 2000;
        const double h = (piece.end - piece.begin) / steps;
        length += piece.end - piece.begin;
        for (int k = 0; k < steps; ++k) {
            const double value = motion.at(piece.begin + (k + 0.5) * h).derivative[2];
            integral += weights[static_cast<std::size_t>(piece.stretch)] * value * value * h;
        }
    }
    EXPECT_NEAR(family.mean_square(2, weights).value(x), integral / length, 1e-5 * integral / length);
}

TEST(MotionFamily, RefusesDisplacementsThatContradict) {
    FamilyRequest request;
    request.stretches = {spline(0, 1, 4, 1.0), dwell(1, 2)};  // closed: the dwell ends at 0
    EXPECT_EQ(refusal([&] { (void)MotionFamily::make(request); }),
              "displacements contradict each other: found 0 and 1 at the joint after 2 stretches; allowed: "
              "one displacement there (a dwell keeps it, a closed program ends at 0)");
    request.stretches.clear();
    EXPECT_EQ(refusal([&] { (void)MotionFamily::make(request); }),
              "a family of motions: found no stretch; allowed: one or more");
}

TEST(MotionFamily, RestHoldsNextToDwells) {
    FamilyRequest request{7, 6, DesignKind::states, {}, false, false};
    request.stretches = {spline(0, 1, 10, 1.0), dwell(1, 1.5), spline(1.5, 2.5, 10, 0.0), shape(2.5, 3, 0.3),
                         spline(3, 4, 10, 0.5)};
    request.rest = 4;
    const MotionFamily family = MotionFamily::make(request);
    const MotionChain motion = family.motion(admissible(family, 5));
    const std::map<double, std::array<bool, 2>> rests = {{0.0, {true, true}},  {1.0, {true, true}},
                                                         {1.5, {true, true}},  {2.5, {false, true}},
                                                         {3.0, {true, false}}, {4.0, {true, true}}};
    for (const auto& [x, sides] : rests) {
        for (const Side side : {Side::left, Side::right}) {
            if (x == 2.5 && side == Side::right) continue;  // of the shape
            if (x == 3.0 && side == Side::left) continue;
            const bool rest = sides[side == Side::left ? 0 : 1];
            EXPECT_EQ(std::abs(motion.at(x, side).derivative[3]) < 1e-7, rest) << x;
            EXPECT_EQ(std::abs(motion.higher_derivative(x, 4, side)) < 1e-5, rest) << x;
        }
    }
    EXPECT_NEAR(motion.higher_derivative(2.5, 3, Side::right), 0.3 * 60 / 0.125, 1e-9);
    EXPECT_TRUE(std::isnan(motion.higher_derivative(2.7, 4, Side::right)));
    EXPECT_EQ(motion.higher_derivative(1.2, 5, Side::right), 0.0);
}

/// A run across the end is shifted there and back: by the last digit its pieces ended in the shape behind.
TEST(MotionFamily, EveryPieceStaysInItsInterval) {
    std::mt19937 random(5);
    const auto length = [&] { return 0.1 + static_cast<double>(random() % 1000) / 97.0; };
    for (int trial = 0; trial < 300; ++trial) {
        const double a = length(), b = a + length(), c = b + length(), d = c + length(), e = d + length();
        FamilyRequest request{5, 2, DesignKind::states, {}, true, false};
        request.stretches = {spline(0, a, 4, 1.0), spline(a, b, 4, 0.0), shape(b, c, 0.5),
                             spline(c, d, 4, 0.75), spline(d, e, 4, {})};
        const MotionFamily family = MotionFamily::make(request);
        for (int k = 0; k < static_cast<int>(family.pieces().size()); ++k) {
            const MotionFamily::Piece& piece = family.pieces()[static_cast<std::size_t>(k)];
            const MotionFamily::Stretch& own = family.stretches()[static_cast<std::size_t>(piece.stretch)];
            ASSERT_EQ(family.piece_of(piece.begin, Side::right), k) << trial;
            ASSERT_EQ(family.piece_of(piece.end, Side::left), k) << trial;
            ASSERT_GE(piece.begin, own.begin) << trial;
            ASSERT_LE(piece.end, own.end) << trial;
        }
    }
}

}  // namespace motion_family_test
}  // namespace camopt

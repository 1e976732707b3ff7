// SPDX-License-Identifier: MIT
#include "output/plc/cam_loss.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"
#include "core/numbers/polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double same_joint_degree = 1e-9;  // joints of motion and table that are one but for rounding
constexpr int law_places = 64;
constexpr int law_sections = 60;

void keep_larger(CamDifference& largest, const CamDifference& found) {
    if (found.value > largest.value) largest = found;
}

/// d(t) = Σ d_k (t / h)^k of the difference of two polynomials about the same place.
Eigen::VectorXd scaled_difference(const std::vector<double>& a, const std::vector<double>& b, double h) {
    const std::size_t size = std::max(a.size(), b.size());
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
    double scale = 1.0;
    for (std::size_t k = 0; k < size; ++k, scale *= h)
        difference[static_cast<Eigen::Index>(k)] =
            scale * ((k < a.size() ? a[k] : 0.0) - (k < b.size() ? b[k] : 0.0));
    return difference;
}

CamDifference polynomial_difference(const std::vector<double>& exact, const CamPiece& piece,
                                    const MasterStretch& stretch, int order) {
    const double h = stretch.to - stretch.from;
    Eigen::VectorXd d = scaled_difference(exact, polynomial_about(piece, stretch.from), h);
    double scale = 1.0;
    for (int r = 0; r < order; ++r, scale /= h) d = differentiated(d);
    std::vector<double> places = sign_changes(differentiated(d), 0.0, 1.0);
    places.insert(places.end(), {0.0, 1.0});
    CamDifference largest{0.0, stretch.from};
    for (const double u : places)
        keep_larger(largest, {scale * std::abs(evaluate_polynomial(d, u)), stretch.from + u * h});
    return largest;
}

CamDifference searched_difference(const MasterCurve& curve, const CamPiece& piece,
                                  const MasterStretch& stretch, int order) {
    const double h = stretch.to - stretch.from;
    const auto difference = [&](double u) {
        const double theta = u >= 1.0 ? stretch.to : stretch.from + u * h;
        const Side inside = u > 0.5 ? Side::left : Side::right;  // at an end, and within rounding of it
        return std::abs(curve.at(theta, inside)[static_cast<std::size_t>(order)] -
                        value_of(piece, theta, order));
    };
    CamDifference largest{difference(0.0), stretch.from};
    keep_larger(largest, {difference(1.0), stretch.to});
    std::array<double, law_places + 1> at{};
    for (int i = 0; i <= law_places; ++i)
        at[static_cast<std::size_t>(i)] = difference(static_cast<double>(i) / law_places);
    for (std::size_t i = 0; i <= law_places; ++i) {
        const std::size_t below = i == 0 ? 0 : i - 1, above = std::min<std::size_t>(i + 1, law_places);
        if (at[i] < at[below] || at[i] < at[above]) continue;
        const GoldenSection top = golden_maximum(difference, static_cast<double>(below) / law_places,
                                                 static_cast<double>(above) / law_places, law_sections);
        keep_larger(largest, {top.value(), stretch.from + top.place() * h});
    }
    return largest;
}

CamDifference difference_without_joint(const MasterCurve& curve, const CamPiece& piece,
                                       const MasterStretch& stretch, int order) {
    const std::vector<double> exact = curve.polynomial(stretch.from, Side::right);
    return exact.empty() ? searched_difference(curve, piece, stretch, order)
                         : polynomial_difference(exact, piece, stretch, order);
}

void check_cover(const MasterCurve& curve, const std::vector<CamPiece>& pieces) {
    if (pieces.empty()) throw InputError("an electronic cam: found no piece");
    double reached = 0.0;
    for (const CamPiece& piece : pieces) {
        if (std::abs(piece.begin - reached) > same_joint_degree || !(piece.end > piece.begin))
            throw InputError(fmt::format("an electronic cam: a piece from {} to {} deg after {} deg",
                                         piece.begin, piece.end, reached));
        reached = piece.end;
    }
    if (std::abs(reached - curve.end()) > same_joint_degree)
        throw InputError(
            fmt::format("an electronic cam: ends at {} deg, the motion at {} deg", reached, curve.end()));
}

}  // namespace

CamDifference largest_difference(const MasterCurve& curve, const CamPiece& piece,
                                 const MasterStretch& stretch, int order) {
    CamDifference largest{0.0, stretch.from};
    double from = stretch.from;
    for (const double joint : curve.breakpoints()) {
        if (joint <= from + same_joint_degree || joint >= stretch.to - same_joint_degree) continue;
        keep_larger(largest, difference_without_joint(curve, piece, {from, joint}, order));
        from = joint;
    }
    keep_larger(largest, difference_without_joint(curve, piece, {from, stretch.to}, order));
    return largest;
}

std::array<CamDifference, 4> cam_loss(const MasterCurve& curve, const std::vector<CamPiece>& pieces,
                                      int orders) {
    check_cover(curve, pieces);
    const auto joint_at = [&](double theta) {  // the motion's own where the table means it
        for (const double joint : curve.breakpoints())
            if (std::abs(joint - theta) <= same_joint_degree) return joint;
        return theta;
    };
    std::array<CamDifference, 4> largest;
    for (const CamPiece& piece : pieces) {
        const MasterStretch stretch{joint_at(piece.begin), joint_at(piece.end)};
        for (int order = 0; order < orders; ++order)
            keep_larger(largest[static_cast<std::size_t>(order)],
                        largest_difference(curve, piece, stretch, order));
    }
    return largest;
}

std::array<CamDifference, 4> cam_peaks(const MasterCurve& curve) {
    return cam_loss(curve, {{0.0, curve.end(), {0.0}}});
}

}  // namespace camopt

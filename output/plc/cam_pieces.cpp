// SPDX-License-Identifier: MIT
#include "output/plc/cam_pieces.hpp"

#include "output/plc/cam_loss.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double close_enough = 1e-8;  // of the lift: a hundred times below what a drive's encoder resolves
constexpr double same_place_degree = 1e-9;

struct Stretch {
    double from = 0.0, to = 0.0;
    CamPiece piece;
    double error = 0.0;
};

/// The state at the master position the controller holds instead of `theta`, on the curve that `side` sees.
EndState held_state(const MasterCurve& curve, double theta, Side side, const FitOptions& options) {
    const std::array<double, 4> at = curve.at(theta, side);
    EndState state{theta, at[0], at[1], at[2]};
    if (!options.master) return state;
    state.theta = options.master(theta);
    const double step = state.theta - theta;
    state.s += step * (at[1] + step * (at[2] / 2.0 + step * at[3] / 6.0));
    state.v += step * (at[2] + step * at[3] / 2.0);
    state.a += step * at[3];
    return state;
}

/// The motion itself from joint to joint, where it is a polynomial of no higher degree there; else empty.
std::vector<double> own_polynomial(const MasterCurve& curve, double from, double to, int degree) {
    const auto inside = std::ranges::upper_bound(curve.breakpoints(), from + same_place_degree);
    if (inside != curve.breakpoints().end() && *inside < to - same_place_degree) return {};
    std::vector<double> own = curve.polynomial(from, Side::right);
    if (static_cast<int>(own.size()) > degree + 1) own.clear();
    return own;
}

Stretch stretch_between(const MasterCurve& curve, double from, double to, const FitOptions& options) {
    Stretch stretch{from, to, {}, 0.0};
    const EndState begin = held_state(curve, from, Side::right, options);
    const EndState end = held_state(curve, to, Side::left, options);
    const std::vector<double> own = own_polynomial(curve, from, to, options.degree);
    if (!own.empty())
        stretch.piece = {begin.theta, end.theta, polynomial_about({from, to, own}, begin.theta)};
    else
        stretch.piece = options.degree == 3 ? cubic_between(begin, end) : quintic_between(begin, end);
    stretch.error = largest_difference(curve, stretch.piece, {from, to}, 0).value;
    return stretch;
}

std::vector<double> joints_of(const MasterCurve& curve, const FitOptions& options) {
    if (!options.points) return curve.breakpoints();
    std::vector<double> joints;
    const int last = *options.points - 1;
    for (int i = 0; i <= last; ++i) joints.push_back(curve.end() * i / last);
    joints.back() = curve.end();
    return joints;
}

}  // namespace

double value_of(const CamPiece& piece, double theta, int order) {
    const double t = theta - piece.begin;
    double value = 0.0;
    for (int k = piece.degree(); k >= order; --k) {
        double factor = piece.coefficients[static_cast<std::size_t>(k)];
        for (int i = 0; i < order; ++i) factor *= k - i;
        value = value * t + factor;
    }
    return value;
}

std::vector<double> polynomial_about(const CamPiece& piece, double theta) {
    std::vector<double> coefficients;
    double factorial = 1.0;
    for (int k = 0; k <= piece.degree(); ++k) {
        if (k > 0) factorial *= k;
        coefficients.push_back(value_of(piece, theta, k) / factorial);
    }
    return coefficients;
}

CamPiece cubic_between(const EndState& from, const EndState& to) {
    const double h = to.theta - from.theta, rise = to.s - from.s;
    return {from.theta,
            to.theta,
            {from.s, from.v, (3.0 * rise / h - 2.0 * from.v - to.v) / h,
             (from.v + to.v - 2.0 * rise / h) / (h * h)}};
}

CamPiece quintic_between(const EndState& from, const EndState& to) {
    const double h = to.theta - from.theta;
    // What the parabola of the begin leaves open at the end, each by its own power of h.
    const double s = to.s - from.s - h * (from.v + h * from.a / 2.0);
    const double v = h * (to.v - from.v - h * from.a);
    const double a = h * h * (to.a - from.a);
    return {
        from.theta,
        to.theta,
        {from.s, from.v, from.a / 2.0, (10.0 * s - 4.0 * v + 0.5 * a) / (h * h * h),
         (-15.0 * s + 7.0 * v - a) / (h * h * h * h), (6.0 * s - 3.0 * v + 0.5 * a) / (h * h * h * h * h)}};
}

std::vector<CamPiece> fitted_pieces(const MasterCurve& curve, const FitOptions& options) {
    const std::vector<double> joints = joints_of(curve, options);
    std::vector<Stretch> stretches;
    for (std::size_t i = 1; i < joints.size(); ++i)
        stretches.push_back(stretch_between(curve, joints[i - 1], joints[i], options));
    const auto most = static_cast<std::size_t>(options.most);
    const auto worse = [](const Stretch& a, const Stretch& b) { return a.error < b.error; };
    std::ranges::make_heap(stretches, worse);
    while (!options.points && stretches.size() < most &&
           stretches.front().error > close_enough * curve.lift()) {
        std::ranges::pop_heap(stretches, worse);
        const Stretch halved = stretches.back();
        stretches.pop_back();
        const double middle = 0.5 * (halved.from + halved.to);
        for (const auto& [from, to] : {std::pair{halved.from, middle}, std::pair{middle, halved.to}}) {
            stretches.push_back(stretch_between(curve, from, to, options));
            std::ranges::push_heap(stretches, worse);
        }
    }
    std::ranges::sort(stretches, {}, &Stretch::from);
    std::vector<CamPiece> pieces;
    for (const Stretch& stretch : stretches) pieces.push_back(stretch.piece);
    return pieces;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/check/point_curve.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

constexpr std::size_t stencil_points = 7;  // sixth order; more points amplify the rounding of the input
constexpr int improvements = 2;            // of the parameter: each gains two orders
constexpr double repeated = 1e-9;          // of the mean distance: a point this close repeats its predecessor

/// Weights of the values at `places` for the first and the second derivative at `at`. Source: B. Fornberg,
/// Generation of finite difference formulas on arbitrarily spaced grids, Math. Comp. 51 (1988).
using Weights = std::array<std::array<double, 3>, stencil_points>;

Weights derivative_weights(double at, std::span<const double> places) {
    Weights weights{};
    double product = 1.0, distance = places[0] - at;
    weights[0][0] = 1.0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const std::size_t most = std::min<std::size_t>(i, 2);
        const double before = distance;
        double next_product = 1.0;
        distance = places[i] - at;
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = places[i] - places[j];
            next_product *= gap;
            if (j + 1 == i) {
                for (std::size_t k = most; k > 0; --k)
                    weights[i][k] =
                        product *
                        (static_cast<double>(k) * weights[i - 1][k - 1] - before * weights[i - 1][k]) /
                        next_product;
                weights[i][0] = -product * before * weights[i - 1][0] / next_product;
            }
            for (std::size_t k = most; k > 0; --k)
                weights[j][k] = (distance * weights[j][k] - static_cast<double>(k) * weights[j][k - 1]) / gap;
            weights[j][0] = distance * weights[j][0] / gap;
        }
        product = next_product;
    }
    return weights;
}

template <class Point>
struct NodeDerivatives {
    Point first = Point::Zero(), second = Point::Zero();
};

template <class Point>
double mean_distance(std::span<const Point> points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
    return sum / static_cast<double>(points.size());
}

}  // namespace

template <int dimension>
PointCurveOf<dimension>::PointCurveOf(std::span<const Point> points, std::span<const int> breaks, bool closed)
    : closed_(closed) {
    std::set<std::size_t> wanted;
    for (const int index : breaks) {
        if (index < 0 || index >= static_cast<int>(points.size()))
            throw InputError(fmt::format("break {} of a curve of {} points", index, points.size()));
        wanted.insert(static_cast<std::size_t>(index));
    }
    const double near = repeated * mean_distance(points);
    std::set<std::size_t> kept{0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points_.empty() || (points[i] - points_.back()).norm() > near) points_.push_back(points[i]);
        if (wanted.contains(i)) kept.insert(points_.size() - 1);
    }
    if (closed && points_.size() > 1) {
        if ((points_.back() - points_.front()).norm() <= near)
            points_.back() = points_.front();
        else
            points_.push_back(points_.front());
    }
    if (points_.size() < 3) throw InputError("a curve needs at least three different points");
    kept.insert(points_.size() - 1);
    breaks_.assign(kept.begin(), kept.end());
    set_chord_parameters();
    fit();
    for (int i = 0; i < improvements; ++i) {
        set_arc_parameters();
        fit();
    }
}

template <int dimension>
void PointCurveOf<dimension>::set_chord_parameters() {
    nodes_.assign(points_.size(), 0.0);
    for (std::size_t i = 1; i < points_.size(); ++i)
        nodes_[i] = nodes_[i - 1] + (points_[i] - points_[i - 1]).norm();
}

template <int dimension>
void PointCurveOf<dimension>::set_arc_parameters() {
    // Exact far beyond the quintic's own error.
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        double length = 0.0;
        for (const QuadraturePoint& point : gauss_legendre) {
            const double place = 0.5 + 0.5 * point.place;
            Point slope = Point::Zero();
            for (int power = 5; power > 0; --power) slope = slope * place + power * pieces_[i].col(power);
            length += 0.5 * point.weight * slope.norm();
        }
        nodes_[i + 1] = nodes_[i] + length;
    }
}

template <int dimension>
void PointCurveOf<dimension>::fit() {
    pieces_.assign(points_.size() - 1, Quintic::Zero());
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) fit_section(breaks_[i], breaks_[i + 1]);
}

template <int dimension>
void PointCurveOf<dimension>::fit_section(std::size_t first, std::size_t last) {
    const std::size_t count = last - first + 1, width = std::min(stencil_points, count);
    std::vector<NodeDerivatives<Point>> derivatives(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t left = first + std::min(i - std::min(i, width / 2), count - width);
        const Weights weights = derivative_weights(nodes_[first + i], std::span(nodes_).subspan(left, width));
        for (std::size_t k = 0; k < width; ++k) {
            derivatives[i].first += weights[k][1] * points_[left + k];
            derivatives[i].second += weights[k][2] * points_[left + k];
        }
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double step = nodes_[first + i + 1] - nodes_[first + i];
        const Point from = points_[first + i], rise = points_[first + i + 1] - from;
        const Point v0 = step * derivatives[i].first, v1 = step * derivatives[i + 1].first;
        const Point a0 = step * step * derivatives[i].second, a1 = step * step * derivatives[i + 1].second;
        Quintic& piece = pieces_[first + i];
        piece.col(0) = from;
        piece.col(1) = v0;
        piece.col(2) = 0.5 * a0;
        piece.col(3) = 10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1;
        piece.col(4) = -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1;
        piece.col(5) = 6.0 * rise - 3.0 * (v0 + v1) - 0.5 * (a0 - a1);
    }
}

template <int dimension>
auto PointCurveOf<dimension>::at(double parameter) const -> Point {
    if (closed_) parameter -= length() * std::floor(parameter / length());
    const auto next = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, parameter);
    const auto i = static_cast<std::size_t>(next - nodes_.begin()) - 1;
    const double t = std::clamp((parameter - nodes_[i]) / (nodes_[i + 1] - nodes_[i]), 0.0, 1.0);
    Point value = pieces_[i].col(5);
    for (int power = 4; power >= 0; --power) value = value * t + pieces_[i].col(power);
    return value;
}

template class PointCurveOf<2>;
template class PointCurveOf<3>;

}  // namespace camopt

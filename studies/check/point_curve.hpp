// SPDX-License-Identifier: MIT
// A smooth curve, plane or in space, through given points and nothing else.
//
// Between neighbouring points a quintic that takes over position, first and second derivative; the
// derivatives come from the polynomial through the seven nearest points of the same section (fewer in a short
// one), so the error is of the sixth order in their distance. Sections meet at the breaks, where only the
// position is joined. Parameter: arc length, improved twice from the chords. Lengths in the points' unit.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

/// dimension: 2 or 3.
template <int dimension>
class PointCurveOf {
 public:
    using Point = Eigen::Matrix<double, dimension, 1>;

    /// breaks: indices of points where the curve may be less smooth; begin and end count as breaks always.
    /// Closed: the last point is joined to the first (it may repeat it). Points that repeat their predecessor
    /// are left out. Throws InputError for fewer than three different points and an index out of range.
    PointCurveOf(std::span<const Point> points, std::span<const int> breaks, bool closed);

    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] double length() const { return nodes_.back(); }
    /// The parameters of the points, ascending from 0; closed: the last one is the first point again.
    [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
    /// Closed: any parameter; open: clamped to [0, length].
    [[nodiscard]] Point at(double parameter) const;

 private:
    void fit();
    void set_chord_parameters();
    void set_arc_parameters();
    void fit_section(std::size_t first, std::size_t last);

    /// Coefficients of powers of (parameter − node) / (next node − node).
    using Quintic = Eigen::Matrix<double, dimension, 6>;

    bool closed_;
    std::vector<Point> points_;        ///< closed: with the first one again at the end
    std::vector<std::size_t> breaks_;  ///< begin and end included
    std::vector<double> nodes_;
    std::vector<Quintic> pieces_;
};

using PointCurve = PointCurveOf<2>;
using SpacePointCurve = PointCurveOf<3>;

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A grid of points as a B-spline surface through every one of them: what CAD systems take.
//
// Tensor product, cubic in both directions (fewer points: as many degrees as they allow), interpolating at
// the grid's own parameters, with not-a-knot ends. So a point's parameters are those of the grid (cam angle
// and station), and between points the error is of the fourth order in the spacing. Where a grid has breaks,
// one patch a piece: patches meet in the same points. Lengths m.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

// A surface as a grid of points with its parameters: what meshes and B-spline surfaces are made from. m.
struct SurfaceGrid {
    std::string name;
    std::vector<double> u, v;             ///< ascending parameters of columns and rows, at least two each
    std::vector<Eigen::Vector3d> points;  ///< at index row · u.size() + column
    std::vector<int> breaks;              ///< columns inside where the surface is less smooth, ascending

    [[nodiscard]] const Eigen::Vector3d& at(std::size_t row, std::size_t column) const {
        return points[row * u.size() + column];
    }

    void validate() const;  ///< throws InputError
};

struct BsplineSurface {
    std::string name;
    int degree_u = 3, degree_v = 3;
    std::vector<double> knots_u, knots_v;  ///< clamped: poles + degree + 1 each
    std::vector<Eigen::Vector3d> poles;    ///< at index row · columns + column

    [[nodiscard]] std::size_t columns() const { return knots_u.size() - degree_u - 1; }
    [[nodiscard]] std::size_t rows() const { return knots_v.size() - degree_v - 1; }
    [[nodiscard]] Eigen::Vector3d at(double u, double v) const;
};

/// One patch between neighbouring breaks. Throws InputError for a grid that is not valid.
[[nodiscard]] std::vector<BsplineSurface> bspline_surfaces(const SurfaceGrid& grid);

}  // namespace camopt

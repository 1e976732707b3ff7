// SPDX-License-Identifier: MIT
// A surface as a grid of points with its parameters: what meshes and B-spline surfaces are made from. m.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace camopt {

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

}  // namespace camopt

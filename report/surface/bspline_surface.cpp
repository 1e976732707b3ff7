// SPDX-License-Identifier: MIT
#include "report/surface/bspline_surface.hpp"

#include "core/errors.hpp"

#include <Eigen/SparseLU>
#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int cubic = 3;

/// The functions that live at a parameter: index of the first one, and their values (de Boor).
struct Blend {
    std::size_t first = 0;
    std::array<double, cubic + 1> value{};
};

Blend blend_at(const std::vector<double>& knots, int degree, double x) {
    const std::size_t count = knots.size() - static_cast<std::size_t>(degree) - 1;
    const auto after = std::upper_bound(knots.begin() + degree, knots.begin() + static_cast<long>(count), x);
    const std::size_t span = static_cast<std::size_t>(after - knots.begin()) - 1;
    Blend blend{span - static_cast<std::size_t>(degree), {1.0}};
    for (std::size_t d = 1; d <= static_cast<std::size_t>(degree); ++d) {
        double carried = 0.0;
        for (std::size_t i = 0; i < d; ++i) {
            const double right = knots[span + i + 1], left = knots[span + i + 1 - d];
            const double part = blend.value[i] / (right - left);
            blend.value[i] = carried + (right - x) * part;
            carried = (x - left) * part;
        }
        blend.value[d] = carried;
    }
    return blend;
}

/// Clamped, with not-a-knot ends: the second and the last but one node are no knots. Degrees below three
/// carry one polynomial.
std::vector<double> knots_of(const std::vector<double>& nodes, int degree) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, nodes.front());
    for (std::size_t i = 2; degree == cubic && i + 2 < nodes.size(); ++i) knots.push_back(nodes[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, nodes.back());
    return knots;
}

/// Fewer than four nodes carry one polynomial.
int degree_of(std::size_t nodes) {
    return std::min(cubic, static_cast<int>(nodes) - 1);
}

/// Poles of curves whose values at the nodes are the rows of `values`.
Eigen::MatrixXd interpolated(const std::vector<double>& nodes, const std::vector<double>& knots, int degree,
                             const Eigen::MatrixXd& values) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Blend blend = blend_at(knots, degree, nodes[i]);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
            entries.emplace_back(static_cast<int>(i), static_cast<int>(blend.first + k), blend.value[k]);
    }
    const auto size = static_cast<Eigen::Index>(nodes.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
    return factor.solve(values);
}

BsplineSurface patch(const SurfaceGrid& grid, std::size_t from, std::size_t to) {
    BsplineSurface surface;
    const std::vector<double> u(grid.u.begin() + static_cast<long>(from),
                                grid.u.begin() + static_cast<long>(to) + 1);
    surface.degree_u = degree_of(u.size());
    surface.degree_v = degree_of(grid.v.size());
    surface.knots_u = knots_of(u, surface.degree_u);
    surface.knots_v = knots_of(grid.v, surface.degree_v);
    const auto columns = static_cast<Eigen::Index>(u.size()), rows = static_cast<Eigen::Index>(grid.v.size());
    surface.poles.resize(u.size() * grid.v.size());
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
        Eigen::MatrixXd values(rows, columns);
        for (Eigen::Index r = 0; r < rows; ++r)
            for (Eigen::Index c = 0; c < columns; ++c)
                values(r, c) =
                    grid.at(static_cast<std::size_t>(r), from + static_cast<std::size_t>(c))(coordinate);
        const Eigen::MatrixXd along_v = interpolated(grid.v, surface.knots_v, surface.degree_v, values);
        const Eigen::MatrixXd poles =
            interpolated(u, surface.knots_u, surface.degree_u, along_v.transpose()).transpose();
        for (Eigen::Index r = 0; r < rows; ++r)
            for (Eigen::Index c = 0; c < columns; ++c)
                surface.poles[r * columns + c](coordinate) = poles(r, c);
    }
    return surface;
}

void check_parameters(const std::string& name, const char* which, const std::vector<double>& values) {
    if (values.size() < 2)
        throw InputError(
            fmt::format("surface {}: it needs two {} at least, found {}", name, which, values.size()));
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1]))
            throw InputError(fmt::format("surface {}: its {} must ascend; found {} after {}", name, which,
                                         values[i], values[i - 1]));
}

}  // namespace

Eigen::Vector3d BsplineSurface::at(double u, double v) const {
    const Blend across = blend_at(knots_u, degree_u, u), along = blend_at(knots_v, degree_v, v);
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (std::size_t r = 0; r <= static_cast<std::size_t>(degree_v); ++r)
        for (std::size_t c = 0; c <= static_cast<std::size_t>(degree_u); ++c)
            point +=
                along.value[r] * across.value[c] * poles[(along.first + r) * columns() + across.first + c];
    return point;
}

std::vector<BsplineSurface> bspline_surfaces(const SurfaceGrid& grid) {
    grid.validate();
    std::vector<std::size_t> ends{0};
    for (const int column : grid.breaks) ends.push_back(static_cast<std::size_t>(column));
    ends.push_back(grid.u.size() - 1);
    std::vector<BsplineSurface> surfaces;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        surfaces.push_back(patch(grid, ends[k - 1], ends[k]));
        surfaces.back().name = ends.size() == 2 ? grid.name : fmt::format("{} piece {}", grid.name, k);
    }
    return surfaces;
}

void SurfaceGrid::validate() const {
    check_parameters(name, "columns", u);
    check_parameters(name, "rows", v);
    if (points.size() != u.size() * v.size())
        throw InputError(fmt::format("surface {}: {} x {} points expected, found {}", name, v.size(),
                                     u.size(), points.size()));
    for (const Eigen::Vector3d& point : points)
        if (!point.allFinite()) throw InputError(fmt::format("surface {}: a point is not finite", name));
    int before = 0;
    for (const int column : breaks) {
        if (column <= before || column >= static_cast<int>(u.size()) - 1)
            throw InputError(
                fmt::format("surface {}: breaks must ascend between the first and the last column", name));
        before = column;
    }
}

}  // namespace camopt

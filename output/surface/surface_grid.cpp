// SPDX-License-Identifier: MIT
#include "output/surface/surface_grid.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

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

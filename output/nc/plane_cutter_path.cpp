// SPDX-License-Identifier: MIT
#include "output/nc/plane_cutter_path.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace camopt {

void PlaneCutter::validate() const {
    if (!(std::isfinite(diameter) && diameter > 0.0))
        throw InputError(fmt::format("plane cutter: the diameter must be > 0 m, found {:g}", diameter));
    if (!(std::isfinite(stock) && stock >= 0.0))
        throw InputError(fmt::format("plane cutter: the stock must be >= 0 m, found {:g}", stock));
    if (!std::isfinite(bottom)) throw InputError("plane cutter: the bottom must be a finite height");
}

ToolPath plane_cutter_path(PlaneContour contour, const PlaneCutter& cutter) {
    cutter.validate();
    return [contour = std::move(contour), cutter](double theta) {
        const ContourPoint point = contour(theta);
        const Eigen::Vector2d axis = point.position + (0.5 * cutter.diameter + cutter.stock) * point.normal;
        return ToolPose{{axis.x(), axis.y(), cutter.bottom}, -Eigen::Vector3d::UnitZ()};
    };
}

}  // namespace camopt

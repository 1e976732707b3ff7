// SPDX-License-Identifier: MIT
#include "output/nc/cutter_location.hpp"

#include "core/errors.hpp"
#include "output/nc/requirement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace camopt {

namespace {

// A cutter that is said to equal the roller may differ in the last digits of the unit it was given in.
constexpr double equal_diameters = 1e-9;

constexpr Requirement require_location{"cutter location"};

}  // namespace

void CutterLocation::validate() const {
    require_location(std::isfinite(roller_radius) && roller_radius > 0.0, "the roller radius must be > 0 m",
                     roller_radius);
    require_location(std::isfinite(diameter) && diameter > 0.0, "the cutter diameter must be > 0 m",
                     diameter);
    require_location(std::isfinite(stock) && stock >= 0.0, "the stock must be >= 0 m", stock);
    require_location(flank == 1 || flank == -1, "the flank must be +1 or -1", flank);
    require_location(std::isfinite(station), "the station must be a finite length", station);
    require_location(std::isfinite(tip_beyond) && tip_beyond >= 0.0,
                     "the tip must lie at or beyond the steered station, by >= 0 m", tip_beyond);
    require_location(
        0.5 * diameter + stock <= roller_radius * (1.0 + equal_diameters),
        "cutter radius + stock must not exceed the roller radius, or the other flank is cut away; m",
        0.5 * diameter + stock);
}

ToolPose cutter_pose(const RollerPose& roller, const CutterLocation& location) {
    const double radius = location.roller_radius;
    const Eigen::Vector3d near = roller.center + location.flank * radius * roller.normal;
    const Eigen::Vector3d far = roller.center - location.flank * radius * roller.normal;
    const double share = (location.diameter + 2.0 * location.stock) / (4.0 * radius);
    const Eigen::Vector3d steered = near + share * (far - near);
    return {steered + location.tip_beyond * roller.axis, roller.axis};
}

ToolPath cutter_path(RollerPath roller, const CutterLocation& location) {
    location.validate();
    return [roller = std::move(roller), location](double theta) {
        return cutter_pose(roller(theta, location.station), location);
    };
}

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

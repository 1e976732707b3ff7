// SPDX-License-Identifier: MIT
// STEP (AP214): a plate as one solid, its outline and hole as lines, arcs and B-spline curves, in mm. Written
// by Open CASCADE where this build has it.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

#include <filesystem>

namespace camopt {

/// One edge of a line around a plate. m. Two points: a line. An arc: `middle` is a third point of it. A
/// curve: a clamped cubic B-spline, poles instead of the ends.
struct PlateEdge {
    enum class Kind { line, arc, curve } kind = Kind::line;
    Eigen::Vector2d from = {0.0, 0.0}, to = {0.0, 0.0}, middle = {0.0, 0.0};
    std::vector<double> knots = {};
    std::vector<Eigen::Vector2d> poles = {};  ///< the first is `from`, the last `to`
};

/// The boundary of a plate between z = −thickness and z = 0: plane faces and upright walls between closed
/// lines, which are exact edges (STEP) or polygons (STL).
template <class Line>
struct PlateOf {
    /// A closed channel in the upper face, z = −depth to 0, between two lines that lie inside the plate.
    struct Groove {
        Line outer, inner;
        double depth = 0.0;  ///< m, in (0, thickness)
    };
    double thickness = 20e-3;
    Line outline, hole;  ///< the hole may be empty
    std::optional<Groove> groove = {};
};

/// Every edge begins where the one before it ends.
struct Plate : PlateOf<std::vector<PlateEdge>> {
    std::string name, author = {}, organisation = {};  ///< in the header of the file
};

/// The file is there whole or not at all. Returns the volume that Open CASCADE finds, m³. Throws
/// UnavailableError in a build without it, InputError where the file cannot be written or it refuses the
/// plate.
double write_step_solid(const std::filesystem::path& path, const Plate& plate);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A disk cam as a solid with its bore and keyway, a plate with its sides and its bottom: triangles for STL,
// exact edges for STEP.
//
// Frame of report/drawing/profile_shape.hpp, between z = −thickness and z = 0. Only cams that close and that
// are not undercut. m.
#pragma once

#include "report/drawing/profile_shape.hpp"
#include "report/surface/triangle_mesh.hpp"
#include "shop/step/step_solid.hpp"

namespace camopt {

struct DiskMeshOptions {
    double chord_tolerance = 5e-6;   ///< m, > 0: the facets stay this close to cam and bore
    std::optional<int> points = {};  ///< around the cam instead, evenly by cam angle
};

struct DiskMesh {
    TriangleMesh mesh;
    double deviation = 0.0;            ///< m: the largest distance of a facet from the cam
    double volume = 0.0, exact = 0.0;  ///< m³: of the triangles, of the cam itself
};

/// cam_volume of shop/sheet, checked as below. Each of these is for a cam that is made in one piece
/// (made_pieces).
[[nodiscard]] double disk_volume(const ProfileShape& shape, const DrawingSpec& drawing);

/// The drawing has a thickness, and bore and keyway lie inside the cam (drawing_of of shop/sheet). Throws
/// InputError for an open cam, an undercut one, and numbers that are not valid.
[[nodiscard]] DiskMesh disk_mesh(const ProfileShape& shape, const DrawingSpec& drawing,
                                 const DiskMeshOptions& options = {});

/// Dwells as arcs, all else as cubic B-splines through points of the cam, within 1e-8 m of it. Throws as
/// above.
[[nodiscard]] Plate disk_plate(const ProfileShape& shape, const DrawingSpec& drawing,
                               const std::string& name);

/// Of the cam, evenly by cam angle.
[[nodiscard]] std::vector<Eigen::Vector2d> contour_points(const ProfileShape& shape, int count);

/// What can be milled or be a solid: throws InputError for a cam that is open (why, and what would close it),
/// for two disks at once, and where it is undercut.
void check_can_be_made(const ProfileShape& shape);

}  // namespace camopt

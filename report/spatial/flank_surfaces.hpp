// SPDX-License-Identifier: MIT
// The flanks of a three-dimensional cam as what other programs take: tables of points, grids for B-spline
// surfaces, solids. Frame of scene/cam_flanks.hpp; m inside, mm in texts.
#pragma once

#include "report/surface/triangle_mesh.hpp"
#include "scene/cam_flanks.hpp"

namespace camopt {

/// σ_f = +1, then −1; u the cam angle in rad, v the height h in m, breaks those of the motion.
[[nodiscard]] std::array<SurfaceGrid, 2> flank_surfaces(const FlankGrid& grid);

/// Of a groove whose body is turned to this radius: its sections then lie evenly along the roller from where
/// each flank leaves the outside, or from its near end where that lies within, to its far end.
void cut_at_outside(FlankGrid& grid, const CamFlanks& cam, const FollowerMotion& motion, double radius);

/// CSV: flank, h_mm, theta_deg, x_mm, y_mm, z_mm, nx, ny, nz (out of the material); a line a point, numbers
/// that read back as the same doubles.
[[nodiscard]] std::string flank_csv(const FlankGrid& grid);

/// What the roller takes out of the blank between the first and the last section: a solid, closed at both
/// ends of the motion. Its sections are the contact lines of both flanks, so near the ends of the groove,
/// where the roller's round part cuts, it is that much shorter.
[[nodiscard]] TriangleMesh groove_body(const FlankGrid& grid);

/// A blank around the cam's axis that carries one closed groove.
struct GroovedBlank {
    double bore_radius = 0.0;         ///< m, > 0
    double outer_radius = 0.0;        ///< m, above the bore's and the groove's floor
    double lower = 0.0, upper = 0.0;  ///< z of its ends, m
};

/// The whole cam as a solid, for grooves that close after one turn (the same sections at the first and the
/// last angle within 1e-9 m). Between groove and ends the outside is ruled from the groove's edge to the
/// blank's rim; the floor is straight across. Throws InputError for an open groove and a blank that does not
/// hold it.
[[nodiscard]] TriangleMesh grooved_cam(const FlankGrid& grid, const GroovedBlank& blank);

/// The motion takes a turn and ends where it begins.
[[nodiscard]] bool groove_closes(const FollowerMotion& motion);

/// The same with the body that the scene gives or, where it says nothing, a wall of the roller's radius at
/// its ends, an outside up to the roller's near end and a bore of a third of the groove's least radius. The
/// groove closes.
[[nodiscard]] TriangleMesh drum_solid(const CamFlanks& cam, const FollowerMotion& motion,
                                      const FlankSampling& sampling);

// A three-dimensional cam with its rollers as what is drawn and moved: meshes that turn with the cam, and
// where every roller stands at given cam angles. Frames of scene/cam_flanks.hpp; m, rad.
//
//   the motion takes a turn and ends one pitch on   the body (indexing_body.hpp), all rollers of the index
//   the groove closes after one turn                the grooved drum as a solid
//   else                                            both flanks as surfaces around a core
// How far a drum reaches beyond its groove, its bore and its core are choices of drawing.

/// The near end of a roller's axis and its unit direction, in the frame that stands still.
struct RollerPlace {
    Eigen::Vector3d foot, direction;
};

struct CamScene {
    struct Part {
        std::string name;  ///< "cam", "drum", "core", "flank +1"
        TriangleMesh mesh;
        bool closed = true;  ///< a solid; false: a surface, seen from both sides
    };
    std::vector<Part> parts;  ///< in the cam frame at cam angle 0; they turn by σθ about z
    double roller_radius = 0.0, roller_length = 0.0;
    /// By roller, then by angle.
    std::vector<std::vector<RollerPlace>> rollers;
    std::optional<Eigen::Vector3d> pivot;  ///< about which the rollers swing; none: they slide
};

/// angles: cam angles within the motion, rad.
[[nodiscard]] CamScene cam_scene(const CamFlanks& cam, const FollowerMotion& motion,
                                 std::span<const double> angles);

}  // namespace camopt

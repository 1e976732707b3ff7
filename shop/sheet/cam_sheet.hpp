// SPDX-License-Identifier: MIT
// The workshop drawing of a delivered cam that is a disk: outline, pitch curve, base and prime circle, bore,
// keyway, datum mark, sense of rotation, a section, dimensions, a table of radii, limits of form, title
// block.
//
// On A4, or on A3 where A4 would make it smaller than it is, at the largest scale of ISO 5455 that fits. The
// model is the cam frame (report/drawing/profile_shape.hpp); the section lies beside it. The table counts its
// angle from the datum mark, as the cam angle grows: the ray at α is the one that points along +y at the cam
// angle datum + α. R: from the centre to the cam along that ray, the outermost where there are several. Of a
// grooved cam the outline is the rim of its disk; R and Ro are the radii of the inner and the outer flank,
// the section shows the groove in the upper face.
#pragma once

#include "report/drawing/profile_shape.hpp"
#include "shop/sheet/sheet.hpp"

namespace camopt {

inline constexpr double default_thickness = 20e-3;  ///< m, of a disk cam where nothing says it

struct CamSheetOptions {
    std::optional<double> bore = {}, thickness = {};  ///< m: in place of the scene's
};

/// What the scene and the options say together. Throws InputError where bore or keyway do not lie inside the
/// cam: what was found, what is allowed.
[[nodiscard]] DrawingSpec drawing_of(const Solution& solution, const ProfileShape& shape,
                                     const CamSheetOptions& options);

/// One for each piece (made_pieces): two of a conjugate cam, else one. Throws InputError as above, for a
/// solution without a disk cam, and for a cam too large for any sheet.
[[nodiscard]] std::vector<Sheet> cam_sheets(const View& view, const CamSheetOptions& options = {});

/// Unit vector of the cam frame that points along +y when the cam has turned by this cam angle.
[[nodiscard]] Eigen::Vector2d ray_at(Rotation rotation, double cam_angle);

/// From the centre along a ray to the cam's outline, or to its pitch curve: the outermost crossing; none
/// where the ray meets none.
[[nodiscard]] std::optional<double> radius_along(const ProfileShape& shape, const Eigen::Vector2d& ray,
                                                 bool of_cam);

/// Of the outline from the centre, m.
[[nodiscard]] double least_radius(const ProfileShape& shape);

/// (area of the outline − area of bore and keyway) · thickness, m³: the outline as arcs within 1e-8 m. Of a
/// grooved cam the outline is the rim (rim_radius), and the groove, its area times its depth, is missing. For
/// a closed cam of one piece and a drawing as drawing_of gives it.
[[nodiscard]] double cam_volume(const ProfileShape& shape, const DrawingSpec& drawing);

/// The disk that a groove is cut into.
[[nodiscard]] std::vector<ArcVertex> rim_outline(const ProfileShape& shape);

/// Of the bore with its keyway, in the cam frame: an open ring of lines and arcs, its last vertex joined to
/// the first; turns to the left. Only where there is a bore.
[[nodiscard]] std::vector<ArcVertex> bore_outline(const DrawingSpec& drawing, Rotation rotation);

}  // namespace camopt

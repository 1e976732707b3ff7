// SPDX-License-Identifier: MIT
// The drawing of a plane cam of any kind: one description for pictures, DXF files, sheets and pages. m.
//
//   cam_outlines     cam frame (profile_shape.hpp): cam; second, second-pitch (conjugate disks); groove, rim;
//                    wall-left, wall-right (guide); pitch, circle (base), prime; open. A plate's cam is its
//                    whole body
//   add_mechanism    link, face, roller, guide where the motion begins; ghost: a disk cam's follower
//                    every 60° of the cam, a linkage at both ends of its output; slot, and the roller of a
//                    guide at both ends
//   add_marks        mark, undercut, ring, center, arrow, arrow-head, joint, dot, ground, pivot, slider:
//                    marks whose size is that of the picture
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/drawing/profile_shape.hpp"

namespace camopt {

/// The outline of a side of the cam, or its pitch curve.
using SideCurve = std::function<std::vector<ArcVertex>(const ProfileShape& side, bool of_cam)>;
/// Straight between that many points.
[[nodiscard]] SideCurve sampled_curve(int count);

/// A curve of the cam as the line around its body: of a plate with the sides and the bottom.
[[nodiscard]] std::vector<ArcVertex> body_outline(const ProfileShape& shape, std::vector<ArcVertex> surface);

[[nodiscard]] Drawing cam_outlines(const ProfileShape& shape, const SideCurve& curve);
/// "base circle": what an outline is to a reader.
[[nodiscard]] std::string outline_words(const ProfileShape& shape, std::string_view style);

/// From where to where a flat face is drawn, along itself from the origin of contact offsets, m: as the scene
/// says, or as wide as the contact needs and a little more.
[[nodiscard]] std::pair<double, double> reach_of_face(const ProfileShape& shape);
/// ProfileShape::parts with its face from end to end.
[[nodiscard]] std::vector<MechanismShape> drawn_parts(const ProfileShape& shape, double theta,
                                                      const std::pair<double, double>& reach);
/// ProfileShape::parts where they lie in the drawing: turned back as far as the cam has turned at `back`.
[[nodiscard]] std::vector<MechanismShape> placed_parts(const ProfileShape& shape, double theta, double back);

/// The cam is moved to its place in the frame that stands still where the motion begins.
void add_mechanism(Drawing& drawing, const ProfileShape& shape);

/// Where a mark shows a cam angle, in the same frame.
struct AngleMark {
    double theta = 0.0;
    Eigen::Vector2d at, inwards;  ///< on the cam; unit vector into it
};
[[nodiscard]] std::vector<AngleMark> angle_marks(const ProfileShape& shape);
/// px: m of a picture's pixel.
void add_marks(Drawing& drawing, const ProfileShape& shape, double px);

}  // namespace camopt

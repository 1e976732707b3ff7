// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_summary.hpp"

#include "studies/delivered/cam_turn.hpp"
#include "studies/delivered/follower_figures.hpp"

#include <cmath>

namespace camopt {

namespace {

/// Radii of the cam follow from the pitch curve's: the curvature is smooth where a radius is not.
void add_radii_of_pitch(CamSummary& summary, const DrivenMechanism& cam, const CamTurn& turn) {
    const int which = cam.formulas->roller_radius();
    const double roller = which < 0 ? 0.0 : cam.dimensions[static_cast<std::size_t>(which)];
    const auto curvature = [](const CamPlace& place) { return place.point.pitch_curvature; };
    const CamExtreme sharpest = turn.largest(curvature), hollow = turn.least(curvature);
    if (sharpest.value > 0.0) summary.convex_radius = CamExtreme{1.0 / sharpest.value - roller, sharpest.at};
    if (hollow.value < 0.0) summary.concave_radius = CamExtreme{roller - 1.0 / hollow.value, hollow.at};
}

void add_radii_of_face(CamSummary& summary, const CamTurn& turn) {
    summary.convex_radius = turn.least([](const CamPlace& place) { return place.point.cam_radius; });
    summary.contact_offset =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.contact_offset); });
}

}  // namespace

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale) {
    const CamTurn turn(cam, motion, scale);
    CamSummary summary;
    summary.pressure_angle =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.pressure_angle); });
    summary.regularity = turn.least([](const CamPlace& place) { return place.point.regularity; });
    if (!cam.formulas->planar()) return summary;
    if (cam.formulas->has_pitch_curve())
        add_radii_of_pitch(summary, cam, turn);
    else
        add_radii_of_face(summary, turn);
    const std::optional<double> base = cam.formulas->base_radius(cam.dimensions);
    summary.base_radius =
        base ? *base : turn.least([](const CamPlace& place) { return place.point.contact.norm(); }).value;
    return summary;
}

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const Scene& scene) {
    CamSummary summary = cam_summary(cam, motion, {scene.motion.lift, scene.motion.unit_angle()});
    add_follower_figures(summary, cam, motion, scene);
    return summary;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/delivered/cam/cam_summary.hpp"

#include "studies/delivered/cam/cam_turn.hpp"
#include "studies/delivered/cam/follower_figures.hpp"

#include <cmath>
#include <utility>

namespace camopt {

namespace {

/// Radii of the cam follow from the pitch curve's: the curvature is smooth where a radius is not.
SideSummary side_summary(const DrivenMechanism& cam, const CamTurn& turn, int station) {
    SideSummary side;
    side.name = cam.formulas->station_name(station);
    if (cam.formulas->stations() > 1) {
        side.pressure_angle =
            turn.largest([](const CamPlace& place) { return std::abs(place.point.pressure_angle); }, station);
        side.regularity = turn.least([](const CamPlace& place) { return place.point.regularity; }, station);
    }
    const double offset = cam.formulas->surface_offset(cam.dimensions, station);
    const auto curvature = [](const CamPlace& place) { return place.point.pitch_curvature; };
    const CamExtreme sharpest = turn.largest(curvature, station), hollow = turn.least(curvature, station);
    if (sharpest.value > 0.0) side.convex_radius = CamExtreme{1.0 / sharpest.value - offset, sharpest.at};
    if (hollow.value < 0.0) side.concave_radius = CamExtreme{offset - 1.0 / hollow.value, hollow.at};
    return side;
}

void keep_least(std::optional<CamExtreme>& least, const std::optional<CamExtreme>& other) {
    if (other && (!least || other->value < least->value)) least = other;
}

void add_radii_of_pitch(CamSummary& summary, const DrivenMechanism& cam, const CamTurn& turn) {
    const int stations = cam.formulas->stations();
    for (int station = 0; station < stations; ++station) {
        SideSummary side = side_summary(cam, turn, station);
        keep_least(summary.convex_radius, side.convex_radius);
        keep_least(summary.concave_radius, side.concave_radius);
        if (stations > 1) summary.sides.push_back(std::move(side));
    }
}

void add_radii_of_face(CamSummary& summary, const CamTurn& turn) {
    summary.convex_radius = turn.least([](const CamPlace& place) { return place.point.cam_radius; });
    summary.contact_offset =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.contact_offset); });
}

}  // namespace

namespace {

/// A limit of 0 is met to the tolerance of the solve, and figures come from a search of their own: a
/// regularity this close to 0 is 0, and with it the radius.
constexpr double cusp_rounding = 1e-8;

void round_cusp(CamExtreme& regularity, std::optional<CamExtreme>& radius) {
    if (!(std::abs(regularity.value) <= cusp_rounding)) return;
    regularity.value = 0.0;
    if (radius) radius->value = 0.0;
}

CamSummary summary_of(const DrivenMechanism& cam, const CamTurn& turn) {
    CamSummary summary;
    summary.pressure_angle =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.pressure_angle); });
    summary.regularity = turn.least([](const CamPlace& place) { return place.point.regularity; });
    if (cam.formulas->planar()) {
        if (cam.formulas->has_pitch_curve())
            add_radii_of_pitch(summary, cam, turn);
        else
            add_radii_of_face(summary, turn);
        const std::optional<double> base = cam.formulas->base_radius(cam.dimensions);
        summary.base_radius =
            base ? *base : turn.least([](const CamPlace& place) { return place.point.contact.norm(); }).value;
    }
    round_cusp(summary.regularity, summary.convex_radius);
    for (SideSummary& side : summary.sides) round_cusp(side.regularity, side.convex_radius);
    return summary;
}

}  // namespace

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale) {
    return summary_of(cam, CamTurn(cam, motion, scale));
}

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const Scene& scene) {
    const CamTurn turn(cam, motion, {scene.motion.lift, scene.motion.unit_angle()});
    CamSummary summary = summary_of(cam, turn);
    add_follower_figures(summary, cam, turn, scene);
    return summary;
}

}  // namespace camopt

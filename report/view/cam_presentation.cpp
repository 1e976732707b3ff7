// SPDX-License-Identifier: MIT
#include "report/view/cam_presentation.hpp"

#include "scene/cam_flanks.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string undercut_of_direct_cam(const CamMechanism& cam) {
    return fmt::format(
        "the cam intersects itself there; the remaining part does not guide the follower as designed. A "
        "larger base radius{} {}",
        cam.contact() == ContactKind::roller ? " or a smaller roller" : "",
        cam.swings() ? "may help" : "helps");
}

std::string run_of_direct_cam(const DrivenMechanism& cam, int points) {
    const DirectCamDrawing drawing = cam.formulas->direct()->drawing(cam.dimensions);
    if (drawing.groove_wall)
        return fmt::format("a roller run along both flanks over {} points of each", points);
    if (!drawing.pieces.empty()) return fmt::format("each roller run over {} points of its disk", points);
    return fmt::format("a follower run over {} points of the cam", points);
}

std::string check_of_direct_cam(const DrivenMechanism& cam, const CheckWords& words) {
    return fmt::format("{} {} ({} of the prime radius, at {} deg)", run_of_direct_cam(cam, words.points),
                       words.found, words.relative, words.where);
}

std::string output_words(const std::string& run, const CheckWords& words) {
    return fmt::format("{}: the output {} (at {} deg)", run, words.found, words.where);
}

bool is_plate(const DrivenMechanism& cam) {
    const PlaneMechanism* const plane = cam.formulas->plane();
    return plane != nullptr && plane->is_plate();
}

std::string undercut_of_plate(const CamMechanism& /*cam*/) {
    return "the plate's surface intersects itself there; the remaining part does not guide the roller as "
           "designed. A smaller roller or a longer travel helps";
}

std::string check_of_plate(const DrivenMechanism& /*cam*/, const CheckWords& words) {
    return output_words(fmt::format("a follower run over {} points of the plate", words.points), words);
}

std::string undercut_of_linkage(const CamMechanism& /*cam*/) {
    return "the cam intersects itself there; the remaining part does not guide the roller as designed. A "
           "smaller roller or a larger distance of the cam's centre helps";
}

std::string check_of_linkage(const DrivenMechanism& /*cam*/, const CheckWords& words) {
    return output_words(fmt::format("lever and linkage run over {} points of the cam", words.points), words);
}

/// The first that fits.
const std::array<CamPresentation, 6>& rows() {
    using enum CamView;
    static const std::array<CamPresentation, 6> all = {{
        {.fits = is_plate,
         .touching = "follower",
         .undercut = undercut_of_plate,
         .check = check_of_plate,
         .picture = {"Plate", "frame of the plate", "follower", "roller", "guide of the follower",
                     "follower every 60°", CamOutline::plate},
         .files = {{table, "profile.csv"},
                   {picture, "profile.svg", "The plate to scale"},
                   {diagram, "profile_diagrams.svg", "Pressure angle and curvature"}}},
        {.fits = [](const DrivenMechanism& cam) { return cam.formulas->direct() != nullptr; },
         .touching = "follower",
         .undercut = undercut_of_direct_cam,
         .check = check_of_direct_cam,
         .picture = {"Cam", "cam frame", "follower", "roller", "guide of the follower", "follower every 60°"},
         .files = {{table, "profile.csv"},
                   {picture, "profile.svg", "The cam to scale"},
                   {diagram, "profile_diagrams.svg", "Pressure angle and curvature"},
                   {.view = table, .name = "second_profile.csv", .station = 1}}},
        {.fits = [](const DrivenMechanism& cam) { return cam.formulas->guide(cam.dimensions).has_value(); },
         .undercut =
             [](const CamMechanism&) {
                 return std::string(
                     "a wall of the guide intersects itself there and does not guide the "
                     "roller as designed. A smaller roller or a longer stroke helps");
             },
         .check =
             [](const DrivenMechanism&, const CheckWords& words) {
                 return output_words(
                     fmt::format("the roller pushes the body along {} points of the guide's walls",
                                 words.points),
                     words);
             },
         .picture = {"Guide", "frame of the body", "", "roller at both ends", "", "", CamOutline::slot},
         .files = {{.view = table, .name = "guide.csv", .both_walls = true},
                   {picture, "guide.svg", "The guide to scale"},
                   {diagram, "pressure_angle.svg", "Pressure angle", "pressure_angle"}}},
        {.fits = [](const DrivenMechanism& cam) { return cam.formulas->flanks(cam.dimensions).has_value(); },
         .undercut =
             [](const CamMechanism&) {
                 return std::string(
                     "a flank folds there and is cut away by the roller's own sweep. A "
                     "smaller or shorter roller or a larger cam helps");
             },
         .check =
             [](const DrivenMechanism&, const CheckWords& words) {
                 return output_words(fmt::format("the follower is driven by {} points of each flank at "
                                                 "either end of its roller",
                                                 words.points),
                                     words);
             }},
        {.fits = [](const DrivenMechanism& cam) { return cam.formulas->plane() != nullptr; },
         .undercut = undercut_of_linkage,
         .check = check_of_linkage,
         .picture = {"Cam and linkage", "fixed frame", "links", "roller", "path of the slider",
                     "at both ends of the motion"},
         .files = {{table, "profile.csv"},
                   {picture, "mechanism.svg", "Cam and linkage to scale"},
                   {diagram, "pressure_angle.svg", "Pressure angle", "pressure_angle"},
                   {diagram, "curvature.svg", "Curvature", "curvature"}}},
        {.fits = [](const DrivenMechanism&) { return true; },
         .undercut = undercut_of_linkage,
         .check = check_of_linkage},
    }};
    return all;
}

}  // namespace

const CamPresentation& presentation_of(const DrivenMechanism& cam) {
    return *std::ranges::find_if(rows(), [&](const CamPresentation& row) { return row.fits(cam); });
}

std::span<const CamPresentation> cam_presentations() {
    return rows();
}

std::string form_words(const DirectCamDrawing& drawing) {
    if (drawing.groove_wall) return "in a groove";
    return drawing.pieces.empty() ? "" : "on conjugate disks";
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The files of a delivered cam, of any kind, as texts: its points and its pictures. Their names are in
// the rows of view/cam_presentation.cpp.
//
//   disk     profile.csv, profile.svg, profile_diagrams.svg
//   remote   profile.csv, mechanism.svg, pressure_angle.svg, curvature.svg
//   inverse  guide.csv, guide.svg, pressure_angle.svg
//   any      with forces forces.svg
// The columns of profile.csv and guide.csv stand in csv/motion_csv.hpp.
#pragma once

#include "report/view/cam_presentation.hpp"
#include "report/view/view.hpp"

namespace camopt {

struct CamFile {
    CamView view = CamView::table;
    std::string name;   ///< "profile.svg"
    std::string title;  ///< as the report names a picture: "The cam to scale"
    std::string text;
};

struct CamFileOptions {
    /// Of the table, evenly by cam angle; none: a disk cam by the chord tolerance, others one a tenth of a
    /// degree.
    std::optional<int> points = {};
    double chord_tolerance = 1e-6;  ///< m: a polyline through the table's points stays this close to the cam
};

/// The whole cam: an RR motion is followed by its dwell, a DRD motion stays a sector. None of a cam that is
/// no plane curve, and of a solution without a cam.
[[nodiscard]] std::vector<CamFile> cam_files(const View& view, const CamFileOptions& options = {});

/// The text of the one that shows this. Throws InputError where the solution has no plane cam.
[[nodiscard]] std::string cam_view(const View& view, CamView shown, const CamFileOptions& options = {});

/// There is a table of the points of its outline.
[[nodiscard]] bool has_cam_table(const Solution& solution);

/// The same without their texts.
[[nodiscard]] std::vector<CamFile> cam_file_list(const Solution& solution);

/// What a folder has of a cam that was drawn for CAD too (shop/dxf).
inline constexpr const char* drawn_profile = "profile.dxf";
inline constexpr const char* drawn_profile_check = "profile.check.json";

/// The names of all kinds, those of the drawing with them.
[[nodiscard]] std::vector<std::string> cam_file_names();

}  // namespace camopt

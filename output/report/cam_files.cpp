// SPDX-License-Identifier: MIT
#include "output/report/cam_files.hpp"

#include "core/errors.hpp"
#include "output/chart/force_diagrams_svg.hpp"
#include "output/drawing/dxf/cam_dxf.hpp"
#include "output/report/cam_texts.hpp"
#include "studies/check/check_cam.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace camopt {

namespace {

using enum CamView;

constexpr const char* drawing_name = "profile.dxf";
const CamFile force_file = {diagram, "forces.svg", "Force, torque and pressure", ""};

/// The files of a kind and what makes them.
struct KindFiles {
    bool (*is_it)(const CamMechanism&);
    std::vector<CamFile> files;
    std::vector<std::string> (*texts)(const Solution&, const CamFileOptions&);
};

/// The first that fits.
const std::array<KindFiles, 4>& kinds() {
    static const std::array<KindFiles, 4> all = {{
        {[](const CamMechanism& cam) { return cam.is_direct() && cam.stations() > 1; },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""},
          {table, "second_profile.csv", "", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.is_direct(); },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.has_guide(); },
         {{table, "guide.csv", "", ""},
          {picture, "guide.svg", "The guide to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""}},
         guide_texts},
        {[](const CamMechanism& cam) { return cam.planar(); },
         {{table, "profile.csv", "", ""},
          {picture, "mechanism.svg", "Cam and linkage to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""},
          {diagram, "curvature.svg", "Curvature", ""}},
         linkage_texts},
    }};
    return all;
}

/// Null where there are none.
const KindFiles* kind_of(const Solution& solution) {
    if (!solution.cam) return nullptr;
    const auto found = std::ranges::find_if(
        kinds(), [&](const KindFiles& kind) { return kind.is_it(*solution.cam->cam.formulas); });
    return found == kinds().end() ? nullptr : &*found;
}

}  // namespace

std::vector<CamFile> cam_file_list(const Solution& solution) {
    const KindFiles* const kind = kind_of(solution);
    if (kind == nullptr) return {};
    std::vector<CamFile> files = kind->files;
    if (solution.cam->summary.forces) files.push_back(force_file);
    return files;
}

std::vector<CamFile> cam_files(const Solution& solution, const CamFileOptions& options) {
    std::vector<CamFile> files = cam_file_list(solution);
    if (files.empty()) return files;
    std::vector<std::string> texts = kind_of(solution)->texts(solution, options);
    if (solution.cam->summary.forces) texts.push_back(force_diagrams_svg(solution, cam_motion(solution)));
    for (std::size_t i = 0; i < files.size(); ++i) files[i].text = std::move(texts[i]);
    if (options.drawing)
        files.push_back({drawing, drawing_name, "", cam_dxf(solution, options.dxf_tolerance).text});
    return files;
}

std::string cam_view(const Solution& solution, CamView view, CamFileOptions options) {
    options.drawing = view == drawing;
    const std::vector<CamFile> files = cam_files(solution, options);
    const auto found = std::ranges::find(files, view, &CamFile::view);
    if (found == files.end())
        throw InputError("a plane profile needs a plane mechanism, and this solution has none");
    return found->text;
}

std::vector<std::string> cam_file_names() {
    std::vector<std::string> names = {drawing_name, force_file.name};
    for (const KindFiles& kind : kinds())
        for (const CamFile& file : kind.files) names.push_back(file.name);
    return names;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/report/result_folder.hpp"

#include "core/errors.hpp"
#include "output/chart/motion_svg.hpp"
#include "output/csv/guide_files.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/drawing/cam_profile.hpp"
#include "output/drawing/mechanism_dxf.hpp"
#include "output/json/certificate_json.hpp"
#include "output/json/result_json.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/mechanism_files.hpp"
#include "output/report/report.hpp"
#include "studies/delivered/mechanism_report.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <system_error>

namespace camopt {

namespace {

/// The files that not every result has.
constexpr std::array optional_files = {
    "motion.csv",           "motion.svg",  "profile.csv",   "profile.svg",
    "profile_diagrams.svg", "profile.dxf", "mechanism.svg", "pressure_angle.svg",
    "curvature.svg",        "guide.csv",   "guide.svg",     "scene.toml"};

}  // namespace

void prepare_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error))
        throw InputError(
            fmt::format("cannot write results into {}: it is a file, not a folder", folder.string()));
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError(fmt::format("cannot create the folder {}: {}", folder.string(), error.message()));
}

std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder,
                                                       const Solution& solution, const RunOrigin& origin,
                                                       const WriteOptions& options) {
    FolderUpdate writer(folder);
    for (const char* const name : optional_files) writer.remove_earlier(name);
    if (solution.motion) {
        writer.write("motion.csv",
                     motion_csv(*solution.motion, solution.motion_peaks, solution.scene.motion));
        writer.write("motion.svg", motion_svg(solution));
    }
    if (solution.cam) {
        const CamProfileTexts profile = cam_profile(solution, {.points = options.points, .dxf = options.dxf});
        writer.write("profile.csv", profile.csv);
        writer.write("profile.svg", profile.svg);
        writer.write("profile_diagrams.svg", profile.diagrams_svg);
        if (profile.dxf) writer.write("profile.dxf", *profile.dxf);
    }
    if (solution.mechanism && solution.mechanism->mechanism.formulas->planar()) {
        const MechanismTexts texts = mechanism_texts(solution, options.points);
        writer.write("profile.csv", texts.csv);
        writer.write("mechanism.svg", texts.svg);
        writer.write("pressure_angle.svg", texts.pressure_angle_svg);
        writer.write("curvature.svg", texts.curvature_svg);
    }
    if (has_inverse_cam(solution)) {
        const GuideTexts texts = guide_texts(solution, options.points);
        writer.write("guide.csv", texts.csv);
        writer.write("guide.svg", texts.svg);
        writer.write("pressure_angle.svg", texts.pressure_angle_svg);
    }
    if (options.dxf && has_plane_mechanism(solution))
        writer.write("profile.dxf", mechanism_dxf(solution).text);
    if (!origin.scene_text.empty()) writer.write("scene.toml", origin.scene_text);
    writer.write("report.md", report_markdown(solution, origin));
    writer.write("certificate.json", certificate_json(solution.certificate));
    writer.write("result.json", result_json(solution, origin));  // last: who sees it finds the rest complete
    return writer.finish();
}

}  // namespace camopt

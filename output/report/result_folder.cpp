// SPDX-License-Identifier: MIT
#include "output/report/result_folder.hpp"

#include "core/errors.hpp"
#include "output/chart/motion_svg.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/json/certificate/certificate_json.hpp"
#include "output/json/result_json.hpp"
#include "output/report/cam_files.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/report.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <system_error>

namespace camopt {

namespace {

/// The files that not every result has, beside those of its cam.
constexpr std::array optional_files = {"motion.csv",  "motion.svg", "scene.toml",
                                       "report.html", "drum.svg",   "developed.svg"};

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
    for (const std::string& name : cam_file_names()) writer.remove_earlier(name);
    if (solution.motion) {
        writer.write("motion.csv",
                     motion_csv(*solution.motion, solution.motion_peaks, solution.scene.motion));
        writer.write("motion.svg", motion_svg(solution));
    }
    for (const CamFile& file : cam_files(solution, {.points = options.points, .drawing = options.dxf}))
        writer.write(file.name, file.text);
    if (!origin.scene_text.empty()) writer.write("scene.toml", origin.scene_text);
    for (const FolderFile& file : options.also) writer.write(file.name, file.text);
    writer.write("report.md", report_markdown(solution, origin));
    writer.write("certificate.json", certificate_json(solution.certificate));
    writer.write("result.json", result_json(solution, origin));  // last: who sees it finds the rest complete
    return writer.finish();
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/result_folder.hpp"

#include "core/errors.hpp"
#include "output/certificate_json.hpp"
#include "output/motion_csv.hpp"
#include "output/motion_svg.hpp"
#include "output/report.hpp"
#include "output/result_json.hpp"
#include "output/text_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt {

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
                                                       const Solution& solution, const RunOrigin& origin) {
    prepare_folder(folder);
    std::vector<std::filesystem::path> written;
    const auto write = [&](const char* name, const std::string& text) {
        write_text_file(folder / name, text);
        written.push_back(folder / name);
    };
    if (solution.motion) {
        write("motion.csv", motion_csv(*solution.motion, solution.peaks, solution.scene.motion));
        write("motion.svg", motion_svg(solution));
    } else {
        std::error_code absent;
        std::filesystem::remove(folder / "motion.csv", absent);
        std::filesystem::remove(folder / "motion.svg", absent);
    }
    write("report.md", report_markdown(solution, origin));
    write("certificate.json", certificate_json(solution.certificate));
    write("result.json", result_json(solution, origin));  // last: who sees it finds the others complete
    return written;
}

}  // namespace camopt

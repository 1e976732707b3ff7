// SPDX-License-Identifier: MIT
// The program that scripts/demo builds: one solve, the reference table, plane cams that touch their follower.
#include "apps/program_parts.hpp"
#include "apps/run_program.hpp"
#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "report/page/page_html.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "studies/check/check_cam.hpp"

#include <fmt/format.h>

namespace {

using namespace camopt;

std::shared_ptr<const CamMechanism> formulas(const CamSpec& spec) {
    if (spec.type == disk_type) return disk_formulas(spec);
    throw SceneError(
        {"cam.type", fmt::format("\"{}\"", spec.type),
         fmt::format("\"{}\" in this program; `scripts/build release` builds one with all", disk_type)});
}

void check_forward(Solution& solution) {
    add_forward_check(solution, check_cam);
}

std::vector<FolderFile> extras(const View& view, const RunOrigin& origin) {
    return {{"report.html", report_html_with(nullptr, view, origin)}};
}

}  // namespace

const camopt::apps::ProgramParts& camopt::apps::program_parts() {
    static const ProgramParts parts = {{add_first_commands},
                                       formulas,
                                       check_forward,
                                       extras,
                                       [](const View& view) { return dxf_files(view); },
                                       "this program is a part of camopt, `scripts/build release` builds all "
                                       "commands and kinds of cams"};
    return parts;
}

int main(int count, char** words) {
    return camopt::apps::run_program(count, words);
}

// SPDX-License-Identifier: MIT
// The program with all of camopt.
#include "apps/program_parts.hpp"
#include "apps/run_program.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "report/exports/workshop.hpp"
#include "report/page/result_page.hpp"
#include "studies/checked/checked_cam.hpp"

const camopt::apps::ProgramParts& camopt::apps::program_parts() {
    static const ProgramParts parts = {{add_first_commands, add_more_commands},
                                       cam_formulas,
                                       add_forward_check,
                                       result_extras,
                                       workshop() != nullptr ? workshop()->dxf_files : nullptr,
                                       workshop() != nullptr ? ""
                                                             : "this camopt was built without the shop "
                                                               "(CAMOPT_SHOP): workshop drawings, solids, NC "
                                                               "programs, electronic cams"};
    return parts;
}

int main(int count, char** words) {
    return camopt::apps::run_program(count, words);
}

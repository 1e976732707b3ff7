// SPDX-License-Identifier: MIT
#include "studies/checked/checked_cam.hpp"

#include "scene/cam_flanks.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/inverse/inverse_forward.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

namespace camopt {

ForwardCheckReport checked_cam(const Solution& solution, std::optional<int> points) {
    if (solution.cam) {
        const DrivenMechanism& cam = solution.cam->cam;
        if (cam.formulas->flanks(cam.dimensions)) return check_flanks(solution, points);
        if (cam.formulas->guide(cam.dimensions)) return check_guide(solution, points);
    }
    return check_cam(solution, points);
}

void add_forward_check(Solution& solution) {
    add_forward_check(solution, checked_cam);
}

}  // namespace camopt

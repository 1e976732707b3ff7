// SPDX-License-Identifier: MIT
#include "studies/checked/checked_cam.hpp"

#include "studies/check/check_cam.hpp"
#include "studies/inverse/inverse_forward.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

namespace camopt {

ForwardCheckReport checked_cam(const Solution& solution, std::optional<int> points) {
    if (!solution.cam) return check_cam(solution, points);
    if (has_flanks(solution)) return check_flanks(solution, points);
    if (solution.cam->cam.formulas->has_guide()) return check_guide(solution, points);
    return check_cam(solution, points);
}

void add_forward_check(Solution& solution) {
    add_forward_check(solution, checked_cam);
}

}  // namespace camopt

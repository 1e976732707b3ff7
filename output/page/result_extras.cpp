// SPDX-License-Identifier: MIT
#include "output/page/result_extras.hpp"

#include "output/page/page_html.hpp"
#include "output/spatial/drum_pictures.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/spatial/solved_cam.hpp"

namespace camopt {

std::vector<FolderFile> result_extras(const Solution& solution, const RunOrigin& origin) {
    std::vector<FolderFile> files = {{"report.html", report_html(solution, origin)}};
    if (!solution.cam || !has_spatial_cam(solution)) return files;
    const SpatialCam cam = solved_spatial_cam(solution);
    const MotionChain turn = whole_turn(solution);
    const FollowerMotion motion = follower_motion(turn, motion_scale(solution.scene));
    const Drum drum{solution, cam, motion};
    files.push_back({drum_picture, drum_svg(drum)});
    files.push_back({developed_picture, developed_svg(drum)});
    return files;
}

}  // namespace camopt

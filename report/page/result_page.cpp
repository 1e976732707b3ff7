// SPDX-License-Identifier: MIT
#include "report/page/result_page.hpp"

#include "report/page/page_parts.hpp"
#include "report/spatial/drum_svg.hpp"
#include "report/spatial/flank_surfaces.hpp"
#include "report/view/cam_words.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

namespace camopt {

namespace {

using Eigen::Vector3d;

Json mesh_json(const CamScene::Part& part, const ShownUnit& length) {
    Json vertices = Json::array(), triangles = Json::array();
    for (const Vector3d& vertex : part.mesh.vertices) append(vertices, length, vertex);
    for (const std::array<int, 3>& triangle : part.mesh.triangles)
        for (const int corner : triangle) triangles.push_back(corner);
    return {{"name", part.name},
            {"closed", part.closed},
            {"vertices", std::move(vertices)},
            {"triangles", std::move(triangles)}};
}

std::string solid_drawing(const View& view) {
    const Solution& solution = view.solution;
    if (!page_needs_solids(solution)) return "null";
    const MotionScale& scale = view.delivered.scale;
    std::vector<double> angles;
    for (const DeliveredRow& row : view.delivered.rows) angles.push_back(scale.unit_angle * row.x);
    const CamScene scene =
        cam_scene(solved_flanks(solution), follower_motion(*view.delivered.whole, scale), angles);
    const ShownUnit& length = view.units.length;
    Json parts = Json::array(), rollers = Json::array();
    for (const CamScene::Part& part : scene.parts) parts.push_back(mesh_json(part, length));
    for (const std::vector<RollerPlace>& roller : scene.rollers) {
        Json poses = Json::array();
        for (const RollerPlace& pose : roller) {
            append(poses, length, pose.foot);
            for (const double part : pose.direction) poses.push_back(rounded_json(part));
        }
        rollers.push_back(std::move(poses));
    }
    Json pivot = nullptr;
    if (scene.pivot) {
        pivot = Json::array();
        append(pivot, length, *scene.pivot);
    }
    const Json drawing = {{"unit", length.name},
                          {"rotation", sense_of(solution.cam->cam.formulas->rotation())},
                          {"parts", std::move(parts)},
                          {"roller",
                           {{"radius", rounded_json(length.of(scene.roller_radius))},
                            {"length", rounded_json(length.of(scene.roller_length))}}},
                          {"rollers", std::move(rollers)},
                          {"pivot", std::move(pivot)}};
    return drawing.dump();
}

constexpr SolidParts solid_parts = {page_needs_solids, solid_drawing};

}  // namespace

bool page_needs_solids(const Solution& solution) {
    return solution.motion && solution.cam && has_flanks(solution);
}

std::string page_data(const View& view, const RunOrigin& origin, const SolutionWishes& wishes) {
    return page_data_with(&solid_parts, view, origin, wishes);
}

std::string report_html(const View& view, const RunOrigin& origin) {
    return report_html_with(&solid_parts, view, origin);
}

std::vector<FolderFile> result_extras(const View& view, const RunOrigin& origin) {
    const Solution& solution = view.solution;
    std::vector<FolderFile> files = {{"report.html", report_html(view, origin)}};
    if (!page_needs_solids(solution)) return files;
    const CamFlanks cam = solved_flanks(solution);
    const MotionChain turn = whole_turn(solution);
    const FollowerMotion motion = follower_motion(turn, motion_scale(solution.scene));
    const Drum drum{solution, cam, motion};
    files.push_back({drum_picture, drum_svg(drum)});
    files.push_back({developed_picture, developed_svg(drum)});
    return files;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// camopt solve: optimise a scene, print the result, write its folder.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "output/json/result_json.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/solution_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/mechanism_report.hpp"
#include "studies/inverse/solved_guide.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/solved_cam.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace camopt::apps {

namespace {

/// The types of cams that are plane curves: "disk", "remote" and "inverse".
std::string plane_types() {
    std::vector<std::string> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.is_plane_curve) types.push_back(fmt::format("\"{}\"", kind.type));
    const std::string last = types.back();
    types.pop_back();
    return fmt::format("{} and {}", fmt::join(types, ", "), last);
}

LoadedScene requested_scene(const SolveRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    const Scene& scene = loaded.scene;
    if (request.dxf && scene.mechanism && !cam_kind(scene.mechanism->type)->is_plane_curve)
        throw InputError(
            fmt::format("--dxf: found with a cam of type \"{}\", which is no plane curve; allowed: with "
                        "types {}; `camopt "
                        "export` writes its flanks and solid",
                        scene.mechanism->type, plane_types()));
    const bool has_cam = scene.cam || scene.mechanism;
    for (const auto& [given, option] :
         {std::pair(request.dxf, "--dxf"), std::pair(request.points.has_value(), "--points")})
        if (given && !has_cam)
            throw InputError(fmt::format(
                "{}: found in a scene without a cam; allowed: where the scene has a [cam], whose profile it "
                "is about",
                option));
    return loaded;
}

Solution solve_with_progress(const Scene& scene) {
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    Solution solution = solve(scene, control);
    end_progress();
    return solution;
}

ForwardCheckReport checked_mechanism(const Solution& solution) {
    if (has_spatial_cam(solution)) return check_spatial_cam(solution);
    if (has_inverse_cam(solution)) return check_inverse_cam(solution);
    return check_mechanism(solution);
}

/// Runs a follower over the finished cam. Who pressed Ctrl-C waits for the files, not for this.
void add_forward_check(Solution& solution) {
    if (InterruptWatch::interrupted()) return;
    try {
        if (solution.cam) solution.cam->forward_check = check_cam(solution);
        if (solution.mechanism) solution.mechanism->forward_check = checked_mechanism(solution);
    } catch (const InputError& error) {
        solution.notes.push_back(fmt::format("the forward check could not run: {}", error.what()));
    }
}

std::vector<std::filesystem::path> write_results(const SolveRequest& request, const RunOrigin& origin,
                                                 Solution& solution) {
    if (request.out.empty()) return {};
    add_forward_check(solution);
    return write_result_folder(request.out, solution, origin, {request.points, request.dxf});
}

}  // namespace

ExitCode solve_command(const SolveRequest& request) {
    LoadedScene loaded = requested_scene(request);
    if (!request.out.empty())
        prepare_folder(request.out);  // a wrong folder is told before the work, not after
    const InterruptWatch watch;       // until the files are written: Ctrl-C must not lose them
    Solution solution = solve_with_progress(loaded.scene);
    const RunOrigin origin{request.scene, request.command, std::move(loaded.text)};
    const std::vector<std::filesystem::path> written = write_results(request, origin, solution);
    const std::string text = request.json ? result_json(solution, origin) : summary_text(solution, written);
    print(text);
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps

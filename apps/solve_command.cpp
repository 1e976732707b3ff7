// SPDX-License-Identifier: MIT
// camopt solve: optimise a scene, print the result, write its folder.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "output/json/result_json.hpp"
#include "output/page/result_extras.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/solution_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "profiles/scene_cam.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
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
    const std::optional<MechanismSpec> cam = cam_of(loaded.scene);
    if (request.dxf && cam && !cam_kind(cam->type)->is_plane_curve)
        throw InputError(
            fmt::format("--dxf: found with a cam of type \"{}\", which is no plane curve; allowed: with "
                        "types {}; `camopt "
                        "export` writes its flanks and solid",
                        cam->type, plane_types()));
    for (const auto& [given, option] :
         {std::pair(request.dxf, "--dxf"), std::pair(request.points.has_value(), "--points")})
        if (given && !cam)
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

std::vector<std::filesystem::path> write_results(const SolveRequest& request, const RunOrigin& origin,
                                                 Solution& solution) {
    if (request.out.empty()) return {};
    // Who pressed Ctrl-C waits for the files, not for a follower that runs over the finished cam.
    if (!InterruptWatch::interrupted()) add_forward_check(solution);
    return write_result_folder(request.out, solution, origin,
                               {request.points, request.dxf, result_extras(solution, origin)});
}

}  // namespace

ExitCode solve_command(const SolveRequest& request) {
    LoadedScene loaded = requested_scene(request);
    if (!request.out.empty())
        prepare_folder(request.out);  // a wrong folder is told before the work, not after
    const InterruptWatch watch;       // until the files are written: Ctrl-C must not lose them
    Solution solution = solve_with_progress(loaded.scene);
    show_in(solution.scene, request.units);
    const RunOrigin origin{request.scene, request.command, std::move(loaded.text)};
    const std::vector<std::filesystem::path> written = write_results(request, origin, solution);
    const std::string text = request.json ? result_json(solution, origin) : summary_text(solution, written);
    print(text);
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps

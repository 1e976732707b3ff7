// SPDX-License-Identifier: MIT
// camopt solve: optimise a scene, print the result, write its folder.
#include "apps/commands.hpp"
#include "apps/program_parts.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/text/text_file.hpp"
#include "input/scene_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "report/check/check_document.hpp"
#include "report/folders/result_folder.hpp"
#include "report/solve/solution_document.hpp"
#include "studies/check/scene_check.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

/// The types of cams that are plane curves.
std::string plane_types() {
    std::vector<std::string> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.gives(CamOutput::outline)) types.push_back(fmt::format("\"{}\"", kind.type));
    const std::string last = types.back();
    types.pop_back();
    return fmt::format("{} and {}", fmt::join(types, ", "), last);
}

LoadedScene requested_scene(const SolveRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    const std::optional<CamSpec>& cam = loaded.scene.cam;
    if (request.dxf && cam && !cam_kind(cam->type)->gives(CamOutput::outline))
        throw InputError(
            fmt::format("--dxf: found with a cam of type \"{}\", which is not a plane curve; allowed: with "
                        "types {}; `camopt export` writes its flanks and solid",
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
    if (!InterruptWatch::interrupted()) program_parts().add_forward_check(solution);
    const View view(solution);
    WriteOptions options{.points = request.points};
    if (request.dxf) options.also = program_parts().dxf_files(view);
    std::ranges::move(program_parts().result_extras(view, origin), std::back_inserter(options.also));
    return write_result_folder(request.out, view, origin, options);
}

// camopt check: is the scene right, can its problem be built, are its derivatives right? No solve.
/// A file that is there stays.
void write_scene(const Scene& scene, const std::string& file) {
    std::error_code error;
    if (std::filesystem::exists(file, error))
        throw InputError(fmt::format("--write {}: found a file of this name; allowed: a new one", file));
    const std::string text = input::scene_text(scene);
    (void)load_scene(SceneText{file, text}, {});  // what cannot be read is not written
    write_text_file(file, text);
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
    print(request.json ? result_json(solution, origin) : summary_text(solution) + written_lines(written));
    return exit_code_of(solution.certificate.verdict);
}

ExitCode check_command(const CheckRequest& request) {
    Scene scene = load_scene(request.scene, request.settings);
    if (!request.write.empty()) write_scene(scene, request.write);
    show_in(scene, request.units);
    const SceneCheck check = check_scene(scene);
    const Document document = check_document(scene, check, request.scene);
    print(request.json ? document_json(document)
                       : console_text(document) +
                             (request.write.empty() ? "" : fmt::format("written: {}\n", request.write)));
    if (!check.derivatives_agree) return failure;
    return check.contradictions.empty() ? success : proved_infeasible;
}

}  // namespace camopt::apps

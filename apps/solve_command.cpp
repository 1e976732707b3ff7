// SPDX-License-Identifier: MIT
// camopt solve: optimise a scene, print the result, write its folder.
#include "apps/commands.hpp"
#include "apps/program_parts.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/text/text_file.hpp"
#include "core/word_of.hpp"
#include "input/scene_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "report/folders/result_folder.hpp"
#include "report/solve/solution_document.hpp"
#include "report/words/plan_text.hpp"
#include "report/words/solution_text.hpp"
#include "studies/check/scene_check.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

/// The types of cams that are plane curves.
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
    const std::optional<CamSpec>& cam = loaded.scene.cam;
    if (request.dxf && cam && !cam_kind(cam->type)->is_plane_curve)
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
constexpr int line_width = 110;

const char* meaning_of(Curvature curvature) {
    return word_of<Curvature::general>(curvature,
                                       {"linear", "convex", "general: an optimum may be a local one"});
}

std::string limits_text(const std::vector<LimitShape>& limits) {
    std::string text;
    for (const LimitShape& limit : limits)
        text += fmt::format("  limit: {} is {}\n", limit.key, meaning_of(limit.curvature));
    return text;
}

std::string derivative_line(const DerivativeError& error) {
    const std::string where = error.where.empty() ? "" : " (worst at " + error.where + ")";
    if (error.wrong == 0)
        return fmt::format("  {:<9} agrees with differences to {}{}\n", error.kind,
                           short_text(error.error, 2), where);
    return fmt::format(
        "  {:<9} is wrong in {} of {} entries: off by {}, {} times what differences may err{}\n", error.kind,
        error.wrong, error.entries, short_text(error.error, 2), short_text(error.beyond, 2), where);
}

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
    std::string text = fmt::format("{}: the scene is valid\n", request.scene);
    for (const std::string& line : scene_lines(scene)) text += wrapped_text(line, "  ", line_width);
    text += fmt::format("  problem: {} variables, {} rows on the first grid, {}\n", check.variables,
                        check.rows, check.plan.convex ? "convex: an optimum is global" : "not convex");
    for (const std::string& line : plan_lines(check.plan)) text += wrapped_text(line, "  ", line_width);
    if (scene.cam) text += limits_text(check.limits);
    for (const DerivativeError& error : check.derivatives) text += derivative_line(error);
    for (const std::string& condition : check.redundant)
        text += fmt::format("  note: {} follows from others\n", condition);
    for (const std::string& condition : check.contradictions)
        text += fmt::format("  infeasible: {} contradicts other conditions\n", condition);
    if (!check.derivatives_agree) text += "  the derivatives are wrong\n";
    if (!request.write.empty()) text += fmt::format("  written: {}\n", request.write);
    print(text);
    if (!check.derivatives_agree) return failure;
    return check.contradictions.empty() ? success : proved_infeasible;
}

}  // namespace camopt::apps

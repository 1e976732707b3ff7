// SPDX-License-Identifier: MIT
// camopt solve: optimise a scene, print the result, write its folder.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "output/result_folder.hpp"
#include "output/result_json.hpp"
#include "output/solution_text.hpp"
#include "studies/solve.hpp"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace camopt::apps {

namespace {

Scene requested_scene(const SolveRequest& request) {
    std::vector<std::string> settings = request.settings;
    if (!request.solver.empty()) settings.push_back("solver.name=\"" + request.solver + "\"");
    return load_scene(request.scene, settings);
}

Solution solve_with_progress(const Scene& scene) {
    const InterruptWatch watch;
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    Solution solution = solve(scene, control);
    end_progress();
    return solution;
}

}  // namespace

ExitCode solve_command(const SolveRequest& request) {
    const Scene scene = requested_scene(request);
    if (!request.out.empty())
        prepare_folder(request.out);  // a wrong folder is told before the work, not after
    const Solution solution = solve_with_progress(scene);
    const RunOrigin origin{request.scene, request.command};
    std::vector<std::filesystem::path> written;
    if (!request.out.empty()) written = write_result_folder(request.out, solution, origin);
    const std::string text = request.json ? result_json(solution, origin) : summary_text(solution, written);
    std::fputs(text.c_str(), stdout);
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps

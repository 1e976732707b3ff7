// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "report/folders/result_folder_reader.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt::apps {

Solution solved_or_read(const std::string& what, const std::vector<std::string>& settings,
                        const std::function<void(const Scene&)>& check) {
    std::error_code ignored;
    const bool folder = std::filesystem::is_directory(what, ignored);
    if (folder && !settings.empty())
        throw InputError(
            fmt::format("{}: {}: found with a result folder, which is used unchanged; allowed: with a scene",
                        what, settings.front().starts_with("solver.name=\"") ? "--solver" : "--set"));
    if (folder) {
        Solution solution = read_result_folder(what, [](const std::string& text, const std::string& name) {
                                return load_scene(SceneText{name, text}, {});
                            }).solution;
        check(solution.scene);
        return solution;
    }
    const Scene scene = load_scene(what, settings);
    check(scene);
    Solution solution = solve(scene, {InterruptWatch::interrupted, terminal_progress()});
    end_progress();
    return solution;
}

}  // namespace camopt::apps

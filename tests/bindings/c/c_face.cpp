// SPDX-License-Identifier: MIT
#include "tests/bindings/c/c_face.hpp"

#include "input/loading/load_scene.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/source_folder.hpp"

namespace camopt::testing_support {

CScene c_scene(const std::string& toml) {
    camopt_scene* scene = nullptr;
    EXPECT_OK(camopt_scene_from_toml(toml.c_str(), "test", &scene));
    return CScene(scene);
}

std::string scene_path(const std::string& name) {
    return source_folder() + "/scenes/" + name + ".toml";
}

CScene c_scene_of_file(const std::string& name) {
    camopt_scene* scene = nullptr;
    EXPECT_OK(camopt_scene_from_file(scene_path(name).c_str(), &scene));
    return CScene(scene);
}

CSolution c_solved(const CScene& scene, const camopt_solve_options* options) {
    camopt_solution* solution = nullptr;
    EXPECT_OK(camopt_solve(scene.get(), options, &solution));
    return CSolution(solution);
}

CSolution c_solved_file(const std::string& name) {
    return c_solved(c_scene_of_file(name));
}

camopt_summary summary_of(const CSolution& solution) {
    camopt_summary summary{};
    summary.size = sizeof summary;
    EXPECT_OK(camopt_solution_summary(solution.get(), &summary));
    return summary;
}

std::string text_of(const CSolution& solution, camopt_document document) {
    camopt_text text{};
    EXPECT_OK(camopt_solution_text(solution.get(), document, &text));
    std::string copy = text.data == nullptr ? "" : std::string(text.data, text.length);
    camopt_text_free(&text);
    return copy;
}

std::string toml_of(const CScene& scene) {
    camopt_text text{};
    EXPECT_OK(camopt_scene_to_toml(scene.get(), &text));
    std::string copy = text.data == nullptr ? "" : std::string(text.data, text.length);
    camopt_text_free(&text);
    return copy;
}

Solution cpp_solved_file(const std::string& name) {
    return solve(load_scene(scene_path(name)));
}

Solution cpp_solved(const std::string& toml) {
    return solve(scene_of_toml(toml));
}

}  // namespace camopt::testing_support

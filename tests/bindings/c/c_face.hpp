// SPDX-License-Identifier: MIT
// Handles of the C face that free themselves, and the scenes of its tests.
#pragma once

#include "bindings/c/camopt.h"
#include "studies/delivered/solution.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace camopt::testing_support {

struct FreeScene {
    void operator()(camopt_scene* scene) const { camopt_scene_free(scene); }
};
struct FreeSolution {
    void operator()(camopt_solution* solution) const { camopt_solution_free(solution); }
};
using CScene = std::unique_ptr<camopt_scene, FreeScene>;
using CSolution = std::unique_ptr<camopt_solution, FreeSolution>;

/// A call that has to succeed.
#define EXPECT_OK(call) EXPECT_EQ(call, CAMOPT_OK) << camopt_error_text()

/// The scene that README.md begins with.
inline constexpr const char* paper_toml =
    "[motion]\ntype = \"DRD\"\nlift_mm = 10\nrise_deg = 120\n[spline]\nsegments = 12\n"
    "[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n";

[[nodiscard]] CScene c_scene(const std::string& toml);
/// scenes/NAME.toml
[[nodiscard]] std::string scene_path(const std::string& name);
[[nodiscard]] CScene c_scene_of_file(const std::string& name);
[[nodiscard]] CSolution c_solved(const CScene& scene, const camopt_solve_options* options = nullptr);
[[nodiscard]] CSolution c_solved_file(const std::string& name);
[[nodiscard]] camopt_summary summary_of(const CSolution& solution);
[[nodiscard]] std::string text_of(const CSolution& solution, camopt_document document);
[[nodiscard]] std::string toml_of(const CScene& scene);
/// The same scene, read and solved without the C face.
[[nodiscard]] Solution cpp_solved_file(const std::string& name);
[[nodiscard]] Solution cpp_solved(const std::string& toml);

}  // namespace camopt::testing_support

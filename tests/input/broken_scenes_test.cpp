// SPDX-License-Identifier: MIT
// Every wrong scene is refused with the words written down for it.
#include "tests/input/broken_scenes.hpp"

#include "core/errors.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace camopt::input {
namespace broken_scenes_test {

const KnownNames known = {.laws = {"cycloidal", "modified_sine"},
                          .solvers = {"ipopt", "nlopt.slsqp", "structured"},
                          .cam_formulas = cam_formulas};

class BrokenScenes : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenScenes, AreRefusedWithCompleteMessage) {
    const BrokenScene& broken = GetParam();
    try {
        (void)read_scene(broken.toml, "s.toml", known, broken.overrides);
        FAIL() << "no error for\n" << broken.toml;
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), broken.message);
    }
}

std::string name_of_case(const testing::TestParamInfo<BrokenScene>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenScenes, testing::ValuesIn(broken_files()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Values, BrokenScenes, testing::ValuesIn(broken_values()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Combinations, BrokenScenes, testing::ValuesIn(broken_combinations()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Programs, BrokenScenes, testing::ValuesIn(broken_programs()), name_of_case);
INSTANTIATE_TEST_SUITE_P(SetPoints, BrokenScenes, testing::ValuesIn(broken_set_points()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Mechanisms, BrokenScenes, testing::ValuesIn(broken_mechanisms()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Spatial, BrokenScenes, testing::ValuesIn(broken_spatial()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Inverse, BrokenScenes, testing::ValuesIn(broken_inverse()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Cams, BrokenScenes, testing::ValuesIn(broken_cams()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Drawings, BrokenScenes, testing::ValuesIn(broken_drawings()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Drives, BrokenScenes, testing::ValuesIn(broken_drives()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Valves, BrokenScenes, testing::ValuesIn(broken_valves()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Forces, BrokenScenes, testing::ValuesIn(broken_forces()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Overrides, BrokenScenes, testing::ValuesIn(broken_overrides()), name_of_case);

std::string message_of_file(const std::filesystem::path& path) {
    try {
        (void)read_scene_file(path, known);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SceneFile, MissingFilesAndDirectoriesAreReported) {
    EXPECT_EQ(message_of_file("no/such.toml"),
              "no/such.toml: cannot be read: No such file or directory; allowed: a scene file in TOML");
    EXPECT_EQ(message_of_file("."), ".: found a directory; allowed: a scene file in TOML");
}

}  // namespace broken_scenes_test
}  // namespace camopt::input

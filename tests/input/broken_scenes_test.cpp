// SPDX-License-Identifier: MIT
// Every wrong scene of tests/input/broken is refused with the whole message that is written there.
#include "core/errors.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "tests/input/scene_cases.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace camopt::input {
namespace broken_scenes_test {

using testing_support::refusal;

const KnownNames known = {.laws = {"cycloidal", "modified_sine"},
                          .solvers = {"ipopt", "nlopt.slsqp", "structured"},
                          .cam_formulas = cam_formulas};

class BrokenScenes : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(BrokenScenes, AreRefusedWithCompleteMessage) {
    const std::vector<BrokenScene> all = broken_scenes(GetParam());
    EXPECT_GT(all.size(), 5U);
    for (const BrokenScene& one : all)
        EXPECT_EQ(refusal([&] { (void)read_scene(one.toml, "s.toml", known, one.settings); }), one.message)
            << one.place << "\n"
            << one.toml;
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenScenes,
                         testing::ValuesIn(case_files(source_folder() + "/tests/input/broken")),
                         [](const auto& info) { return info.param.stem().string(); });

TEST(SceneFile, MissingFilesAndDirectoriesAreReported) {
    EXPECT_EQ(refusal([] { (void)read_scene_file("no/such.toml", known); }),
              "no/such.toml: cannot be read: No such file or directory; allowed: a scene file in TOML");
    EXPECT_EQ(refusal([] { (void)read_scene_file(".", known); }),
              ".: found a directory; allowed: a scene file in TOML");
}

}  // namespace broken_scenes_test
}  // namespace camopt::input

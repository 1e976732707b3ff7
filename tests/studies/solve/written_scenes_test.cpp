// SPDX-License-Identifier: MIT
// A scene that was written and read again is solved to the same digits.
#include "input/loading/load_scene.hpp"
#include "input/scene_text.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace written_scenes_test {

class WrittenScenes : public testing::TestWithParam<const char*> {};

TEST_P(WrittenScenes, HaveTheSameOptimum) {
    const Scene scene = load_scene(source_folder() + "/scenes/" + GetParam() + ".toml");
    const Solution one = solve(scene), other = solve(scene_of_toml(input::scene_text(scene)));
    EXPECT_EQ(one.certificate.verdict, other.certificate.verdict);
    EXPECT_EQ(one.certificate.objective, other.certificate.objective);
    EXPECT_EQ(one.certificate.lower_bound, other.certificate.lower_bound);
    EXPECT_EQ(one.certificate.worst_violation, other.certificate.worst_violation);
}

INSTANTIATE_TEST_SUITE_P(Scenes, WrittenScenes,
                         testing::Values("drd_cubic_12", "rr_cubic_24", "program_constant_velocity"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace written_scenes_test
}  // namespace camopt

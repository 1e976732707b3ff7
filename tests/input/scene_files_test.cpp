// SPDX-License-Identifier: MIT
// Every example scene reads, and docs/scene_file.md shows the key table of the code.
#include "core/errors.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/machine/machine_reader.hpp"
#include "input/scene_reader.hpp"
#include "input/scene_text.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "tests/support/same_scene.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

namespace camopt::input {
namespace scene_files_test {

const std::filesystem::path sources = source_folder();
const KnownNames known = {
    .laws = {"modified_sine", "polynomial_345", "cycloidal", "modified_trapezoid", "constant_velocity",
             "simple_harmonic", "parabolic", "polynomial", "double_harmonic"},
    .solvers = {},
    .cam_formulas = cam_formulas,
    .law_shape = [](const std::string&) -> std::function<std::array<double, 2>(double)> {
        return [](double t) {  // the cycloidal one in the place of all
            const double turn = 2.0 * std::numbers::pi;
            return std::array{t - std::sin(turn * t) / turn, 1.0 - std::cos(turn * t)};
        };
    }};

Scene known_scene(const std::filesystem::path& path, std::span<const std::string> settings) {
    return read_scene_file(path, known, settings);
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Scenes, EveryExampleReadsAndStatesItsPurpose) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(sources / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        SCOPED_TRACE(entry.path().string());
        const bool machine = text_of(entry.path()).find("\n[machine]") != std::string::npos;
        try {
            EXPECT_NE(machine ? read_machine(entry.path(), known_scene).title
                              : read_scene_file(entry.path(), known).title,
                      "");
        } catch (const InputError& error) {
            ADD_FAILURE() << error.what();
        }
        EXPECT_NE(text_of(entry.path()).find("\n# "), std::string::npos) << "no comment line";
        ++count;
    }
    EXPECT_GE(count, 20);
}

TEST(Scenes, AreWrittenAsTheyWereRead) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(sources / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        if (text_of(entry.path()).find("\n[machine]") != std::string::npos) continue;
        const Scene scene = read_scene_file(entry.path(), known);
        const std::string text = scene_text(scene);
        SCOPED_TRACE(entry.path().string() + "\n" + text);
        EXPECT_EQ(testing_support::differing_parts(scene, read_scene(text, "again.toml", known)), "");
        ++count;
    }
    EXPECT_GE(count, 20);
}

TEST(SceneDocumentation, MatchesKeyTable) {
    const std::filesystem::path path = sources / "docs" / "scene_file.md";
    const std::string begin = "<!-- keys: begin -->\n";
    const std::string end = "<!-- keys: end -->";
    const std::string text = text_of(path);
    const std::size_t first = text.find(begin);
    const std::size_t last = text.find(end);
    ASSERT_TRUE(first != std::string::npos && last != std::string::npos) << path << " has lost its marks";
    const std::string rendered = scene_keys_markdown();
    if (std::getenv("CAMOPT_WRITE_DOCS") != nullptr)
        std::ofstream(path, std::ios::binary)
            << text.substr(0, first) << begin << rendered << text.substr(last);
    else
        EXPECT_EQ(text.substr(first + begin.size(), last - first - begin.size()), rendered)
            << "Regenerate the table: CAMOPT_WRITE_DOCS=1 ctest -R SceneDocumentation";
}

TEST(SceneDocumentation, ShowsWholeScenesThatRead) {
    const std::string text = text_of(sources / "docs" / "scene_file.md");
    const std::string fence = "```toml\n";
    int count = 0;
    for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
        at += fence.size();
        const std::string toml = text.substr(at, text.find("```", at) - at);
        if (!toml.starts_with("title")) continue;  // the others show a part
        SCOPED_TRACE(toml);
        EXPECT_NO_THROW((void)read_scene(toml, "scene_file.md", known));
        ++count;
    }
    EXPECT_GE(count, 4);
}

}  // namespace scene_files_test
}  // namespace camopt::input

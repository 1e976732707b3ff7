// SPDX-License-Identifier: MIT
// camopt export of a result folder: the very cam that was delivered, without solving again.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "shop/step/step_file.hpp"
#include "tests/report/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace camopt {
namespace export_folder_test {

using test::ProgramRun;
using test::run_camopt;

struct Case {
    std::string name, scene, settings, wishes;
    friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.emplace(entry.path().filename().string(), read_text_file(entry.path()));
    return files;
}

class ExportFolder : public testing::TestWithParam<Case> {};

TEST_P(ExportFolder, WritesWhatTheSceneWrites) {
    const Case& one = GetParam();
    const test::TemporaryFolder folder;
    const std::string result = folder.path() + "/result", of_scene = folder.path() + "/scene",
                      of_folder = folder.path() + "/folder";
    const ProgramRun solved =
        run_camopt("solve " + test::scene(one.scene) + one.settings + " --out " + result);
    ASSERT_EQ(solved.exit_code, 0) << solved.errors;
    const ProgramRun scene =
        run_camopt("export " + test::scene(one.scene) + one.settings + one.wishes + " --out " + of_scene);
    ASSERT_EQ(scene.exit_code, 0) << scene.errors;
    const ProgramRun read = run_camopt("export " + result + one.wishes + " --out " + of_folder);
    ASSERT_EQ(read.exit_code, 0) << read.errors;
    const auto wanted = files_in(of_scene), found = files_in(of_folder);
    ASSERT_FALSE(wanted.empty());
    EXPECT_EQ(wanted.size(), found.size());
    for (const auto& [name, bytes] : wanted)
        EXPECT_TRUE(found.contains(name) && found.at(name) == bytes) << name;
}

const std::string quick = " --set spline.segments=8 --set solver.starts=1";

INSTANTIATE_TEST_SUITE_P(
    Kinds, ExportFolder,
    testing::ValuesIn(std::vector<Case>{
        {"roller", "cam_drdrd", quick, " --csv --dxf --picture --stl --nc --cutter-mm 12"},
        {"knife", "cam_knife", quick, " --csv --dxf"},
        {"flat", "cam_flat", " --set spline.segments=16 --set solver.starts=1", " --csv --dxf --picture"},
        {"arm_roller", "cam_arm_roller", quick, " --csv --dxf"},
        {"arm_flat", "cam_arm_flat", quick, " --csv --dxf"},
        {"program", "cam_laws_and_splines", quick, " --csv --stl"},
        {"remote", "tappet_75", quick, " --csv --dxf --picture"},
        {"barrel", "barrel_paper_cup", quick, " --csv --stl --nc"},
        {"cylinder_slide", "cylinder_slide", quick, " --csv --stl"},
        {"cylinder_turn", "ocrf_indexing", quick, " --csv --stl --picture --sections 5 --points 90"},
        {"inverse", "inverse_feeder", quick, " --csv --dxf --picture"},
    }),
    [](const auto& one) { return one.param.name; });

// A scene that cannot be solved in its time: what stands in the folder is exported all the same.
TEST(ExportOfAFolder, SolvesNothing) {
    const test::TemporaryFolder folder;
    const std::string result = folder.path() + "/result", out = " --out " + folder.path() + "/out --dxf";
    ASSERT_EQ(run_camopt("solve " + test::scene("cam_drdrd") + quick + " --out " + result).exit_code, 0);
    std::string scene = read_text_file(result + "/scene.toml");
    const std::size_t solver = scene.find("[solver]\n");
    ASSERT_NE(solver, std::string::npos);
    scene.insert(solver + 9, "max_seconds = 1e-9\n");
    write_text_file(result + "/scene.toml", scene);
    EXPECT_EQ(run_camopt("export " + result + "/scene.toml" + out).exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/out/profile.dxf"));
    const ProgramRun run = run_camopt("export " + result + out);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_TRUE(std::filesystem::exists(folder.path() + "/out/profile.dxf"));
}

TEST(ExportCommand, StepOrWhatToInstall) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("export " + test::scene("barrel_paper_cup") + " --out " +
                                      folder.path() + quick + " --step");
    if (step_available()) {
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        EXPECT_TRUE(std::filesystem::exists(folder.path() + "/flanks.step"));
    } else {
        EXPECT_EQ(run.exit_code, 2);
        EXPECT_NE(run.errors.find("libocct-data-exchange-dev"), std::string::npos) << run.errors;
    }
}

}  // namespace export_folder_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// Files of a whole cam.
#include "shop/spatial/cam_export.hpp"

#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "report/temporary_folder.hpp"
#include "shop/step/step_file.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

namespace camopt {
namespace cam_export_test {

using testing_support::refusal;

std::set<std::string> names(const std::vector<std::filesystem::path>& paths) {
    std::set<std::string> result;
    for (const auto& path : paths) {
        EXPECT_GT(std::filesystem::file_size(path), 1000u) << path;
        result.insert(path.filename().string());
    }
    return result;
}

TEST(CamExport, WritesRequestedFiles) {
    const test::TemporaryFolder temporary;
    const std::filesystem::path folder = temporary.path();
    CamExportOptions options;
    EXPECT_TRUE(write_cam_files(folder, test::barrel_cam(), test::barrel_motion(), options).empty());
    options.csv = options.stl = options.picture = true;
    EXPECT_EQ(names(write_cam_files(folder, test::barrel_cam(), test::barrel_motion(), options)),
              (std::set<std::string>{"flanks.csv", "groove.stl", "cam.stl", "cam.svg"}));
    EXPECT_EQ(names(write_cam_files(folder, test::translating_cam(), test::translating_motion(), options)),
              (std::set<std::string>{"flanks.csv", "groove.stl", "cam.svg"}));
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        EXPECT_NE(entry.path().extension(), ".tmp");
    options = {};
    options.step = true;
    if (step_available())
        EXPECT_EQ(names(write_cam_files(folder, test::barrel_cam(), test::barrel_motion(), options)),
                  std::set<std::string>{"flanks.step"});
    else
        EXPECT_THROW(write_cam_files(folder, test::barrel_cam(), test::barrel_motion(), options),
                     UnavailableError);
    options = {};
    options.csv = true;
    EXPECT_EQ(refusal([&] {
                  write_cam_files(folder / "none", test::barrel_cam(), test::barrel_motion(), options);
              }),
              "cannot write " + (folder / "none/flanks.csv").string() + ": No such file or directory");
}

}  // namespace cam_export_test
}  // namespace camopt

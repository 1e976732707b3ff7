// SPDX-License-Identifier: MIT
// STEP files: there whole, or refused; what is in them reads step_read_back.py.
#include "core/errors.hpp"
#include "shop/step/step_file.hpp"
#include "tests/report/surface/surface_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace camopt {
namespace step_test {

std::vector<BsplineSurface> surfaces() {
    return bspline_surfaces(flank_surfaces(test::barrel_grid(4, 40))[0]);
}

TEST(StepFile, IsWrittenOrNamesMissingLibrary) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        ("camopt_step_test_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + ".step");
    ::testing::internal::CaptureStdout();
    if (!step_available()) {
        EXPECT_THROW(write_step_file(path, surfaces()), UnavailableError);
        EXPECT_FALSE(std::filesystem::exists(path));
    } else {
        write_step_file(path, surfaces());
        std::ifstream file(path);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(text.substr(0, 13), "ISO-10303-21;");
        std::size_t faces = 0;
        for (std::size_t place = 0;
             (place = text.find("ADVANCED_FACE('flank +1", place)) != std::string::npos; ++place)
            ++faces;
        EXPECT_EQ(faces, surfaces().size());
        std::filesystem::remove(path);
    }
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(StepFile, RefusesWhatCannotBeWritten) {
    EXPECT_THROW(write_step_file("/no/such/folder/cam.step", surfaces()), InputError);
    EXPECT_THROW(write_step_file("cam.step", {}), InputError);
    auto broken = surfaces();
    broken[0].knots_u[1] = broken[0].knots_u.back() + 1.0;
    EXPECT_THROW(write_step_file("cam.step", broken), InputError);
    EXPECT_FALSE(std::filesystem::exists("cam.step"));
}

TEST(StepFile, FullDiskIsRefusedWithoutRemains) {
    if (!step_available() || !std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "no Open CASCADE in this build, or no /dev/full";
    const std::string path =
        (std::filesystem::temp_directory_path() / ("camopt_full_" + std::to_string(::getpid()) + ".step"))
            .string();
    std::filesystem::create_symlink("/dev/full", path + "." + std::to_string(::getpid()) + ".tmp");
    EXPECT_EQ(testing_support::refusal([&] { write_step_file(path, surfaces()); }),
              "cannot write " + path + ": No space left on device");
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace step_test
}  // namespace camopt

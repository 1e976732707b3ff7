// SPDX-License-Identifier: MIT
// Drawings, solids, programs, electronic cams and reports through the C face: the bytes of the C++ face.
#include "core/text/text_file.hpp"
#include "report/exports/exports.hpp"
#include "shop/step/step_file.hpp"
#include "tests/bindings/c/c_face.hpp"
#include "tests/report/prescribed_disk.hpp"
#include "tests/report/temporary_folder.hpp"

#include <array>
#include <filesystem>
#include <string>

namespace camopt {
namespace c_files_test {

using namespace testing_support;

/// With a load over the cam angle and a limit of one side.
std::string prescribed_toml() {
    return std::string(prescribed_disk_toml) + R"(
[forces]
preload_n = 100
load_n = [[60, 0], [90, 250], [120, 0]]
[drawing]
thickness_mm = 4
[limits]
acceleration_m_s2 = { min = -20 }
)";
}

struct Bytes {
    camopt_text text{nullptr, 0};
    Bytes() = default;
    ~Bytes() { camopt_text_free(&text); }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;
    [[nodiscard]] std::string value() const { return {text.data, text.length}; }
};

TEST(CFiles, EveryFileIsThatOfCpp) {
    const CSolution c = c_solved(c_scene(prescribed_toml()));
    const Solution cpp = cpp_solved(prescribed_toml());
    Bytes names;
    EXPECT_OK(camopt_file_names(c.get(), &names.text));
    std::string lines;
    for (const std::string& name : export_names(cpp)) lines += name + "\n";
    EXPECT_EQ(names.value(), lines);
    for (const char* const name :
         {"drawing.svg", "drawing.dxf", "cam.nc", "cam_nc_check.txt", "codesys.st"}) {
        Bytes bytes;
        EXPECT_OK(camopt_file(c.get(), name, nullptr, &bytes.text)) << name;
        EXPECT_EQ(bytes.value(), exported_file(cpp, name)) << name;
    }
    Bytes report, step;
    EXPECT_OK(camopt_file(c.get(), "report.html", nullptr, &report.text));
    EXPECT_NE(report.value().find("acceleration"), std::string::npos);
    const camopt_error code = camopt_file(c.get(), "cam.step", nullptr, &step.text);
    EXPECT_EQ(code, step_available() ? CAMOPT_OK : CAMOPT_ERROR_UNAVAILABLE);
    if (step_available()) {
        EXPECT_EQ(step.value().substr(0, 12), "ISO-10303-21");
    }
}

TEST(CFiles, OptionsAreThoseOfTheStruct) {
    const CSolution solution = c_solved(c_scene(prescribed_toml()));
    camopt_file_options options{};
    options.size = sizeof options;
    options.spindle_rpm = 4321;
    options.thickness_mm = 3;
    options.cutter_mm = 6;
    Bytes bytes;
    EXPECT_OK(camopt_file(solution.get(), "cam.nc", &options, &bytes.text));
    EXPECT_NE(bytes.value().find("S4321"), std::string::npos);
    options.settings = "spindle=counterclockwise\ntool_number=7\n";
    Bytes more;
    EXPECT_OK(camopt_file(solution.get(), "cam.nc", &options, &more.text));
    EXPECT_NE(more.value().find("S4321 M4"), std::string::npos);
    EXPECT_NE(more.value().find("T7 M6"), std::string::npos);
    options.settings = "tool_number";
    EXPECT_EQ(camopt_file(solution.get(), "cam.nc", &options, &bytes.text), CAMOPT_ERROR_INPUT);
    options.settings = nullptr;
    options.size = 1;
    EXPECT_EQ(camopt_file(solution.get(), "cam.nc", &options, &bytes.text), CAMOPT_ERROR_ARGUMENT);
    options.size = sizeof options;
    options.post = "no/such/post.toml";
    EXPECT_EQ(camopt_file(solution.get(), "cam.nc", &options, &bytes.text), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string(camopt_error_text()).find("no/such/post.toml"), std::string::npos);
}

TEST(CFiles, AbsentFilesAreErrors) {
    const CSolution motion = c_solved(c_scene(paper_toml));
    Bytes bytes;
    EXPECT_EQ(camopt_file(motion.get(), "cam.nc", nullptr, &bytes.text), CAMOPT_ERROR_ABSENT);
    EXPECT_NE(std::string(camopt_error_text()).find("allowed for this solution: report.html"),
              std::string::npos);
    EXPECT_EQ(camopt_file(motion.get(), nullptr, nullptr, &bytes.text), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_file(nullptr, "report.html", nullptr, &bytes.text), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_file_names(motion.get(), nullptr), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_write_files(motion.get(), "/tmp", nullptr, 1, nullptr), CAMOPT_ERROR_NULL);
}

TEST(CFiles, FolderGetsThem) {
    const test::TemporaryFolder folder;
    const CSolution solution = c_solved(c_scene(prescribed_toml()));
    const std::string place = folder.path() + "/made";
    const std::array<const char*, 2> wanted = {"cam.nc", "drawing.svg"};
    EXPECT_OK(camopt_write_files(solution.get(), place.c_str(), wanted.data(), wanted.size(), nullptr));
    EXPECT_NE(read_text_file(place + "/cam.nc").find("G1"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(place + "/drawing.svg"));
    const std::array<const char*, 2> wrong = {"cam.nc", "nothing.txt"};
    EXPECT_EQ(camopt_write_files(solution.get(), (folder.path() + "/none").c_str(), wrong.data(),
                                 wrong.size(), nullptr),
              CAMOPT_ERROR_ABSENT);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/none/cam.nc"));
}

}  // namespace c_files_test
}  // namespace camopt

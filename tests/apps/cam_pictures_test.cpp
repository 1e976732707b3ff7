// SPDX-License-Identifier: MIT
// Pictures of cams say what the report says, and are to scale where they claim it.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/shop/dxf/dxf_text.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace cam_pictures_test {

using test::ProgramRun;
using test::run_camopt;

std::string file_of(const std::string& arguments, const std::string& folder, const std::string& name) {
    const ProgramRun run = run_camopt("solve " + arguments + " --out " + folder);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return read_text_file(folder + "/" + name);
}

/// The numbers of an SVG path or of an attribute, in order.
std::vector<double> numbers_in(std::string text) {
    for (char& letter : text)
        if (std::string("0123456789.-").find(letter) == std::string::npos) letter = ' ';
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (double number = 0.0; stream >> number;) numbers.push_back(number);
    return numbers;
}

/// What stands between two texts, from the first element with these words on.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return {};
    return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

/// The element, from its bracket on, in which the words stand, the n-th time.
std::string element_with(const std::string& text, const std::string& words) {
    const std::size_t place = text.find(words);
    if (place == std::string::npos) return {};
    const std::size_t begin = text.rfind('<', place);
    return text.substr(begin, text.find('>', place) - begin);
}

TEST(ProfileSvg, FaceWidthMatchesScene) {
    for (const double half_width : {14.5, 22.0}) {
        const test::TemporaryFolder folder;
        const std::string svg =
            file_of(test::scene("cam_flat") + " --set cam.face_half_width_mm=" + std::to_string(half_width),
                    folder.path(), "profile.svg");
        const double base = numbers_in(between(element_with(svg, "class=\"circle\""), " r=\"", "\"")).at(0);
        const std::vector<double> face =
            numbers_in(between(element_with(svg, "class=\"face\""), " d=\"", "\""));
        ASSERT_EQ(face.size(), 4U) << element_with(svg, "class=\"face\"");
        const double drawn = std::hypot(face[2] - face[0], face[3] - face[1]) / base * 17.0;
        EXPECT_NEAR(drawn, 2.0 * half_width, 0.02);  // pixels are written with two decimals
        EXPECT_NE(svg.find(half_width == 22.0 ? "22 mm" : "14.5 mm"), std::string::npos);
        EXPECT_NE(svg.find("face half width"), std::string::npos);
    }
}

TEST(ProfileDxf, FaceWidthMatchesScene) {
    const test::TemporaryFolder folder;
    const std::string dxf = file_of(test::scene("cam_flat") + " --dxf", folder.path(), "profile.dxf");
    double begin = 0.0, end = 0.0;  // x: the face stands across it where the motion begins
    std::string layer;
    for (const test::DxfTag& tag : test::dxf_tags(dxf)) {
        if (tag.code == 0) layer.clear();  // the next entity
        if (tag.code == 8) layer = tag.value;
        if (layer == "FACE" && tag.code == 10) begin = std::stod(tag.value);
        if (layer == "FACE" && tag.code == 11) end = std::stod(tag.value);
    }
    EXPECT_NEAR(std::abs(end - begin), 29.0, 1e-6);
}

/// The angles after ` at ` of every mark, as they are printed.
std::vector<std::string> marked_angles(const std::string& svg) {
    std::vector<std::string> angles;
    for (std::size_t place = svg.find(" at "); place != std::string::npos;
         place = svg.find(" at ", place + 1))
        if (const std::size_t end = svg.find("°", place); end != std::string::npos)
            angles.push_back(svg.substr(place + 4, end - place - 4));
    return angles;
}

TEST(ProfileDiagrams, MarkTheAnglesOfTheReport) {
    for (const char* const name : {"cam_roller", "cam_drdrd", "cam_arm_roller", "cam_arm_flat", "cam_flat"}) {
        const test::TemporaryFolder folder;
        const std::string svg =
            file_of(test::scene(name) + " --set solver.starts=1", folder.path(), "profile_diagrams.svg");
        const std::string report = read_text_file(folder.path() + "/report.md");
        const std::vector<std::string> angles = marked_angles(svg);
        EXPECT_FALSE(angles.empty()) << name;
        for (const std::string& angle : angles)
            EXPECT_NE(report.find("| " + angle + " |"), std::string::npos) << name << ": " << angle;
    }
}

}  // namespace cam_pictures_test
}  // namespace camopt

// SPDX-License-Identifier: MIT
// The picture of a program's cutter: its lines are the moves of the text, which this test reads by itself.
#include "shop/toolpath/tool_path_svg.hpp"

#include "report/chart/svg_canvas.hpp"
#include "shop/disk/disk_export.hpp"
#include "tests/shop/disk/harmonic_disk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace tool_path_svg_test {

constexpr double millimetre = 1e-3;

struct TextMove {
    bool rapid = false;
    Eigen::Vector3d end;
};

/// G0, G1, G2, G3 with modal words, mm; only moves between places that are known whole.
std::vector<TextMove> moves_of(const std::string& text) {
    std::vector<TextMove> moves;
    Eigen::Vector3d at = Eigen::Vector3d::Constant(NAN);
    int mode = -1;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line = std::regex_replace(line, std::regex(R"(\(.*?\)|;.*)"), "");
        const bool known = at.allFinite();
        bool moved = false;
        const std::regex word("([A-Z])(-?[0-9.]+)");
        for (std::sregex_iterator it(line.begin(), line.end(), word), end; it != end; ++it) {
            const char letter = (*it)[1].str()[0];
            const double value = std::stod((*it)[2].str());
            if (letter == 'G' && value <= 3.0) mode = static_cast<int>(value);
            if (letter < 'X' || letter > 'Z') continue;
            at(letter - 'X') = value * millimetre;
            moved = true;
        }
        if (moved && known) moves.push_back({mode == 0, at});
    }
    return moves;
}

struct Milled {
    std::unique_ptr<Machine> machine = plane_milling_machine();
    NcWork work;
    CheckedProgram program;
};

Milled milled(const DiskNcOptions& options) {
    Milled made;
    static const ProfileShape shape = testing_support::harmonic_disk(10.0 * millimetre);
    made.work = disk_nc_work(shape, options);
    made.program = checked_program(*made.machine, generic_post(*made.machine), made.work);
    return made;
}

DiskNcOptions with_roughing() {
    DiskNcOptions options;
    options.chord_tolerance = 2e-5;
    options.milling.step_over = 4.0 * millimetre;
    options.milling.step_down = 12.0 * millimetre;
    return options;
}

TEST(ToolPathPicture, PassesThroughEveryProgrammedMove) {
    const Milled made = milled(with_roughing());
    ASSERT_EQ(made.program.fault(), "");
    const std::vector<TextMove> wanted = moves_of(made.program.program.text);
    ASSERT_GT(wanted.size(), 200u);
    const std::vector<ToolPathLine> lines = tool_path_lines(made.program, *made.machine);
    std::size_t next = 0;
    for (const ToolPathLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            ASSERT_LT(next, wanted.size());
            const TextMove& move = wanted[next];
            // Straight moves are one step; only on the way in and out are there arcs, and points between.
            if ((line.points[i] - move.end).norm() > 1e-9) {
                EXPECT_EQ(line.role, MoveRole::way);
                continue;
            }
            EXPECT_EQ(line.role == MoveRole::rapid, move.rapid) << next;
            ++next;
        }
    EXPECT_EQ(next, wanted.size());
}

TEST(ToolPathPicture, DistinguishesRoughingFromFinishing) {
    const Milled made = milled(with_roughing());
    const double radius = 0.5 * made.work.task.cutter.diameter;
    int finishing = 0, roughing = 0;
    for (const ToolPathLine& line : tool_path_lines(made.program, *made.machine)) {
        if (line.role == MoveRole::finishing) ++finishing;
        if (line.role == MoveRole::roughing) ++roughing;
        if (line.role != MoveRole::finishing && line.role != MoveRole::roughing) continue;
        const bool last = line.pass + 1 == static_cast<int>(made.work.task.passes.size());
        EXPECT_EQ(line.role == MoveRole::finishing, last);
        // Finishing touches the cam: nowhere nearer or farther than its radius, within what blocks leave.
        for (std::size_t i = 1; last && i + 1 < line.points.size(); i += 7) {
            double nearest = HUGE_VAL;
            for (const Eigen::Vector3d& point : made.work.task.outlines.front())
                nearest = std::min(nearest, (point - line.points[i]).head<2>().norm());
            EXPECT_NEAR(nearest, radius, 2e-5);
        }
    }
    EXPECT_EQ(finishing, 1);
    EXPECT_GT(roughing, 2);
}

TEST(ToolPathPicture, DrawsThoseLines) {
    const Milled made = milled(with_roughing());
    const std::string svg =
        tool_path_svg(made.program, made.work, *made.machine, {"a cam", ShownUnit{"mm", 1e3}});
    // (Only the head by a regular expression: over a whole view it would take a stack frame for every
    // character.)
    const std::regex head(R"re(<g class="view" data-place="(\S+) (\S+) (\S+) (\S+)">\n)re");
    std::size_t views = 0;
    for (std::sregex_iterator it(svg.begin(), svg.end(), head), end; it != end; ++it, ++views) {
        const double x0 = std::stod((*it)[1].str()), y0 = std::stod((*it)[2].str());
        const double kx = std::stod((*it)[3].str()), ky = std::stod((*it)[4].str());
        const int up = views == 0 ? 1 : 2;
        const auto begin = static_cast<std::size_t>(it->position() + it->length());
        std::string text = svg.substr(begin, svg.find("</g>", begin) - begin);
        for (const ToolPathLine& line : tool_path_lines(made.program, *made.machine)) {
            std::string data;
            for (const Eigen::Vector3d& point : line.points)
                data += (data.empty() ? "M" : "L") + svg_number(x0 + kx * point.x()) + " " +
                        svg_number(y0 - ky * point(up));
            const std::size_t place = text.find("\"" + data + "\"");
            ASSERT_NE(place, std::string::npos) << data.substr(0, 60);
            text.erase(text.rfind("<path", place), text.find("/>", place) + 2 - text.rfind("<path", place));
        }
        EXPECT_EQ(text.find("<path"), std::string::npos) << "a line that is no move";
        if (views == 0) {
            EXPECT_EQ(kx, ky);  // to scale
        }
    }
    EXPECT_EQ(views, 2u);
    EXPECT_EQ(svg.find("REFUSED"), std::string::npos);
}

TEST(ToolPathPicture, ReportsRefusedProgram) {
    Milled made = milled({});
    std::string& text = made.program.program.text;
    const std::size_t rapid = text.find("G0 Z"), number = rapid + 4;
    text.replace(number, text.find('\n', number) - number, "-5.");
    verify(made.program, *made.machine, generic_post(*made.machine), made.work);
    ASSERT_NE(made.program.fault(), "");
    EXPECT_NE(tool_path_svg(made.program, made.work, *made.machine, {"a cam", ShownUnit{"mm", 1e3}})
                  .find("REFUSED"),
              std::string::npos);
}

}  // namespace tool_path_svg_test
}  // namespace camopt

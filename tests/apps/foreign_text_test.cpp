// SPDX-License-Identifier: MIT
// Control characters in a scene are shown, never sent: to the terminal, to reports, drawings and programs.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/report/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace camopt {
namespace foreign_text_test {

using test::ProgramRun;
using test::run_camopt;

// Escape, line feed, delete, the C1 control 9b (as the terminal's other "escape ["), right-to-left override.
const std::string title = R"("a\u001b[31mred\nProved: yes\u007f\u009b1m\u202etxt.exe")";
const std::string set_title = " --set 'title=" + title + "'";

/// Words around the first byte that a terminal would obey; empty: there is none.
std::string obeyed(std::string_view text) {
    const auto around = [&](std::size_t place) {
        return "at " + std::to_string(place) + ": " +
               std::string(text.substr(place < 20 ? 0 : place - 20, 40));
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto code = static_cast<unsigned char>(text[i]);
        const bool layout = text[i] == '\n' || text[i] == '\t';
        if ((code < 0x20 && !layout) || code == 0x7f) return around(i);
        if (text.substr(i, 2) == "\u009b" || text.substr(i, 3) == "\u202e") return around(i);
    }
    if (const std::size_t place = text.find("\nProved: yes"); place != std::string_view::npos)
        return around(place);
    return {};
}

void expect_tame(const std::string& arguments, int exit_code) {
    const ProgramRun run = run_camopt(arguments);
    EXPECT_EQ(run.exit_code, exit_code) << arguments << run.errors;
    EXPECT_EQ(obeyed(run.output), "") << arguments;
    EXPECT_EQ(obeyed(run.errors), "") << arguments;
}

void expect_tame_files(const std::filesystem::path& folder) {
    int looked_at = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::string text = read_text_file(entry.path());
        if (entry.path().extension() == ".stl") text.resize(80);  // the rest is binary, the head is text
        while (!text.empty() && text.back() == '\0') text.pop_back();
        EXPECT_EQ(obeyed(text), "") << entry.path();
        ++looked_at;
    }
    EXPECT_GT(looked_at, 2);
}

TEST(ForeignText, TitleIsEscaped) {
    for (const char* const name : {"drd_cubic_12", "cam_flat", "inverse_feeder"}) {
        const test::TemporaryFolder folder;
        expect_tame("solve " + test::scene(name) + set_title + " --out " + folder.path() +
                        (std::string_view(name) == "cam_flat" ? " --dxf"
                         : std::string_view(name) == "inverse_feeder"
                             ? " --set spline.segments=6 --set solver.starts=1"
                             : ""),
                    0);
        expect_tame_files(folder.path());
        const std::string report = read_text_file(folder.path() + "/report.md");
        EXPECT_NE(report.find("\\u001b[31mred\\u000aProved: yes\\u007f"), std::string::npos)
            << report.substr(0, 200);
    }
}

TEST(ForeignText, TitlesInExportsAreEscaped) {
    const test::TemporaryFolder folder;
    expect_tame("export " + test::scene("barrel_paper_cup") + set_title + " --out " + folder.path() +
                    " --set spline.segments=8 --set solver.starts=1 --stl --picture --nc --chord-mm 0.05",
                0);
    expect_tame("compare " + test::scene("drd_cubic_12") + set_title + " --out " + folder.path(), 0);
    expect_tame("solve --json " + test::scene("drd_cubic_12") + set_title, 0);
    expect_tame("check " + test::scene("drd_cubic_12") + set_title, 0);
    expect_tame_files(folder.path());
}

TEST(ForeignText, OfKeysValuesAndFiles) {
    const test::TemporaryFolder folder;
    const std::string file = folder.path() + "/wrong.toml";
    for (const char* const line :
         {R"("a\u001b[31m" = 1)", R"(type = "b\u009b1m")", R"([spline] "c\u001b]0;x\u0007" = 2)",
          "bad \x1b[31m = 1", "# comment with \x1b\nwrong = 1", R"("d\nProved: yes" = 1)"}) {
        write_text_file(file, line);
        expect_tame("solve " + file, 2);
        expect_tame("check " + file, 2);
    }
    expect_tame("solve 'missing\x1b[31m.toml'", 2);
    expect_tame("solve " + test::scene("drd_cubic_12") + " --set 'spline.\x1b[31m=3'", 2);
    expect_tame("'\x1b[31mcommand'", 2);
}

}  // namespace foreign_text_test
}  // namespace camopt

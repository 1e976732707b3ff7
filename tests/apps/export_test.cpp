// SPDX-License-Identifier: MIT
// camopt export: what is written, what is refused.
#include "core/text/text_file.hpp"
#include "output/surface/step/step_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace camopt {
namespace export_test {

using test::ProgramRun;
using test::run_camopt;

// Fewer segments and one start: what is solved does not matter here.
const std::string quick = " --set spline.segments=8 --set solver.starts=1";

TEST(ExportCommand, WritesCamAndCheckedProgram) {
    const test::TemporaryFolder folder;
    const std::string out = " --out " + folder.path();
    const ProgramRun run =
        run_camopt("export " + test::scene("ocrf_indexing") + out + quick +
                   " --csv --stl --picture --nc --full-depth --cutter-mm 10 --z-offset-mm 120");
    EXPECT_NE(run.output.find("WARNING            the first pass cuts a slot"), std::string::npos)
        << run.output;
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("every block is correct"), std::string::npos) << run.output;
    for (const char* const name :
         {"flanks.csv", "groove.stl", "cam.stl", "cam.svg", "cam.nc", "cam_nc_check.txt"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() + "/" + name)) << name;
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/flanks.step"));
    const std::string program = read_text_file(folder.path() + "/cam.nc");
    EXPECT_NE(program.find("(pass: flank -1)"), std::string::npos);
    EXPECT_NE(run.output.find(read_text_file(folder.path() + "/cam_nc_check.txt")), std::string::npos);
}

TEST(ExportCommand, TakesAPostProcessor) {
    const test::TemporaryFolder folder;
    const ProgramRun run =
        run_camopt("export " + test::scene("barrel_paper_cup") + " --out " + folder.path() + quick +
                   " --nc --post " + source_folder() + "/docs/posts/rotary_table_mm.toml");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string program = read_text_file(folder.path() + "/cam.nc");
    EXPECT_EQ(program.substr(0, 15), "G17 G40 G80 G54");
    EXPECT_NE(run.output.find("every block is correct"), std::string::npos) << run.output;
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

TEST(ExportCommand, DiskCam) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("export " + test::scene("cam_drdrd") + " --out " + folder.path() +
                                      " --set solver.starts=1 --stl --nc --cutter-mm 12");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("every block is correct"), std::string::npos) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder.path() + "/cam.stl"));
    EXPECT_NE(read_text_file(folder.path() + "/cam.nc").find("(machine: three axes"), std::string::npos);
}

TEST(ExportCommand, BlankDeterminesRapidHeight) {
    const test::TemporaryFolder folder;
    const ProgramRun run =
        run_camopt("export " + test::scene("barrel_paper_cup") + " --out " + folder.path() + quick +
                   " --nc --blank-diameter-mm 400 --blank-from-mm -150 "
                   "--blank-to-mm 150 --clearance-mm 30 --safe-mm 4");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string program = read_text_file(folder.path() + "/cam.nc");
    for (const char* const words : {"diameter 400.000 mm, from -150.000 to 150.000 mm",
                                    "(clearance plane: Z230.0000, 30 mm above the blank",
                                    "(rapids stay 4 mm or more", "\nG0 Z230.0000\n", "\nG0 Z204.0000\n"})
        EXPECT_NE(program.find(words), std::string::npos) << words;
    EXPECT_NE(run.output.find("3.9999 mm or more from the blank"), std::string::npos) << run.output;
}

// A cutter that is rounder than the cam's hollow: no program, nor the one of an earlier run.
TEST(ExportCommand, WritesOnlyProgramsPassingCheck) {
    const test::TemporaryFolder folder;
    const std::string arguments = "export " + test::scene("cam_roller") + " --out " + folder.path() +
                                  " --set solver.starts=1 --nc --chord-mm 0.01 --cutter-mm ";
    ASSERT_EQ(run_camopt(arguments + "12").exit_code, 0);
    ASSERT_TRUE(std::filesystem::exists(folder.path() + "/cam.nc"));
    const ProgramRun run = run_camopt(arguments + "1000");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("the NC program is refused and was not written"), std::string::npos)
        << run.errors;
    EXPECT_NE(run.output.find("REFUSED: line "), std::string::npos) << run.output;
    EXPECT_EQ(run.output.find("cam.nc\n"), std::string::npos) << run.output;
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/cam.nc"));
    EXPECT_NE(read_text_file(folder.path() + "/cam_nc_check.txt").find("REFUSED"), std::string::npos);
}

// A motion alone: no cam is needed.
TEST(ExportCommand, WritesTableAndElectronicCam) {
    const test::TemporaryFolder folder;
    const ProgramRun run =
        run_camopt("export " + test::scene("swing_limits") + " --out " + folder.path() +
                   " --csv --columns theta_deg,v_rad_s --step-deg 7 --digits 8 --plc siemens");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string table = read_text_file(folder.path() + "/table.csv");
    EXPECT_TRUE(table.starts_with("theta_deg,v_rad_s\n0,0\n7,")) << table;
    EXPECT_NE(table.find("\n147,"), std::string::npos) << table;
    EXPECT_NE(table.find("\n150,"), std::string::npos) << table;
    EXPECT_NE(run.output.find(
                  "23 rows over the motion, which is not one revolution, 0 to 150 deg; the last step is 3"),
              std::string::npos)
        << run.output;
    EXPECT_NE(run.output.find("lossless: s "), std::string::npos) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder.path() + "/siemens.scl"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() + "/plc.json"));
}

TEST(ExportCommand, RefusesWhatItCannotExport) {
    const test::TemporaryFolder folder;
    const std::string out = " --out " + folder.path();
    const auto refused = [](const std::string& arguments, const std::string& reason) {
        const ProgramRun run = run_camopt("export " + arguments);
        EXPECT_EQ(run.exit_code, 2) << arguments;
        EXPECT_NE(run.errors.find(reason), std::string::npos) << arguments << run.errors;
    };
    const std::string barrel = test::scene("barrel_paper_cup");
    refused(test::scene("drd_cubic_12") + out + " --nc", "the rest is for cams, and this scene has none");
    refused(test::scene("drd_cubic_12") + out, "export writes --csv, --lobe and --plc of a motion");
    refused(barrel + out + " --digits 3", "--csv");
    refused(barrel + out + " --csv --digits 30", "17");
    refused(test::scene("drd_cubic_12") + out + " --csv --columns v_mm_s", "needs motion.speed_rpm");
    refused(test::scene("drd_cubic_12") + out + " --plc codesis", "did you mean 'codesys'?");
    refused(test::scene("cam_smallest") + out + " --nc", "no return is given");
    refused(barrel + " --nc", "--out");
    refused(barrel + out + " --cutter-mm 10", "--nc");
    refused(barrel + out + quick + " --nc --cutter-mm 80", "must not exceed the roller radius");
    refused(barrel + out + quick + " --nc --post none.toml", "none.toml");
    const std::string disk = test::scene("cam_drdrd") + out + " --set solver.starts=1 --nc";
    refused(disk + " --clearance-mm -5", "inside the blank");
    refused(disk + " --clearance-mm 1", "above the blank");
    refused(disk + " --blank-diameter-mm 50", "does not hold the cam");
    refused(barrel + out + " --blank-diameter-mm 400", "--nc");
}

}  // namespace export_test
}  // namespace camopt

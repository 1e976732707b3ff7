// SPDX-License-Identifier: MIT
// Where the rapids of exported programs go, read from the text without the project's own reader.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace nc_rapids_test {

using test::ProgramRun;
using test::run_camopt;

// Fewer segments, one start, coarse chords: what is solved and how smooth it is do not matter here.
const std::string quick = " --set spline.segments=8 --set solver.starts=1 --chord-mm 0.02";
const std::string quick_disk = " --set solver.starts=1";

/// Z of the tool at the end of every rapid, mm.
std::vector<double> heights_of_rapids(const std::string& program) {
    std::vector<double> heights;
    std::istringstream lines(program);
    double height = std::numeric_limits<double>::quiet_NaN();
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] != 'G') continue;
        if (const std::size_t place = line.find(" Z"); place != std::string::npos)
            height = std::stod(line.substr(place + 2));
        if (line.rfind("G0 ", 0) == 0) heights.push_back(height);
    }
    return heights;
}

struct Extent {
    double highest = 0.0;   ///< z
    double radius = 0.0;    ///< about z
    double farthest = 0.0;  ///< from the origin
};

/// Of the corners of a binary STL file, mm.
Extent extent_of(const std::string& stl) {
    Extent extent{-HUGE_VAL, 0.0, 0.0};
    for (std::size_t facet = 84; facet + 50 <= stl.size(); facet += 50)
        for (int corner = 1; corner <= 3; ++corner) {
            float p[3];
            std::memcpy(p, stl.data() + facet + 12 * static_cast<std::size_t>(corner), sizeof p);
            extent.highest = std::max<double>(extent.highest, p[2]);
            extent.radius = std::max<double>(extent.radius, std::hypot(p[0], p[1]));
            extent.farthest = std::max<double>(extent.farthest, std::hypot(p[0], p[1], p[2]));
        }
    return extent;
}

struct ExportedCam {
    std::vector<double> rapids;
    Extent body;
};

ExportedCam exported(const std::string& arguments) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("export " + arguments + " --out " + folder.path() + " --stl --nc");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    if (run.exit_code != 0) return {};
    return {heights_of_rapids(read_text_file(folder.path() + "/cam.nc")),
            extent_of(read_text_file(folder.path() + "/cam.stl"))};
}

void expect_above(const ExportedCam& cam, double body) {
    ASSERT_FALSE(cam.rapids.empty());
    for (const double height : cam.rapids) EXPECT_GT(height, body + 1.0);
}

TEST(NcRapids, ClearBlankOfDiskCam) {
    for (const char* const thickness : {"", " --thickness-mm 40"}) {
        const ExportedCam cam =
            exported(test::scene("cam_roller") + quick_disk + " --full-depth --cutter-mm 12" + thickness);
        EXPECT_NEAR(cam.body.highest, 0.0, 1e-6);
        expect_above(cam, cam.body.highest);
    }
}

TEST(NcRapids, ClearBlankOfBarrelCam) {
    const ExportedCam cam = exported(test::scene("barrel_paper_cup") + quick);
    EXPECT_GT(cam.body.radius, 140.0);
    expect_above(cam, cam.body.radius);
}

// The table tilts before the first cut: only what clears every point of the cam clears it then.
TEST(NcRapids, ClearBlankAtAnyTableAngle) {
    const ExportedCam cam = exported(test::scene("ocrf_indexing") + quick + " --cutter-mm 10");
    expect_above(cam, cam.body.radius);
    EXPECT_GT(*std::max_element(cam.rapids.begin(), cam.rapids.end()), cam.body.farthest + 1.0);
    EXPECT_GT(cam.rapids.front(), cam.body.farthest + 1.0);
}

TEST(NcCheck, FindsNoStockAtBlockEnds) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("export " + source_folder() + "/tests/cases/48_weld.toml --out " +
                                      folder.path() + " --nc --cutter-mm 30.48 --full-depth --chord-mm 0.01");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string check = read_text_file(folder.path() + "/cam_nc_check.txt");
    double least = NAN, most = NAN;
    const std::size_t place = check.find("the cam's contour: ");
    ASSERT_NE(place, std::string::npos) << check;
    ASSERT_EQ(std::sscanf(check.c_str() + place, "the cam's contour: %lf mm to %lf mm", &least, &most), 2);
    EXPECT_GT(least, -0.011);  // chords of 0.01 mm and printed digits
    EXPECT_LT(most, 0.0002);
}

}  // namespace nc_rapids_test
}  // namespace camopt

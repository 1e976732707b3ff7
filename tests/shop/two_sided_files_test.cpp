// SPDX-License-Identifier: MIT
// Files of cams that drive both ways: tables of both sides, pieces, what is refused.
#include "profiles/disk/disk_cam.hpp"
#include "report/cam/cam_files.hpp"
#include "report/csv/motion_csv.hpp"
#include "shop/disk/disk_export.hpp"
#include "shop/disk/disk_solid.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/cam_sheet.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace two_sided_files_test {

using testing_support::refusal;
using testing_support::says;

Solution solved(const std::string& name) {
    Solution solution =
        solve(testing_support::scene_named(name).with("solver.starts=1", "spline.segments=6"));
    solution.cam->forward_check = check_cam(solution, 600);
    return solution;
}

class TwoSidedFiles : public testing::Test {
 protected:
    // Each is solved where a test first looks at it.
    static const Solution& grooved() {
        static const Solution solution = solved("cam_grooved");
        return solution;
    }
    static const Solution& conjugate() {
        static const Solution solution = solved("cam_conjugate");
        return solution;
    }
    static std::string file(const Solution& solution, const std::string& name) {
        for (const CamFile& one : cam_files(solution, {.points = 200}))
            if (one.name == name) return one.text;
        for (const FolderFile& one : dxf_files(solution))
            if (one.name == name) return one.text;
        return {};
    }
};

std::vector<std::vector<double>> rows_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    std::vector<std::vector<double>> rows;
    while (std::getline(lines, line)) {
        std::vector<double>& row = rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(cell.empty() ? std::nan("") : std::stod(cell));
    }
    return rows;
}

TEST_F(TwoSidedFiles, TablesAreOffsetsOfPath) {
    const auto inner = rows_of(file(grooved(), "profile.csv")),
               outer = rows_of(file(grooved(), "second_profile.csv"));
    ASSERT_GT(inner.size(), 190U);
    ASSERT_EQ(inner.size(), outer.size());
    for (std::size_t i = 0; i < inner.size(); ++i) {
        for (const int column : {0, 1, 2, 3}) EXPECT_EQ(inner[i][column], outer[i][column]) << i;
        for (const auto* const rows : {&inner, &outer})
            EXPECT_NEAR(std::hypot((*rows)[i][4] - inner[i][2], (*rows)[i][5] - inner[i][3]), 10.025, 1e-9);
        // A side that does not carry has neither force nor pressure; the two share the turn.
        EXPECT_TRUE(inner[i][14] == 0.0 || outer[i][14] == 0.0);
        EXPECT_GT(inner[i][14] + outer[i][14], -1e-12);
    }
}

TEST_F(TwoSidedFiles, UniformTableUsesFirstSide) {
    UniformTableOptions options;
    options.columns = {"theta_deg",  "cam_x_mm", "cam_y_mm",      "pitch_x_mm",
                       "pitch_y_mm", "force_n",  "normal_force_n"};
    double least = 0.0;
    for (const std::vector<double>& row : rows_of(uniform_table(grooved(), options).text)) {
        EXPECT_NEAR(std::hypot(row[1] - row[3], row[2] - row[4]), 10.025, 1e-6);
        EXPECT_LT(std::hypot(row[1], row[2]), std::hypot(row[3], row[4]));
        EXPECT_GE(row[6], std::abs(row[5]) * (1.0 - 1e-9));
        least = std::min(least, row[5]);
    }
    EXPECT_LT(least, -1.0);
}

TEST_F(TwoSidedFiles, TwoDisksAreTwoPieces) {
    const ProfileShape shape = delivered_shape(conjugate()).value();
    EXPECT_TRUE(says(refusal([&] { (void)disk_nc_work(shape, {}); }), "found two disks"));
    EXPECT_TRUE(says(refusal([&] { (void)disk_volume(shape, {}); }), "found two disks"));
    const std::vector<ProfileShape> pieces = made_pieces(shape);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(cam_sheets(conjugate()).size(), 2u);
    for (const double theta : {0.3, 2.0, 5.0}) {
        EXPECT_EQ(pieces[0].at(theta).contact, shape.at(theta).contact);
        EXPECT_EQ(pieces[1].at(theta).contact, shape.other(theta).contact);
        // Out of the material: what stands off along the normal is farther from the disk.
        for (const ProfileShape& piece : pieces) {
            const MechanismPoint point = piece.at(theta);
            EXPECT_GT(point.normal.dot(point.contact), 0.0);
            EXPECT_EQ(piece.formulas().stations(), 1);
        }
    }
}

// What has no style is not drawn.
TEST_F(TwoSidedFiles, SheetElementsHaveStyles) {
    CamSheetOptions options;
    options.bore = 10e-3;
    for (const Solution* const solution : {&grooved(), &conjugate()})
        for (const Sheet& sheet : cam_sheets(*solution, options)) {
            EXPECT_FALSE(sheet.dimensions.empty());
            for (const DrawnElement& element : drawing_with_marks(sheet).elements)
                EXPECT_NE(std::ranges::find(sheet_styles, style_of(element), &SheetStyle::name),
                          sheet_styles.end())
                    << style_of(element);
        }
}

TEST_F(TwoSidedFiles, FittingCuttersMillTheGroove) {
    const ProfileShape shape = delivered_shape(grooved()).value();
    ASSERT_EQ(made_pieces(shape).size(), 1u);
    const auto machine = plane_milling_machine();
    const PostProcessor post = generic_post(*machine);
    DiskNcOptions options;
    options.chord_tolerance = 1e-5;
    for (const double diameter : {20.05e-3, 16e-3, 8e-3}) {
        options.cutter_diameter = diameter;
        options.milling.full_depth = diameter > 16e-3;
        const NcWork work = disk_nc_work(shape, options);
        const CheckedProgram program = checked_program(*machine, post, work);
        EXPECT_EQ(program.fault(), "") << diameter;
        for (const SurfaceFinding& surface : program.surfaces) {
            EXPECT_NEAR(surface.check.least_stock, 0.0, program.most_depth) << surface.name;
            EXPECT_NEAR(surface.check.stock, 0.0, program.most_depth) << surface.name;
        }
        // Deeper than the floor, and aside into a flank.
        std::string deeper = program.program.text, aside = deeper;
        const std::size_t floor = deeper.find("Z-10.");
        ASSERT_NE(floor, std::string::npos);
        deeper.replace(floor, 4, "Z-11");
        CheckedProgram spoiled = program;
        spoiled.program.text = deeper;
        verify(spoiled, *machine, post, work);
        EXPECT_NE(spoiled.fault(), "") << diameter;
    }
    options.milling.full_depth = true;
    options.cutter_diameter = 8e-3;
    EXPECT_TRUE(says(refusal([&] { (void)disk_nc_work(shape, options); }), "leaves 4.050 mm"));
    options.cutter_diameter = 20.2e-3;
    EXPECT_NE(refusal([&] { (void)disk_nc_work(shape, options); }), "");
    options.cutter_diameter = 20e-3;
    options.groove_depth = 0.02;
    EXPECT_TRUE(says(refusal([&] { (void)disk_nc_work(shape, options); }), "less deep"));
}

}  // namespace two_sided_files_test
}  // namespace camopt

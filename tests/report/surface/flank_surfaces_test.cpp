// SPDX-License-Identifier: MIT
// Flanks of three-dimensional cams as tables, grids and solids.
#include "report/spatial/flank_surfaces.hpp"

#include "core/errors.hpp"
#include "surface_samples.hpp"
#include "tests/report/surface/mesh_edges.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace camopt {
namespace flank_surfaces_test {

using testing_support::refusal;

using test::millimetre;

TEST(FlankCsv, RoundTrips3200PaperPoints) {
    const FlankGrid grid = test::barrel_grid();
    std::istringstream text(flank_csv(grid));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "flank,h_mm,theta_deg,x_mm,y_mm,z_mm,nx,ny,nz");
    std::size_t lines = 0;
    while (std::getline(text, line)) {
        const std::size_t side = lines / (8 * grid.angles.size()), place = lines % (8 * grid.angles.size());
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream cells(line);
        double flank, h, theta, x, y, z;
        cells >> flank >> h >> theta >> x >> y >> z;
        EXPECT_EQ(flank, grid.flanks[side].flank);
        EXPECT_EQ(x, grid.flanks[side].points[place].x() / millimetre);
        EXPECT_EQ(z, grid.flanks[side].points[place].z() / millimetre);
        ++lines;
    }
    EXPECT_EQ(lines, 2 * 8 * grid.angles.size());
    EXPECT_GE(lines, 3200u);
}

TEST(GrooveBody, IsSweptSolidOfRoller) {
    for (const FlankGrid& grid : {test::barrel_grid(), test::rotating_grid(), test::closed_grid()}) {
        const TriangleMesh body = groove_body(grid);
        EXPECT_TRUE(mesh_edges(body).watertight());
        EXPECT_GT(volume(body), 0.0);
    }
    // Cylindrical cam at rest: the groove is a ring, r wide to either side.
    FollowerMotion rest;
    rest.state = [](double) { return FollowerState{}; };
    rest.breakpoints = {0.0, test::full_turn};
    FlankSampling sampling;
    sampling.angles = 721;
    const TriangleMesh ring = groove_body(flank_grid(test::translating_cam(), rest, sampling));
    const double mean = 0.5 * (60.0 + 45.0), section = 20.0 * 15.0;
    EXPECT_NEAR(volume(ring) / std::pow(millimetre, 3) / (test::full_turn * mean * section), 1.0, 1e-4);
}

TEST(GroovedCam, IsABlankWithoutItsGroove) {
    const FlankGrid grid = test::closed_grid(361);
    const GroovedBlank blank = test::closed_blank();
    const TriangleMesh cam = grooved_cam(grid, blank);
    EXPECT_TRUE(mesh_edges(cam).watertight());
    const double whole = std::numbers::pi * (std::pow(62.0, 2) - std::pow(15.0, 2)) * 90.0;
    const double groove = volume(groove_body(grid)) / std::pow(millimetre, 3);
    // The groove body ends where the roller does, at 60 mm or a little more; the blank at 62 mm.
    const double cam_volume = volume(cam) / std::pow(millimetre, 3);
    EXPECT_LT(cam_volume, whole - groove);
    EXPECT_GT(cam_volume, whole - groove - std::numbers::pi * (62.0 * 62.0 - 60.0 * 60.0) * 90.0);
}

TEST(GroovedCam, RefusesWhatIsNoSuchCam) {
    EXPECT_EQ(refusal([&] {
                  (void)grooved_cam(test::barrel_grid(), {0.02, 0.2, -0.2, 0.2});
              }),
              "grooved cam: the groove does not close, its ends are 142.314 mm apart");
    GroovedBlank blank = test::closed_blank();
    blank.upper = 40.0 * millimetre;
    EXPECT_EQ(refusal([&] { (void)grooved_cam(test::closed_grid(), blank); }),
              "grooved cam: the groove reaches z = 40.2213 mm, beyond the blank");
    blank = test::closed_blank();
    blank.bore_radius = 50.0 * millimetre;
    EXPECT_EQ(refusal([&] { (void)grooved_cam(test::closed_grid(), blank); }),
              "grooved cam: the groove reaches into the bore");
    blank.bore_radius = 0.0;
    EXPECT_EQ(refusal([&] { (void)grooved_cam(test::closed_grid(), blank); }),
              "grooved cam: the blank needs 0 < bore radius < outer radius and lower < upper end");
}

}  // namespace flank_surfaces_test
}  // namespace camopt

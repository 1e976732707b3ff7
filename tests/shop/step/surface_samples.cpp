// SPDX-License-Identifier: MIT
// surface_samples FOLDER: the reference cams as files for step_read_back.py and stl_read_back.py.
#include "tests/report/surface/surface_samples.hpp"

#include "report/spatial/flank_surfaces.hpp"
#include "report/surface/triangle_mesh.hpp"
#include "shop/step/step_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace camopt;

void write(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

void write_flanks(const std::filesystem::path& folder, const std::string& name, const FlankGrid& grid) {
    write(folder / (name + ".csv"), flank_csv(grid));
    write(folder / (name + "_groove.stl"), stl_bytes(groove_body(grid), name));
    if (!step_available()) return;
    std::vector<BsplineSurface> surfaces;
    for (const SurfaceGrid& flank : flank_surfaces(grid))
        for (BsplineSurface& surface : bspline_surfaces(flank)) surfaces.push_back(std::move(surface));
    write_step_file(folder / (name + ".step"), surfaces);
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) return 2;
    const std::filesystem::path folder = words[1];
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    write_flanks(folder, "barrel", test::barrel_grid());
    write_flanks(folder, "rotating", test::rotating_grid());
    write_flanks(folder, "translating", test::closed_grid());
    write(folder / "translating_cam.stl",
          stl_bytes(grooved_cam(test::closed_grid(), test::closed_blank()), "cylindrical cam"));
    return 0;
}

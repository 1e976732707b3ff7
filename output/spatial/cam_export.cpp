// SPDX-License-Identifier: MIT
#include "output/spatial/cam_export.hpp"

#include "core/text/text_file.hpp"
#include "core/units.hpp"
#include "output/spatial/drum_pictures.hpp"
#include "output/spatial/flank_surfaces.hpp"
#include "output/spatial/indexing_body.hpp"
#include "output/surface/mesh_files.hpp"
#include "output/surface/step/step_file.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace camopt {

namespace {

using Paths = std::vector<std::filesystem::path>;

constexpr double same_angle = 1e-9;  // rad

void write_bytes(Paths& written, const std::filesystem::path& path, const std::string& bytes) {
    write_text_file(path, bytes);
    written.push_back(path);
}

void write_step(Paths& written, const std::filesystem::path& path, const FlankGrid& grid,
                const std::string& part) {
    std::vector<BsplineSurface> surfaces;
    for (const SurfaceGrid& flank : flank_surfaces(grid))
        for (BsplineSurface& surface : bspline_surfaces(flank)) surfaces.push_back(std::move(surface));
    write_step_file(path, surfaces, part);
    written.push_back(path);
}

std::string picture_of(const CamFlanks& cam, const FollowerMotion& motion, const FlankGrid& grid,
                       const std::string& title) {
    return mesh_svg(drum_parts(cam, motion, grid), drum_view(cam), title);
}

}  // namespace

bool indexes(const CamFlanks& cam, const FollowerMotion& motion) {
    const bool turn = is_whole_turn(motion.end() - motion.begin());
    const double advance = motion.state(motion.end()).s - motion.state(motion.begin()).s;
    return turn && cam.swings && std::abs(advance) > same_angle;
}

Paths write_cam_files(const std::filesystem::path& folder, const CamFlanks& cam, const FollowerMotion& motion,
                      const CamExportOptions& options) {
    const bool indexing = indexes(cam, motion);
    const FollowerMotion way = indexing ? IndexingGroove(cam, motion, cam.roller_length).path() : motion;
    FlankSampling sampling = options.sampling;
    if (indexing)  // as dense as over one turn
        sampling.angles =
            static_cast<int>(std::ceil(sampling.angles * (way.end() - way.begin()) / units::turn));
    const FlankGrid grid = flank_grid(cam, way, sampling);
    const TriangleMesh body =
        indexing && (options.stl || options.obj) ? indexing_body(cam, motion) : TriangleMesh{};
    Paths written;
    if (options.csv) write_bytes(written, folder / "flanks.csv", flank_csv(grid));
    if (options.step) write_step(written, folder / "flanks.step", grid, options.title);
    if (options.stl) {
        write_bytes(written, folder / "groove.stl", stl_bytes(groove_body(grid), options.title + ", groove"));
        if (indexing) write_bytes(written, folder / "cam.stl", stl_bytes(body, options.title));
    }
    if (options.obj) {
        std::vector<NamedMesh> parts;
        for (const SurfaceGrid& flank : flank_surfaces(grid)) parts.push_back({flank.name, mesh_of(flank)});
        if (indexing) parts.push_back({"body", body});
        write_bytes(written, folder / "cam.obj", obj_text(parts, options.title));
    }
    if (options.picture)
        write_bytes(written, folder / "cam.svg", picture_of(cam, motion, grid, options.title));
    return written;
}

}  // namespace camopt

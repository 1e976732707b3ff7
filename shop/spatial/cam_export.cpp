// SPDX-License-Identifier: MIT
#include "shop/spatial/cam_export.hpp"

#include "core/text/text_file.hpp"
#include "report/spatial/drum_svg.hpp"
#include "report/spatial/flank_surfaces.hpp"
#include "report/spatial/indexing_body.hpp"
#include "shop/step/step_file.hpp"

namespace camopt {

namespace {

using Paths = std::vector<std::filesystem::path>;

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

Paths write_cam_files(const std::filesystem::path& folder, const CamFlanks& cam, const FollowerMotion& motion,
                      const CamExportOptions& options) {
    const bool indexing = indexes(cam, motion);
    const FollowerMotion way = indexing ? IndexingGroove(cam, motion, cam.roller_length).path() : motion;
    FlankSampling sampling = options.sampling;
    if (indexing)  // as dense as over one turn
        sampling.angles =
            static_cast<int>(std::ceil(sampling.angles * (way.end() - way.begin()) / units::turn));
    const FlankGrid grid = flank_grid(cam, way, sampling);
    Paths written;
    if (options.csv) write_bytes(written, folder / "flanks.csv", flank_csv(grid));
    if (options.step) write_step(written, folder / "flanks.step", grid, options.title);
    if (options.stl) {
        write_bytes(written, folder / "groove.stl", stl_bytes(groove_body(grid), options.title + ", groove"));
        if (indexing)
            write_bytes(written, folder / "cam.stl", stl_bytes(indexing_body(cam, motion), options.title));
        else if (groove_closes(motion))
            write_bytes(written, folder / "cam.stl",
                        stl_bytes(drum_solid(cam, motion, sampling), options.title));
    }
    if (options.picture)
        write_bytes(written, folder / "cam.svg", picture_of(cam, motion, grid, options.title));
    return written;
}

}  // namespace camopt

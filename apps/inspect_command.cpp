// SPDX-License-Identifier: MIT
// camopt inspect: a measured cam compared with the nominal one of a scene, which is solved, or of a result
// folder, which is used as it is.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/inspect/inspection_output.hpp"

#include <fmt/format.h>

namespace camopt::apps {

ExitCode inspect_command(const InspectRequest& request) {
    const input::InspectedTable table = input::read_inspected_table(request.table);
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;
    const Solution nominal = solved_or_read(request.scene, request.settings, [](const Scene&) {});
    if (!nominal.motion)
        throw InputError(fmt::format("{}: found no motion; allowed: a scene that has one", request.scene));
    if (request.tolerance_um && nominal.scene.motion.lift_is_angle && !table.points)
        throw InputError(
            "--tolerance-um: found a length for deviations that are angles; allowed: with points of the cam, "
            "or with displacements that are lengths");
    std::optional<double> tolerance = request.tolerance_um;
    if (tolerance) *tolerance *= 1e-6;
    const Inspection found =
        inspect_cam(nominal, table, request.probe_radius_mm * units::millimetre, tolerance);
    const InspectionOutput output = inspection_output(
        found, fmt::format("{} compared with {}", table.file, request.scene), {{}, request.command, {}});
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        for (const FolderFile& file : output.files) folder.write(file.name, file.text);
        folder.finish();
    }
    print(request.json ? output.json : output.text);
    return found.out.empty() ? success : failure;
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
#include "output/machine/machine_folder.hpp"

#include "input/machine/machine_reader.hpp"
#include "input/scene_reader.hpp"
#include "output/json/certificate_json.hpp"
#include "output/machine/machine_output.hpp"
#include "output/machine/machine_view.hpp"
#include "output/page/page_html.hpp"
#include "output/plc/plc_export.hpp"
#include "output/report/result_folder.hpp"
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

CurvePage page_of(const MachineView& view) {
    return {.title = view.solution.spec.title.empty() ? "Machine" : view.solution.spec.title,
            .tone = view.solution.axes.empty() ? "bad" : "good",
            .headline = view.headline,
            .sentences = view.sentences,
            .angles = view.angles,
            .curves = view.curves,
            .tables = view.tables,
            .notes = view.solution.notes};
}

}  // namespace

std::vector<RunOrigin> origins_of(const MachineRun& run, const MachineSolution& solution) {
    std::vector<RunOrigin> origins;
    origins.reserve(solution.spec.axes.size());
    for (const AxisSpec& axis : solution.spec.axes) {
        std::vector<std::string> settings = axis.settings;
        settings.push_back(input::speed_setting(solution.speed));
        const MotionSpec& motion = axis.scene.motion;
        const std::size_t own = origins.size();
        for (std::size_t s = 0; solution.timing && s < motion.own_segments(); ++s) {
            if (!solution.timing->searched[own][s]) continue;
            settings.push_back(fmt::format("motion.segments[{}].angle_deg={:.15g}", s,
                                           degrees_shown.of(motion.segments[s].angle)));
        }
        origins.push_back({axis.file, run.command,
                           input::scene_with_overrides(input::scene_file_text(axis.file), axis.file, settings,
                                                       std::filesystem::path(axis.file).parent_path())});
    }
    return origins;
}

void write_machine_folder(const std::filesystem::path& out, const MachineRun& run,
                          const MachineSolution& solution) {
    const std::vector<RunOrigin> origins = origins_of(run, solution);
    const RunOrigin own{run.file, run.command, {}};
    for (std::size_t b = 0; b < solution.axes.size(); ++b) {
        const Solution& axis = solution.axes[b];
        const View view(axis);
        std::vector<FolderFile> also = result_extras(view, origins[b]);
        if (!run.plc.empty())
            for (const PlcFile& file : plc_export(axis, run.plc, {}).files)
                also.push_back({file.name, file.text});
        write_result_folder(out / solution.spec.axes[b].name, view, origins[b], {{}, false, std::move(also)});
    }
    FolderUpdate folder(out);
    for (const char* const name : {"impossible.json", "timing.svg"}) folder.remove_earlier(name);
    const MachineView view(solution);
    if (!view.curves.empty()) folder.write("timing.svg", timing_svg(view));
    folder.write("report.html", curve_page_html(page_of(view), own));
    folder.write("report.md", machine_markdown(view, own));
    // With the scenes of its axes beside it: the machine can be run and checked from its folder alone.
    std::vector<std::string> settings = input::machine_settings(run.settings, solution.spec);
    for (std::size_t b = 0; b < origins.size(); ++b) {
        const std::string name = solution.spec.axes[b].name + ".toml";
        settings.push_back(fmt::format("axis[{}].scene=\"{}\"", b, name));
        folder.write(name, origins[b].scene_text);
    }
    folder.write("machine.toml",
                 input::scene_with_overrides(input::scene_file_text(run.file), run.file, settings));
    folder.write("certificate.json", certificate_json(solution.certificate));
    if (solution.impossible) folder.write("impossible.json", impossible_json(solution));
    folder.write("machine.json", machine_json(solution, own, origins));  // last: the rest is complete then
    folder.finish();
}

}  // namespace camopt

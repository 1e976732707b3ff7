// SPDX-License-Identifier: MIT
// camopt machine: several axes on one master, their largest speed or least objective, with its proof.
#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "output/json/certificate_json.hpp"
#include "output/machine/machine_output.hpp"
#include "output/machine/machine_view.hpp"
#include "output/page/page_html.hpp"
#include "output/plc/plc_export.hpp"
#include "output/report/result_folder.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/machine/machine.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace camopt::apps {

namespace {

MachineSolution solve_with_progress(const MachineRequest& request, const MachineSpec& machine) {
    MachineOptions options;
    if (request.speed_gap) options.speed_gap = *request.speed_gap;
    if (request.max_seconds) options.max_seconds = *request.max_seconds;
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    try {
        MachineSolution solution = solve_machine(machine, options, control);
        end_progress();
        return solution;
    } catch (const SceneError& error) {
        end_progress();
        input::fail_in_machine(request.scene, request.settings, machine, error.fault());
    }
}

/// The scene of every axis as it was solved.
std::vector<RunOrigin> origins_of(const MachineRequest& request, const MachineSolution& solution) {
    std::vector<RunOrigin> origins;
    origins.reserve(solution.spec.axes.size());
    for (const AxisSpec& axis : solution.spec.axes) {
        std::vector<std::string> settings = {input::speed_setting(solution.speed)};
        const MotionSpec& motion = axis.scene.motion;
        const std::size_t own = origins.size();
        for (std::size_t s = 0; solution.timing && s < motion.own_segments(); ++s) {
            if (!solution.timing->searched[own][s]) continue;
            settings.push_back(fmt::format("motion.segments[{}].angle_deg={:.15g}", s,
                                           motion.segments[s].angle / units::degree));
        }
        origins.push_back({axis.file, request.command,
                           input::scene_with_overrides(input::scene_file_text(axis.file), axis.file, settings,
                                                       std::filesystem::path(axis.file).parent_path())});
    }
    return origins;
}

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

void write_results(const MachineRequest& request, MachineSolution& solution,
                   const std::vector<RunOrigin>& origins, const RunOrigin& own) {
    const std::filesystem::path out = request.out;
    for (std::size_t b = 0; b < solution.axes.size(); ++b) {
        Solution& axis = solution.axes[b];
        if (!InterruptWatch::interrupted()) add_forward_check(axis);
        const View view(axis);
        std::vector<FolderFile> also = result_extras(view, origins[b]);
        if (!request.plc.empty())
            for (const PlcFile& file : plc_export(axis, request.plc, {}).files)
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
    std::vector<std::string> settings = request.settings;
    for (std::size_t b = 0; b < origins.size(); ++b) {
        const std::string name = solution.spec.axes[b].name + ".toml";
        settings.push_back(fmt::format("axis[{}].scene=\"{}\"", b, name));
        folder.write(name, origins[b].scene_text);
    }
    folder.write("machine.toml",
                 input::scene_with_overrides(input::scene_file_text(request.scene), request.scene, settings));
    folder.write("certificate.json", certificate_json(solution.certificate));
    if (solution.impossible) folder.write("impossible.json", impossible_json(solution));
    folder.write("machine.json", machine_json(solution, own, origins));  // last: the rest is complete then
    folder.finish();
}

}  // namespace

ExitCode machine_command(const MachineRequest& request) {
    const auto load = [](const std::filesystem::path& file, std::span<const std::string> settings) {
        return camopt::load_scene(file, settings);
    };
    const MachineSpec machine = input::read_machine(request.scene, load, request.settings);
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written: Ctrl-C must not lose them
    MachineSolution solution = solve_with_progress(request, machine);
    const std::vector<RunOrigin> origins = origins_of(request, solution);
    const RunOrigin own{request.scene, request.command, {}};
    if (!request.out.empty()) write_results(request, solution, origins, own);
    std::string text = request.json ? machine_json(solution, own, origins) : machine_text(solution);
    if (!request.out.empty() && !request.json) text += "wrote " + request.out + "\n";
    print(text);
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps

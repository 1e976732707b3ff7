// SPDX-License-Identifier: MIT
// camopt machine: several axes on one master, their largest speed or least objective, with its proof.
#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "output/machine/machine_folder.hpp"
#include "output/machine/machine_output.hpp"
#include "output/report/result_folder.hpp"
#include "studies/checked/checked_cam.hpp"

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

}  // namespace

ExitCode machine_command(const MachineRequest& request) {
    const MachineSpec machine = input::read_machine(request.scene, camopt::load_scene, request.settings);
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written: Ctrl-C must not lose them
    MachineSolution solution = solve_with_progress(request, machine);
    const MachineRun run = machine_run(request.scene, request.settings, request.command, solution);
    for (Solution& axis : solution.axes)
        if (!request.out.empty() && !InterruptWatch::interrupted()) add_forward_check(axis);
    if (!request.out.empty()) write_machine_folder(request.out, run, solution, request.plc);
    std::string text = request.json ? machine_json(solution, run.machine, run.axes) : machine_text(solution);
    if (!request.out.empty() && !request.json) text += "wrote " + request.out + "\n";
    print(text);
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps

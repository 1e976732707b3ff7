// SPDX-License-Identifier: MIT
// camopt compare, dynamics, inspect, valves, machine: studies beside a solve; report.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/text/parsing.hpp"
#include "core/unit.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "report/compare/comparison_document.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/dynamics/dynamics_document.hpp"
#include "report/exports/workshop.hpp"
#include "report/folders/result_folder_reader.hpp"
#include "report/inspect/inspection_document.hpp"
#include "report/machine/machine_document.hpp"
#include "report/machine/machine_folder.hpp"
#include "report/machine/machine_json.hpp"
#include "report/page/result_page.hpp"
#include "report/valves/valves_document.hpp"
#include "studies/checked/checked_cam.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

/// The result of a computation that Ctrl-C stops, with a line of progress; the caller watches.
template <class Compute>
auto with_progress(const Compute& compute) {
    auto result = compute(SolveControl{InterruptWatch::interrupted, terminal_progress()});
    end_progress();
    return result;
}

// camopt dynamics: the elastic follower train over speed, under the optimum and the classical laws.
constexpr int most_study_speeds = 100'000;

/// "100:400:61" in rpm.
SpeedSweep read_speeds(const std::string& text) {
    const auto refuse = [&] {
        return InputError(
            fmt::format("--speeds: found {}; allowed: FROM:TO:COUNT in rpm, 0 < FROM <= TO, COUNT from 1 "
                        "to {}",
                        text, most_study_speeds));
    };
    std::vector<double> numbers;
    for (const std::string_view part : split_text(text, ':', {})) {
        const auto number = number_in(part);
        if (!number) throw refuse();
        numbers.push_back(*number);
    }
    if (numbers.size() != 3) throw refuse();
    const bool whole =
        numbers[2] == std::floor(numbers[2]) && numbers[2] >= 1.0 && numbers[2] <= most_study_speeds;
    if (!whole || !(numbers[0] > 0.0) || !(numbers[1] >= numbers[0]) || !std::isfinite(numbers[1]))
        throw refuse();
    return {numbers[0] * units::revolution_per_minute, numbers[1] * units::revolution_per_minute,
            static_cast<int>(numbers[2])};
}

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

/// The folder of a study where it has one, then the console.
template <class Request>
void write_and_print(const Document& document, const Request& request, const DocumentNames& names,
                     const RunOrigin& origin) {
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        for (const FolderFile& file : document_files(document, origin, names))
            folder.write(file.name, file.text);
        folder.finish();
    }
    print(request.json ? document_json(document) : console_text(document));
}

}  // namespace

ExitCode compare_command(const CompareRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;
    Comparison comparison =
        with_progress([&](const SolveControl& control) { return compare(loaded.scene, control); });
    show_in(comparison.optimum.scene, request.units);
    const RunOrigin origin{request.scene, request.command, std::move(loaded.text)};
    write_and_print(comparison_document(comparison, origin), request, {"comparison.html", "comparison.json"},
                    origin);
    return exit_code_of(comparison.optimum.certificate.verdict);
}

ExitCode dynamics_command(const DynamicsRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    const SpeedSweep speeds =
        request.speeds.empty() ? default_speeds(loaded.scene) : read_speeds(request.speeds);
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;
    const TrainStudy study = with_progress(
        [&](const SolveControl& control) { return train_study(loaded.scene, speeds, control); });
    write_and_print(dynamics_document(study), request, {"dynamics.html", "dynamics.json"},
                    {request.scene, request.command, std::move(loaded.text)});
    return exit_code_of(study.optimum.certificate.verdict);
}

/// A measured cam compared with the nominal one of a scene, which is solved, or of a result folder, which is
/// used as it is.
ExitCode inspect_command(const InspectRequest& request) {
    const input::InspectedTable table = input::read_inspected_table(
        request.table, {request.columns.empty() ? std::vector<std::string>{} : column_names(request.columns),
                        request.scale, request.offset});
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;
    const Solution nominal = solved_or_read(request.scene, request.settings, [](const Scene&) {});
    if (!nominal.motion)
        throw InputError(fmt::format("{}: found no motion; allowed: a scene that has one", request.scene));
    if (request.tolerance_um && nominal.scene.motion.lift_is_angle && !table.points)
        throw InputError(
            "--tolerance-um: found a length for deviations that are angles; allowed: with points of the cam, "
            "or with displacements that are lengths");
    InspectionTolerance tolerance = inspection_tolerance(nominal.scene);
    if (request.tolerance_um) tolerance = {*request.tolerance_um * unit_named<"um">.factor};
    const Inspection found =
        inspect_cam(nominal, table, request.probe_radius_mm * units::millimetre, tolerance);
    write_and_print(inspection_document(found, fmt::format("{} compared with {}", table.file, request.scene)),
                    request, {"inspection.html", "inspection.json"}, {{}, request.command});
    return found.in_tolerance() ? success : failure;
}

/// Intake and exhaust lobe of one crankshaft, each a scene, which is solved, or a result folder, which is
/// used as it is.
ExitCode valves_command(const ValvesRequest& request) {
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;
    const auto lobe = [&](const std::string& scene) {
        return solved_or_read(scene, {}, [](const Scene&) {});
    };
    Solution intake = lobe(request.intake);
    const Solution exhaust = lobe(request.exhaust);
    std::optional<ValveGap> gap;
    if (request.gap_mm)
        gap = ValveGap{*request.gap_mm * units::millimetre, request.included_deg * units::degree};
    const ValvePair pair = valve_pair(intake, exhaust, gap);
    show_in(intake.scene, request.units);
    const LengthUnit unit = intake.scene.length_unit, other = exhaust.scene.length_unit;
    Document document = valves_document(intake, exhaust, pair);
    if (request.units.empty() && unit != other)
        document.sections.front().sentences.push_back(
            {Sentence::Kind::remark, "units",
             fmt::format(
                 "Lengths are in {}, as the intake is written; the exhaust is written in {} (--units).",
                 name_of(unit), name_of(other))});
    write_and_print(document, request, {.json = "valves.json"}, {{}, request.command});
    return !pair.clearance || *pair.clearance > 0.0 ? success : failure;
}

/// Several axes on one master, their largest speed or least objective, with its proof.
ExitCode machine_command(const MachineRequest& request) {
    const MachineSpec machine = input::read_machine(request.scene, camopt::load_scene, request.settings);
    for (const AxisSpec& axis : machine.axes)
        if (workshop() != nullptr) workshop()->check_formats(axis.scene, request.plc);
    if (!request.out.empty()) prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written: Ctrl-C must not lose them
    MachineSolution solution = solve_with_progress(request, machine);
    const MachineRun run = machine_run(request.scene, request.settings, request.command, solution);
    for (Solution& axis : solution.axes)
        if (!request.out.empty() && !InterruptWatch::interrupted()) add_forward_check(axis);
    if (!request.out.empty())
        write_machine_folder(request.out, run, solution, controller_files(solution.axes, request.plc));
    std::string text = request.json ? machine_json(solution, run.machine, run.axes)
                                    : console_text(machine_document(solution));
    if (!request.out.empty() && !request.json) text += "wrote " + request.out + "\n";
    print(text);
    return exit_code_of(solution.certificate.verdict);
}

// camopt report: report.md and report.html of a result folder, written again; nothing is solved.
ExitCode report_command(const ReportRequest& request) {
    const auto load = [](const std::string& text, const std::string& name) {
        return load_scene(SceneText{name, text}, {});
    };
    const ResultFolder result = read_result_folder(request.folder, load);
    const InterruptWatch watch;
    FolderUpdate folder(request.folder);
    folder.write("report.html", report_html(result.solution, result.origin));
    for (const FolderFile& file : solution_texts(result.solution, result.origin))
        folder.write(file.name, file.text);
    print(written_lines(folder.finish()));
    return success;
}

}  // namespace camopt::apps

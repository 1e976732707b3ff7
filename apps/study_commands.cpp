// SPDX-License-Identifier: MIT
// camopt table, compare, dynamics: studies beside a solve.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/csv/study_csv.hpp"
#include "output/json/study_json.hpp"
#include "output/page/study_html.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/papers/reference_table.hpp"
#include "studies/response/train_study.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace camopt::apps {

namespace {

// camopt compare: every classical law on the scene, beside its optimum.
Comparison compare_with_progress(const Scene& scene) {
    const InterruptWatch watch;
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    Comparison comparison = compare(scene, control);
    end_progress();
    return comparison;
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
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(':', begin), text.size());
        const auto number = number_in(text.substr(begin, end - begin));
        if (!number) throw refuse();
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != 3) throw refuse();
    const bool whole =
        numbers[2] == std::floor(numbers[2]) && numbers[2] >= 1.0 && numbers[2] <= most_study_speeds;
    if (!whole || !(numbers[0] > 0.0) || !(numbers[1] >= numbers[0]) || !std::isfinite(numbers[1]))
        throw refuse();
    return {numbers[0] * units::revolution_per_minute, numbers[1] * units::revolution_per_minute,
            static_cast<int>(numbers[2])};
}

TrainStudy study_with_progress(const Scene& scene, const SpeedSweep& speeds) {
    const InterruptWatch watch;
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    TrainStudy study = train_study(scene, speeds, control);
    end_progress();
    return study;
}

}  // namespace

ExitCode table_command(const TableRequest& request) {
    if (!request.out.empty()) prepare_folder(request.out);
    const auto table = interruptible_run("the table", "solved ", spline_versus_modified_sine);
    if (!table) return failure;
    const PaperReport report = paper_004_report(*table);
    const std::string json = reference_table_json(*table);
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        folder.write("table.json", json);
        for (const auto& [name, text] : paper_report_files(report)) folder.write(name, text);
        folder.finish();
    }
    print(request.json ? json : paper_report_text(report));
    // Success only where every row is proved: an incomplete table must not pass as a whole one.
    return report.faults.empty() ? success : failure;
}

ExitCode compare_command(const CompareRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    if (!request.out.empty()) prepare_folder(request.out);
    Comparison comparison = compare_with_progress(loaded.scene);
    show_in(comparison.optimum.scene, request.units);
    const RunOrigin origin{request.scene, request.command, std::move(loaded.text)};
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        folder.write("comparison.csv", comparison_csv(comparison));
        folder.write("comparison.svg", comparison_svg(comparison));
        folder.write("comparison.html", comparison_html(comparison, origin));
        folder.write("comparison.json", comparison_json(comparison, origin));
        folder.finish();
    }
    const std::string text = request.json ? comparison_json(comparison, origin) : comparison_text(comparison);
    print(text);
    return exit_code_of(comparison.optimum.certificate.verdict);
}

ExitCode dynamics_command(const DynamicsRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    const SpeedSweep speeds =
        request.speeds.empty() ? default_speeds(loaded.scene) : read_speeds(request.speeds);
    if (!request.out.empty()) prepare_folder(request.out);
    const TrainStudy study = study_with_progress(loaded.scene, speeds);
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        folder.write("dynamics.csv", dynamics_csv(study));
        folder.write("history.csv", history_csv(study));
        folder.write("dynamics.json", dynamics_json(study));
        for (const auto& [name, picture] : dynamics_pictures(study)) folder.write(name, picture);
        folder.finish();
    }
    print(request.json ? dynamics_json(study) : dynamics_text(study));
    return exit_code_of(study.optimum.certificate.verdict);
}

}  // namespace camopt::apps

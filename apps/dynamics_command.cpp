// SPDX-License-Identifier: MIT
// camopt dynamics: the elastic follower train over speed, under the optimum and the classical laws.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/text/number_parsing.hpp"
#include "core/units.hpp"
#include "output/chart/studies/dynamics_svg.hpp"
#include "output/csv/dynamics_csv.hpp"
#include "output/json/dynamics_json.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/tables/dynamics_text.hpp"
#include "studies/response/train_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace camopt::apps {

namespace {

constexpr int most_study_speeds = 100'000;

/// "100:400:61" in rpm.
SpeedSweep read_speeds(const std::string& text) {
    const auto refuse = [&]() -> InputError {
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

// SPDX-License-Identifier: MIT
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/sweep/sweep_job.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/csv/sweep_csv.hpp"
#include "output/page/study_html.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace camopt::apps {

namespace {

FrontRequest front_request(const ParetoWords& words, const Scene& scene) {
    const std::size_t comma = words.goals.find(',');
    if (comma == std::string::npos)
        throw InputError(
            fmt::format("--pareto {}: found one name; allowed: two, with a comma between them, for "
                        "example velocity,acceleration",
                        words.goals));
    FrontRequest request;
    request.goals = {front_goal(words.goals.substr(0, comma), scene),
                     front_goal(words.goals.substr(comma + 1), scene)};
    if (words.points) request.points = *words.points;
    request.spacing = words.spacing;
    if (words.cut_off) request.cut_off = *words.cut_off;
    request.keep_weights = words.keep_weights;
    request.validate(scene);
    return request;
}

void refuse_other_sweeps(const SweepRequest& request) {
    if (request.weights.empty() && request.vary.empty() && request.shard.empty() && !request.resume) return;
    throw InputError(
        "--pareto: found together with --weights, --vary, --shard or --resume; allowed: one or the other");
}

/// With the scene's own dimensions in force: where it has no optimum the laws stand there all the same.
Comparison laws_of(const Scene& scene) {
    return compare(scene, {InterruptWatch::interrupted, {}});
}

ExitCode exit_code_of(const ParetoFront& front) {
    if (InterruptWatch::interrupted()) return interrupted;
    if (front.points.empty()) return failure;
    const auto verdict_is = [&](Verdict verdict) {
        return std::ranges::any_of(front.points, [&](const FrontPoint& point) {
            return point.solution.certificate.verdict == verdict;
        });
    };
    if (verdict_is(Verdict::failed)) return failure;
    if (front.complete) return success;
    return verdict_is(Verdict::infeasible) ? proved_infeasible : failure;
}

}  // namespace

ExitCode pareto_run(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError(
            "--out is missing: camopt sweep SCENE --pareto A,B --out DIR; see camopt sweep --help");
    refuse_other_sweeps(request);
    const LoadedScene loaded = load_scene_and_text(request.scene, sweep_settings(request));
    Scene scene = loaded.scene;
    show_in(scene, request.units);
    const FrontRequest wanted = front_request(request.pareto, scene);
    prepare_folder(request.out);
    const InterruptWatch watch;
    const auto progress = terminal_progress();
    const ParetoFront front =
        pareto_front(scene, wanted, {InterruptWatch::interrupted, {}}, [&](const FrontPoint& point) {
            if (progress) progress(fmt::format("front: {} solves", point.number + 1));
        });
    end_progress();
    const ExitCode code = exit_code_of(front);
    const Comparison laws = laws_of(scene);
    const ParetoPicture picture{front, scene, &laws};
    FolderUpdate folder(request.out);
    folder.write("pareto.csv", pareto_csv(front));
    folder.write("pareto.svg", pareto_svg(picture));
    folder.write("pareto.html", pareto_html(picture, {request.scene, "", loaded.text}));
    const std::filesystem::path table = folder.finish().front();
    print(fmt::format("Front of {}\n{}  wrote {}\n", request.scene, pareto_text(picture), table.string()));
    if (code == interrupted) print_error("camopt: interrupted; the points that are finished are written\n");
    return code;
}

}  // namespace camopt::apps

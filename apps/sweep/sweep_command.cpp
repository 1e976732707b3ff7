// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"
#include "apps/terminal.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/folders/result_folder.hpp"
#include "report/page/page_html.hpp"
#include "report/sweep/pareto_document.hpp"

#include <fmt/format.h>

#include <thread>

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

int worker_count(const SweepRequest& request) {
    if (request.workers) return *request.workers;
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 0 ? static_cast<int>(cores) : 1;
}

// camopt sweep merge: the shards of one sweep joined.
std::string rows_text(const SweepFolder& folder, int chunk) {
    const RowRange range = folder.identity().chunking.range(chunk);
    return fmt::format("rows {} to {}", range.begin, range.end - 1);
}

std::vector<SweepFolder> open_parts(const std::vector<std::string>& paths) {
    std::vector<SweepFolder> parts;
    for (const std::string& path : paths) {
        parts.push_back(SweepFolder::open(path));
        const std::string other = difference(parts.back().identity(), parts.front().identity());
        if (!other.empty())
            throw InputError(
                fmt::format("{} is not part of the sweep in {}: {}; allowed: shards of one sweep", path,
                            paths.front(), other));
    }
    return parts;
}

/// Which part holds each chunk.
std::map<int, const SweepFolder*> owners(const std::vector<SweepFolder>& parts) {
    std::map<int, const SweepFolder*> owner;
    for (const SweepFolder& part : parts)
        for (const int chunk : part.finished_chunks())
            if (const auto [place, is_new] = owner.emplace(chunk, &part); !is_new)
                throw InputError(fmt::format("{} are in {} and in {}; allowed: each row once",
                                             rows_text(part, chunk), place->second->path().string(),
                                             part.path().string()));
    const SweepFolder& first = parts.front();
    for (int chunk = 0; chunk < first.identity().chunking.count(); ++chunk) {
        if (owner.contains(chunk)) continue;
        for (const SweepFolder& part : parts)
            if (part.shard().holds(chunk))
                throw InputError(fmt::format("{} are missing: {} is not finished; continue it with --resume",
                                             rows_text(first, chunk), part.path().string()));
        throw InputError(fmt::format("{} are missing: no given folder holds their shard; allowed: all shards",
                                     rows_text(first, chunk)));
    }
    return owner;
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
    const Document document = pareto_document(picture, "Front of " + request.scene);
    FolderUpdate folder(request.out);
    for (const FolderFile& file :
         document_files(document, {request.scene, "", loaded.text}, {"pareto.html", "pareto.json"}))
        folder.write(file.name, file.text);
    folder.finish();
    print(fmt::format("{}wrote {}\n", console_text(document), request.out));
    if (code == interrupted) print_error("camopt: interrupted; the points that are finished are written\n");
    return code;
}

// camopt sweep: many solves of one scene, by worker processes, into a folder that can be continued.

SweepParts::SweepParts(const std::vector<std::string>& paths)
    : parts_(open_parts(paths)), owners_(owners(parts_)) {
    for (const auto& [chunk, part] : owners_) (void)part->read_chunk(chunk);
}

void SweepParts::write_to(const SweepFolder& whole) const {
    for (const auto& [chunk, part] : owners_) whole.write_chunk_text(chunk, part->chunk_text(chunk));
}

ExitCode sweep_command(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError("--out is missing: camopt sweep SCENE --out DIR; see camopt sweep --help");
    if (const RankLaunch launch = rank_launch(); launch.size > 1) return sweep_across_ranks(request, launch);
    SweepJob job(request);
    WorkFolder work(request, checked_sweep(request, job));
    const InterruptWatch watch;
    const PoolOutcome outcome =
        solve_missing_chunks(work.folder(), job, worker_count(request), [&] { work.leave_to_parent(); });
    if (outcome == PoolOutcome::stopped) return tell_interruption(work.folder());
    return finish_sweep(work.folder(), job.first_scene(), request.units);
}

ExitCode sweep_merge_command(const SweepMergeRequest& request) {
    if (request.out.empty()) throw InputError("--out is missing: camopt sweep merge DIR1 DIR2 … --out DIR");
    const SweepParts parts(request.parts);  // before anything is written
    const SweepFolder whole = SweepFolder::create(request.out, {parts.identity(), {}});
    parts.write_to(whole);
    return finish_sweep(whole);
}

}  // namespace camopt::apps

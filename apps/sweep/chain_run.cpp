// SPDX-License-Identifier: MIT
// camopt sweep --pareto and --surface: studies whose rows depend on those before, solved one after another.
#include "apps/sweep/sweep_job.hpp"
#include "apps/terminal.hpp"
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "report/folders/result_folder.hpp"
#include "report/page/page_html.hpp"
#include "report/sweep/pareto_document.hpp"
#include "report/sweep/sweep_document.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

// A crash loses no more than the solves of so many seconds.
constexpr double seconds_between_writes = 20.0;

/// What a study is asked, and the scene of all its rows.
struct Chain {
    Chain(const SweepRequest& given, const std::string& study, const std::string& option)
        : request(given), text(read_scene_text(request.scene)) {
        if (request.out.empty())
            throw InputError(fmt::format(
                "--out is missing: camopt sweep SCENE {} --out DIR; see camopt sweep --help", option));
        const bool other = request.surface.error && !request.pareto.goals.empty();
        if (other || !request.weights.empty() || !request.vary.empty() || !request.shard.empty())
            throw InputError(fmt::format(
                "{}: found together with --weights, --vary, --shard or {}; allowed: one or the other",
                option.substr(0, option.find(' ')), study == "surface" ? "--pareto" : "--surface"));
        const std::vector<std::string> settings = sweep_settings(request);
        scene = load_scene(text, settings);
        show_in(scene, request.units);
        sweep.identity.version = version();
        sweep.identity.scene_file = request.scene;
        sweep.identity.scene_text = text.text;
        sweep.identity.settings = settings;
        sweep.identity.study = study;
    }

    const SweepRequest& request;
    SceneText text;
    Scene scene;
    StoredSweep sweep;
};

/// What its rows came to.
struct Found {
    SweepTable table;
    Document document;
    std::string json;
    std::vector<FolderFile> also;
    ExitCode code;
};

/// Solves, keeps what is finished, writes the folder.
ExitCode run(const Chain& chain, const std::function<Found(const RowRun&)>& solve) {
    if (rank_launch().rank > 0) return success;  // one rank does it all
    const SweepRequest& request = chain.request;
    const WorkFolder work(request, chain.sweep);
    const SweepFolder& folder = work.folder();
    const InterruptWatch watch;
    const auto progress = terminal_progress();
    Stopwatch since_write;
    RowRun run{.control = {InterruptWatch::interrupted, {}}, .known = folder.written_rows()};
    if (request.results) run.found = result_keeper(folder, chain.text, chain.sweep.identity.settings);
    run.row_done = [&](const SweepTable& so_far, std::optional<double> error) {
        if (progress)
            progress(fmt::format("{}: {} solves{}", chain.sweep.identity.study, so_far.rows.size(),
                                 error ? ", error " + short_text(*error, 3) : ""));
        if (since_write.seconds() < seconds_between_writes || so_far.rows.size() <= run.known.size()) return;
        folder.write_rows(so_far);
        since_write = Stopwatch();
    };
    const Found found = solve(run);
    end_progress();
    folder.write_rows(found.table);
    write_study(folder, found.document, found.json, found.also);
    print(fmt::format("{}wrote {}\n", console_text(found.document), folder.table_path().string()));
    if (found.code == interrupted)
        print_error(
            "camopt: interrupted; the solves that are finished are written; the same command with "
            "--resume goes on\n");
    return found.code;
}

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

ExitCode exit_code_of(const ParetoFront& front) {
    if (InterruptWatch::interrupted()) return interrupted;
    if (front.points.empty()) return failure;
    const auto verdict_is = [&](Verdict verdict) {
        return std::ranges::any_of(front.points,
                                   [&](const FrontPoint& point) { return point.row.verdict == verdict; });
    };
    if (verdict_is(Verdict::failed)) return failure;
    if (front.complete) return success;
    return verdict_is(Verdict::infeasible) ? proved_infeasible : failure;
}

/// One unit of the file is a reference peak.
std::string surface_obj(const TradeOffSurface& surface, const std::string& title) {
    std::string text = fmt::format("# {}\n# lengths in mm\no trade-off_surface\n", printable(title));
    for (const SweepRow& row : surface.table.rows) {
        const PeakTriple point = surface.point(row);
        text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", point[0], point[1], point[2]);
    }
    for (const auto& corner : surface.triangles)
        text += fmt::format("f {} {} {}\n", corner[0] + 1, corner[1] + 1, corner[2] + 1);
    return text;
}

std::string end_words(const TradeOffSurface& surface, double asked_for) {
    switch (surface.end) {
        case SurfaceEnd::reached:
            return "";
        case SurfaceEnd::solves:
            return "; --most ended it";
        case SurfaceEnd::own_gaps:
            return fmt::format("; not the requested {}: some solves have larger gaps", short_text(asked_for));
        case SurfaceEnd::interrupted:
            return "; interrupted";
        case SurfaceEnd::no_motion:
            break;
    }
    const SweepRow& last = surface.table.rows.back();
    return fmt::format("; ended by a solve without a motion or a bound: {}{}{}", name_of(last.verdict),
                       last.reason.empty() ? "" : ", ", last.reason);
}

std::string surface_text(const TradeOffSurface& surface, double asked_for) {
    const std::size_t solves = surface.table.rows.size();
    if (!surface.hull) return fmt::format("No surface: {} solves{}", solves, end_words(surface, asked_for));
    return fmt::format(
        "{} solves: for every weight of velocity, acceleration and jerk the least objective is known to {}{}",
        solves, short_text(surface.error, 3), end_words(surface, asked_for));
}

ExitCode surface_exit_code(const TradeOffSurface& surface) {
    if (surface.end == SurfaceEnd::interrupted) return interrupted;
    if (surface.end != SurfaceEnd::no_motion) return success;
    return surface.table.rows.back().verdict == Verdict::infeasible ? proved_infeasible : failure;
}

PeakTriple weights_in(const std::string& text) {
    PeakTriple weights{};
    std::string_view rest = text;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t comma = rest.find(',');
        const std::optional<double> weight = number_in(rest.substr(0, comma));
        if (!weight || (comma == std::string_view::npos) != (k == 2))
            throw InputError(
                fmt::format("--at {}: allowed: three numbers with commas between them, the weights "
                            "of velocity, acceleration and jerk, for example 0.4,0.4,0.2",
                            text));
        weights[k] = *weight;
        if (k < 2) rest.remove_prefix(comma + 1);
    }
    return weights;
}

}  // namespace

ExitCode pareto_run(const SweepRequest& request) {
    Chain chain(request, "pareto", "--pareto A,B");
    chain.sweep.identity.axes = {"--pareto " + request.pareto.goals};
    if (request.pareto.keep_weights) chain.sweep.identity.axes.emplace_back("--keep-weights");
    const FrontRequest wanted = front_request(request.pareto, chain.scene);
    return run(chain, [&](const RowRun& run) {
        const ParetoFront front = pareto_front(chain.scene, wanted, run);
        const ExitCode code = exit_code_of(front);
        // With the scene's own dimensions in force: where it has no optimum the laws stand there all the
        // same.
        const Comparison laws = compare(chain.scene, run.control);
        return Found{front_table(front),
                     pareto_document({front, chain.scene, &laws}, chain.sweep.identity),
                     sweep_json(chain.sweep, front),
                     {},
                     code};
    });
}

ExitCode surface_run(const SweepRequest& request) {
    Chain chain(request, "surface", "--surface ERROR");
    SurfaceRequest wanted;
    wanted.error = *request.surface.error;
    if (request.surface.most) wanted.most_solves = *request.surface.most;
    wanted.validate(chain.scene);
    SweepIdentity& identity = chain.sweep.identity;
    identity.error = wanted.error;
    identity.axes = {fmt::format("--surface {:g}", wanted.error)};
    return run(chain, [&](const RowRun& run) {
        TradeOffSurface surface = trade_off_surface(chain.scene, wanted, run);
        mark_front(surface.table);
        const ExitCode code = surface_exit_code(surface);
        Document document{"Surface of " + request.scene};
        std::vector<FolderFile> also;
        if (surface.hull) {
            std::optional<LawLosses> losses;
            if (code != interrupted)
                losses = law_losses(chain.scene, {InterruptWatch::interrupted, terminal_progress()},
                                    peaks_of_rows(surface.table));
            document = sweep_document({surface.table, chain.scene, losses ? &*losses : nullptr}, identity);
            also = {{"surface.obj", surface_obj(surface, chain.scene.title)}};
        }
        if (document.sections.empty()) document.sections.emplace_back();
        document.title = "Surface of " + request.scene;
        document.sections.front().sentences = {
            {Sentence::Kind::headline, "error", surface_text(surface, wanted.error)}};
        return Found{surface.table, std::move(document), sweep_json(chain.sweep, surface), std::move(also),
                     code};
    });
}

ExitCode surface_look_up(const SweepRequest& request) {
    const PeakTriple weights = weights_in(request.surface.at);
    if (!SweepFolder::holds(request.scene, "surface"))
        throw InputError(
            fmt::format("--at: found no surface.json in {}; allowed: a folder of camopt sweep SCENE "
                        "--surface ERROR --out DIR",
                        request.scene));
    const SweepFolder folder = SweepFolder::open(request.scene, "surface");
    const SweepIdentity& identity = folder.identity();
    const Scene scene = load_scene(SceneText{identity.scene_file, identity.scene_text}, identity.settings);
    const RowRun nothing_more{.control = {[] { return true; }, {}}, .known = folder.written_rows()};
    SurfaceRequest given;
    given.error = identity.error.value_or(given.error);
    given.most_solves = std::max<int>(3, static_cast<int>(nothing_more.known.size()));
    const TradeOffSurface surface = trade_off_surface(scene, given, nothing_more);
    const SurfaceValue value = surface.at(weights);
    const SweepRow& row = surface.table.rows[value.nearest];
    std::string text = fmt::format("The least objective lies between {} and {}.\n",
                                   short_text(value.lower, 9), short_text(value.upper, 9));
    text += fmt::format("The upper one is that of row {}, solved at {:.4g}, {:.4g}, {:.4g}:", row.number,
                        row.settings[0], row.settings[1], row.settings[2]);
    for (const SweepFigure figure : {SweepFigure::velocity, SweepFigure::acceleration, SweepFigure::jerk})
        text += fmt::format(" {} = {}", cost_term(figure).symbol,
                            short_text(row.figure(figure).value_or(0.0), 6));
    print(text + "\n");
    return success;
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"
#include "apps/terminal.hpp"
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/folders/result_folder.hpp"
#include "report/page/page_html.hpp"
#include "report/sweep/sweep_document.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

constexpr const char *table_name = "surface.csv", *identity_name = "surface.json";
// A crash loses no more than the solves of so many seconds.
constexpr double seconds_between_writes = 20.0;

void refuse_other_studies(const SweepRequest& request) {
    if (request.weights.empty() && request.vary.empty() && request.shard.empty() &&
        request.pareto.goals.empty())
        return;
    throw InputError(
        "--surface: found together with --weights, --vary, --shard or --pareto; allowed: one or the other");
}

/// Rows of an earlier run of the same scene.
std::vector<SweepRow> known_rows(const std::string& folder, const SurfaceIdentity& identity) {
    const std::filesystem::path table = std::filesystem::path(folder) / table_name;
    const std::filesystem::path stored = std::filesystem::path(folder) / identity_name;
    if (!std::filesystem::exists(table) || !std::filesystem::exists(stored)) return {};
    const SurfaceIdentity earlier = read_surface_json(read_text_file(stored), stored.string());
    if (const std::string other = difference(earlier, identity); !other.empty())
        throw InputError(
            fmt::format("--resume: {} is of {}; allowed: the same scene and settings, or a folder "
                        "without a surface",
                        folder, other));
    return read_sweep_csv(read_text_file(table), table.string()).rows;
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
            return "; interrupted, --resume goes on";
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

std::vector<PeakTriple> peaks_of(const TradeOffSurface& surface) {
    std::vector<PeakTriple> peaks;
    for (const SweepRow& row : surface.table.rows) {
        if (!row.is_feasible()) continue;
        PeakTriple point = surface.point(row);
        for (std::size_t k = 0; k < 3; ++k) point[k] *= surface.reference[k];
        peaks.push_back(point);
    }
    return peaks;
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

ExitCode surface_run(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError(
            "--out is missing: camopt sweep SCENE --surface 1e-4 --out DIR; see camopt sweep --help");
    refuse_other_studies(request);
    const LoadedScene loaded = load_scene_and_text(request.scene, sweep_settings(request));
    Scene scene = loaded.scene;
    show_in(scene, request.units);
    SurfaceRequest wanted;
    wanted.error = *request.surface.error;
    if (request.surface.most) wanted.most_solves = *request.surface.most;
    wanted.validate(scene);
    const SurfaceIdentity identity{std::string(version()), request.scene, loaded.text, wanted.error};
    std::vector<SweepRow> known =
        request.resume ? known_rows(request.out, identity) : std::vector<SweepRow>{};
    prepare_folder(request.out);
    const std::filesystem::path folder(request.out);

    const InterruptWatch watch;
    const auto progress = terminal_progress();
    Stopwatch since_write;
    TradeOffSurface surface = trade_off_surface(
        scene, wanted, {InterruptWatch::interrupted, {}}, std::move(known), [&](const TradeOffSurface& now) {
            if (progress)
                progress(fmt::format("surface: {} solves, error {}", now.table.rows.size(),
                                     short_text(now.error, 3)));
            if (since_write.seconds() < seconds_between_writes) return;
            write_text_file(folder / table_name, sweep_csv(now.table));
            write_text_file(folder / identity_name, surface_json(identity, now));
            since_write = Stopwatch();
        });
    mark_front(surface.table);
    std::optional<LawLosses> losses;
    if (surface.hull && surface.end != SurfaceEnd::interrupted)
        losses = law_losses(scene, {InterruptWatch::interrupted, progress}, peaks_of(surface));
    end_progress();

    Document summary{"Surface of " + request.scene};
    summary.sections.push_back(
        {.sentences = {{Sentence::Kind::headline, "error", surface_text(surface, wanted.error)}}});
    FolderUpdate update(request.out);
    update.write(table_name, sweep_csv(surface.table));
    if (surface.hull) {
        const SweepPicture picture{surface.table, scene, losses ? &*losses : nullptr};
        SweepIdentity page;
        page.version = identity.version;
        page.scene_file = identity.scene_file;
        page.scene_text = identity.scene_text;
        page.axes = {fmt::format("--surface {:g}", wanted.error)};
        page.columns = surface.table.columns;
        Document document = sweep_document(picture, page);
        document.sections.front().sentences = summary.sections.front().sentences;
        update.write("surface.svg", chart_svg(*document.pictures().front()->chart));
        update.write("surface.html", document_html(document, {request.scene, "", loaded.text}));
        update.write("surface.obj", surface_obj(surface, scene.title));
    }
    update.write(identity_name, surface_json(identity, surface));
    const std::filesystem::path table = update.finish().front();
    print(fmt::format("{}wrote {}\n", console_text(summary), table.string()));
    return surface_exit_code(surface);
}

ExitCode surface_look_up(const SweepRequest& request) {
    const PeakTriple weights = weights_in(request.surface.at);
    const std::filesystem::path folder(request.scene);
    const std::filesystem::path stored = folder / identity_name, table = folder / table_name;
    if (!std::filesystem::exists(stored))
        throw InputError(fmt::format(
            "--at: found no {} in {}; allowed: a folder of camopt sweep SCENE --surface ERROR --out DIR",
            identity_name, request.scene));
    const SurfaceIdentity identity = read_surface_json(read_text_file(stored), stored.string());
    const Scene scene = load_scene(SceneText{identity.scene_file, identity.scene_text}, {});
    std::vector<SweepRow> rows = read_sweep_csv(read_text_file(table), table.string()).rows;
    SurfaceRequest given;
    given.error = identity.error;
    given.most_solves = std::max<int>(3, static_cast<int>(rows.size()));
    const SolveControl nothing_more{[] { return true; }, {}};
    const TradeOffSurface surface = trade_off_surface(scene, given, nothing_more, std::move(rows));
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

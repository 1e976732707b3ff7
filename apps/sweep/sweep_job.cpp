// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"

#include "apps/sweep/sweep_progress.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "input/scene_reader.hpp"
#include "report/chart/sweep/sweep_svg.hpp"
#include "report/folders/result_folder.hpp"
#include "report/machine/machine_folder.hpp"
#include "report/page/page_html.hpp"
#include "report/sweep/sweep_document.hpp"
#include "studies/checked/checked_cam.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

SweepFolder folder_for(const SweepRequest& request, const StoredSweep& sweep) {
    const std::string& study = sweep.identity.study;
    const bool goes_on = sweep.identity.is_grid() ? !is_unused_sweep_folder(request.out)
                                                  : SweepFolder::holds(request.out, study);
    if (!request.resume || !goes_on) return SweepFolder::create(request.out, sweep);
    SweepFolder folder = SweepFolder::open(request.out, study);
    const std::string other = difference(folder.identity(), sweep.identity);
    if (!other.empty())
        throw InputError(fmt::format("{} holds another {}: {}; allowed: the same {}, or another folder",
                                     request.out, study, other, study));
    const SweepShard &found = folder.shard(), &asked = sweep.shard;
    if (found.index != asked.index || found.count != asked.count)
        throw InputError(
            fmt::format("{} holds shard {}/{}, not {}/{}; allowed: the same shard, or another "
                        "folder",
                        request.out, found.index, found.count, asked.index, asked.count));
    return folder;
}

std::vector<SweepRow> failed_rows(const SweepPlan& plan, RowRange range, const std::string& reason) {
    std::vector<SweepRow> rows;
    for (int row = range.begin; row < range.end; ++row)
        rows.push_back(failed_row(row, plan.row(row), reason));
    return rows;
}

constexpr std::string_view simplex = "simplex:";

std::optional<int> integer(std::string_view text) {
    const std::optional<long long> value = integer_in(text);
    if (!value || !std::in_range<int>(*value)) return std::nullopt;
    return static_cast<int>(*value);
}

SweepAxis weights_axis(const std::string& weights) {
    if (!weights.starts_with(simplex)) return weights_of_csv(read_text_file(weights), weights);
    const std::optional<int> divisions = integer(std::string_view(weights).substr(simplex.size()));
    if (!divisions)
        throw InputError(
            fmt::format("--weights {}: found no number of divisions; allowed: simplex:N, for "
                        "example simplex:20, or a CSV file",
                        weights));
    return simplex_weights(*divisions);
}

/// The page of a finished sweep. A sweep of the weights of V, A, J gets the losses of the classical laws too,
/// which takes some solves; where they are interrupted the pictures are drawn without the rest.
Document finished_document(const SweepIdentity& identity, const SweepTable& table, std::string_view units) {
    Scene scene;
    if (identity.columns.machine)
        scene.title = input::machine_title(identity.scene_text).value_or("");
    else
        scene = load_scene({identity.scene_file, identity.scene_text}, identity.settings);
    show_in(scene, units);
    std::optional<LawLosses> losses;
    const InterruptWatch watch;
    if (!identity.columns.machine && is_weight_sweep(table)) {
        losses = law_losses(scene, {InterruptWatch::interrupted, terminal_progress()}, peaks_of_rows(table));
        end_progress();
    }
    return sweep_document({table, scene, losses ? &*losses : nullptr}, identity);
}

/// Of the results of a row.
std::filesystem::path row_folder(const SweepFolder& folder, int row) {
    return folder.path() / "rows" / fmt::format("{:06}", row);
}

/// Their page holds every row: 80 MB of it, more than a browser likes.
constexpr std::size_t most_drawn_rows = 100'000;

}  // namespace

SweepJob::SweepJob(const SweepRequest& request)
    : request_(request),
      scene_(read_scene_text(request.scene)),
      settings_(sweep_settings(request)),
      plan_(sweep_plan(request)),
      is_machine_(input::machine_title(scene_.text).has_value()),
      scenes_(plan_, [this](std::span<const std::string> row) {
          std::vector<std::string> all = settings_;
          all.insert(all.end(), row.begin(), row.end());
          return load_scene(scene_, all);
      }) {}

SweepIdentity SweepJob::identity(const SweepColumns& columns, const Chunking& chunking) const {
    SweepIdentity identity{std::string(version()), request_.scene,     scene_.text, settings_,
                           sweep_axes(request_),   fingerprint(plan_), columns,     chunking};
    if (!is_machine_) return identity;
    for (const AxisSpec& axis : machine(0).axes) {  // its rows depend on them too; kept as comments
        identity.scene_text += fmt::format("\n# {}: {}", axis.name, axis.file);
        const std::string text = read_text_file(axis.file);
        for (const std::string_view line : split_text(text, '\n'))
            identity.scene_text += fmt::format("\n# {}", line);
    }
    return identity;
}

std::vector<std::string> SweepJob::row_settings(int row) const {
    std::vector<std::string> settings = settings_;
    for (std::string& setting : settings_of(plan_.keys, plan_.row(row)))
        settings.push_back(std::move(setting));
    return settings;
}

MachineSpec SweepJob::machine(int row) const {
    try {
        return input::read_machine(request_.scene, camopt::load_scene, row_settings(row));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", row_text(plan_, row), error.what()));
    }
}

SweepColumns SweepJob::check() {
    if (!is_machine_) return check_rows(scenes_);
    for (int row = 0; row < plan_.rows(); ++row) (void)machine(row);
    SweepColumns columns;
    columns.keys = plan_.keys;
    columns.machine = true;
    return columns;
}

/// A machine takes seconds, and no row learns from another.
int SweepJob::chunk_size() {
    return is_machine_ ? 1 : chunk_size_for(scenes_);
}

SweepRow SweepJob::solve_machine_row(int row, const SweepFolder& folder) const {
    MachineOptions options;
    options.explain = request_.results;  // the table has no place for what each limit would have to be
    MachineSolution solution = solve_machine(machine(row), options);
    SweepRow found = machine_row(row, plan_.row(row), solution);
    if (!request_.results) return found;
    for (Solution& axis : solution.axes) add_forward_check(axis);
    write_machine_folder(row_folder(folder, row),
                         machine_run(request_.scene, row_settings(row), "", solution), solution);
    return found;
}

std::vector<SweepRow> SweepJob::solve(RowRange rows, const SweepFolder& folder,
                                      const std::function<void(const SweepRow&)>& row_done) const {
    if (!is_machine_) {
        SweepScenes scenes = scenes_;
        const FoundSolution keep =
            request_.results ? result_keeper(folder, scene_, settings_) : FoundSolution();
        return solve_chunk(scenes, rows, {}, row_done, keep);
    }
    std::vector<SweepRow> solved;
    for (int row = rows.begin; row < rows.end; ++row) {
        try {
            solved.push_back(solve_machine_row(row, folder));
        } catch (const std::exception& error) {
            solved.push_back(failed_row(row, plan_.row(row), fmt::format("error: {}", error.what())));
        }
        if (row_done) row_done(solved.back());
    }
    return solved;
}

FoundSolution result_keeper(const SweepFolder& folder, const SceneText& scene,
                            std::vector<std::string> settings) {
    return [&folder, scene, settings = std::move(settings)](int row, std::span<const std::string> own,
                                                            const Solution& solution) {
        std::vector<std::string> all = settings;
        all.insert(all.end(), own.begin(), own.end());
        const RunOrigin origin{scene.name, "", input::scene_with_overrides(scene.text, scene.name, all)};
        write_result_folder(row_folder(folder, row), View(solution), origin, {.for_programs = true});
    };
}

StoredSweep checked_sweep(const SweepRequest& request, SweepJob& job) {
    const SweepColumns columns = job.check();
    const Chunking chunking{job.plan().rows(), request.chunk.value_or(job.chunk_size())};
    return {job.identity(columns, chunking), sweep_shard(request)};
}

WorkFolder::WorkFolder(const SweepRequest& request, const StoredSweep& sweep, const SweepShard& share)
    : folder_(folder_for(request, sweep)), lock_(folder_.path()) {
    const int damaged = (share.is_whole() ? folder_ : folder_.part(share)).remove_leftovers();
    if (damaged > 0)
        print_error(fmt::format("camopt: {} chunk(s) in {} were damaged and are solved again\n", damaged,
                                request.out));
}

ExitCode tell_interruption(const SweepFolder& folder) {
    const std::size_t finished = folder.finished_chunks().size();
    print_error(
        fmt::format("camopt: interrupted; {} of {} chunks are finished and kept in {}; the same command "
                    "with --resume goes on\n",
                    finished, folder.chunks().size(), folder.path().string()));
    return interrupted;
}

PoolOutcome solve_missing_chunks(const SweepFolder& folder, SweepJob& job, int workers,
                                 const std::function<void()>& begin_child) {
    const std::vector<int> missing = folder.missing_chunks();
    SweepProgress progress(folder.identity().chunking, folder.chunks(), missing);
    const auto line = terminal_progress();
    const auto rows_of = [&](int chunk) { return folder.identity().chunking.range(chunk); };
    PoolTask task{missing, workers, job.fence()};
    task.work = [&](int chunk, const std::function<void(int)>& tell) {
        folder.write_chunk(chunk,
                           job.solve(rows_of(chunk), folder, [&](const SweepRow& row) { tell(row.number); }));
    };
    task.begin_child = begin_child;
    task.told = [&](int row) { progress.add(row); };
    task.lost = [&](int chunk, const std::string& reason) {
        folder.write_chunk(chunk, failed_rows(job.plan(), rows_of(chunk), reason));
    };
    if (line) task.tick = [&] { line(progress.text()); };
    task.stop_requested = InterruptWatch::interrupted;
    const PoolOutcome outcome = run_workers(task);
    end_progress();
    return outcome;
}

SweepPlan sweep_plan(const SweepRequest& request) {
    std::vector<SweepAxis> axes;
    for (const std::string& text : request.vary) axes.push_back(varied_key(text));
    if (!request.weights.empty()) axes.push_back(weights_axis(request.weights));
    return sweep_grid(axes);
}

std::vector<std::string> sweep_axes(const SweepRequest& request) {
    std::vector<std::string> words;
    for (const std::string& text : request.vary) words.push_back("--vary " + text);
    if (!request.weights.empty()) words.push_back("--weights " + request.weights);
    return words;
}

std::vector<std::string> sweep_settings(const SweepRequest& request) {
    return with_solver(request.settings, request.solver);
}

SweepShard sweep_shard(const SweepRequest& request) {
    if (request.shard.empty()) return {};
    const std::string_view text = request.shard;
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const std::optional<int> index = integer(text.substr(0, slash));
        const std::optional<int> count = integer(text.substr(slash + 1));
        if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
    }
    throw InputError(fmt::format(
        "--shard {}: not a fraction; allowed: i/N with i from 1 to N, for example 2/3", request.shard));
}

std::vector<PeakTriple> peaks_of_rows(const SweepTable& table) {
    std::vector<PeakTriple> peaks;
    for (const SweepRow& row : table.rows) {
        const auto &velocity = row.figure(SweepFigure::velocity),
                   &acceleration = row.figure(SweepFigure::acceleration),
                   &jerk = row.figure(SweepFigure::jerk);
        if (row.is_feasible() && velocity && acceleration && jerk)
            peaks.push_back({*velocity, *acceleration, *jerk});
    }
    return peaks;
}

void write_study(const SweepFolder& folder, const Document& document, const std::string& json,
                 const std::vector<FolderFile>& also) {
    const SweepIdentity& identity = folder.identity();
    const RunOrigin origin{identity.scene_file, "", identity.columns.machine ? "" : identity.scene_text};
    FolderUpdate update(folder.path());
    for (const FolderFile& file : document_files(document, origin, {identity.study + ".html", ""}))
        update.write(file.name, file.text);
    for (const FolderFile& file : also) update.write(file.name, file.text);
    if (!json.empty()) update.write(identity.study + ".json", json);
    update.finish();
}

ExitCode finish_sweep(const SweepFolder& folder, const Scene* scene, std::string_view units) {
    const SweepShard& shard = folder.shard();
    // The Pareto front of a part would be wrong, so a part gets no sweep.csv.
    SweepTable table = shard.is_whole() ? folder.write_table() : folder.table();
    // The table is written, its columns are in mm: from here on for people.
    table.columns.length_unit = length_unit_of(units, table.columns.length_unit);
    const std::string title =
        fmt::format("Sweep of {}{}", folder.identity().scene_file,
                    shard.is_whole() ? "" : fmt::format(", shard {} of {}", shard.index, shard.count));
    std::optional<Scene> shown;
    if (scene != nullptr) show_in(shown.emplace(*scene), units);
    std::string text = console_text(sweep_summary(table, shown ? &*shown : nullptr, title));
    if (shard.is_whole() && table.rows.size() <= most_drawn_rows)
        write_study(folder, finished_document(folder.identity(), table, units));
    else if (shard.is_whole())
        text +=
            fmt::format("no sweep.svg and sweep.html: they are drawn for at most {} rows\n", most_drawn_rows);
    text += shard.is_whole() ? fmt::format("wrote {}\n", folder.table_path().string())
                             : fmt::format("kept in {}; join the shards with camopt sweep merge\n",
                                           folder.path().string());
    print(text);
    return std::ranges::find(table.rows, Verdict::failed, &SweepRow::verdict) == table.rows.end() ? success
                                                                                                  : failure;
}

}  // namespace camopt::apps

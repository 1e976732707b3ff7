// SPDX-License-Identifier: MIT
#include "report/folders/result_folder.hpp"

#include "core/errors.hpp"
#include "core/platform/files.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "input/scene_text.hpp"
#include "report/cam/cam_files.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/result_json.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt {

namespace {

/// The files that not every result has, beside those of its cam.
constexpr std::array optional_files = {"motion.csv", "motion.svg",   "drive.svg",  "surge.svg",
                                       "scene.toml", "report.md",    "tables.csv", "report.html",
                                       "drum.svg",   "developed.svg"};

void write_for_people(FolderUpdate& writer, const View& view, const RunOrigin& origin,
                      const WriteOptions& options) {
    if (view.solution.motion) {
        writer.write("motion.csv", motion_csv(view));
        writer.write("motion.svg", motion_svg(view));
        if (view.solution.drive) writer.write("drive.svg", drive_svg(view));
        if (view.solution.surge) writer.write("surge.svg", surge_svg(view));
    }
    for (const CamFile& file : cam_files(view, {.points = options.points}))
        writer.write(file.name, file.text);
    for (const FolderFile& file : options.also) writer.write(file.name, file.text);
    for (const FolderFile& file : solution_texts(view.solution, origin)) writer.write(file.name, file.text);
}

constexpr const char* mark_text =
    "camopt was stopped while it wrote to this folder: it may contain files of two runs.\n"
    "Run the command again; this file is removed on success.\n";

void move_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error) throw InputError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

/// What is not there need not go.
void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) throw InputError(fmt::format("cannot remove {}: {}", path.string(), error.message()));
}

/// That of an earlier run.
void remove_proof_of_least(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::exists(folder / "certificate.json", error)) return;
    for (const char* const name : {"scene.toml", "certificate.json", "result.json"})
        remove_file(folder / name);
    std::filesystem::remove(folder, error);  // it stays where other files are in it
}

/// The folder of the scene that is infeasible beside it, for scripts/verify-certificate; a result that was
/// read back leaves it as it is.
void write_proof_of_least(const std::filesystem::path& folder, const std::optional<LeastReport>& least,
                          const RunOrigin& origin, std::vector<std::filesystem::path>& paths) {
    if (!least || !least->impossible) remove_proof_of_least(folder);
    if (!least || !least->proof) return;
    RunOrigin own = origin;
    own.scene_text = input::scene_text(least->proof->scene);
    for (std::filesystem::path& path :
         write_result_folder(folder, View(*least->proof), own, {.for_programs = true}))
        paths.push_back(std::move(path));
}

/// What killed runs left aside in this folder.
void remove_leftovers(const std::filesystem::path& folder) {
    constexpr std::string_view begin = ".camopt-", end = ".tmp";
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(begin) || !name.ends_with(end)) continue;
        const auto process =
            integer_in(std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size()));
        const bool gone = process && process_has_ended(*process);
        if (gone) std::filesystem::remove_all(entry.path(), ignored);
    }
}

}  // namespace

void prepare_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error))
        throw InputError(
            fmt::format("cannot write results into {}: it is a file, not a folder", folder.string()));
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError(fmt::format("cannot create the folder {}: {}", folder.string(), error.message()));
}

std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder, const View& view,
                                                       const RunOrigin& origin, const WriteOptions& options) {
    const Solution& solution = view.solution;
    FolderUpdate writer(folder);
    for (const char* const name : optional_files) writer.remove_earlier(name);
    for (const std::string& name : cam_file_names()) writer.remove_earlier(name);
    if (!options.for_programs) write_for_people(writer, view, origin, options);
    if (!origin.scene_text.empty())
        writer.write("scene.toml", solution.least ? input::scene_text(solution.scene) : origin.scene_text);
    writer.write("certificate.json", certificate_json(solution.certificate));
    writer.write("result.json", result_json(solution, origin));  // last: who sees it finds the rest complete
    std::vector<std::filesystem::path> paths = writer.finish();
    if (!origin.scene_text.empty())
        write_proof_of_least(folder / least_proof_folder, solution.least, origin, paths);
    return paths;
}

FolderUpdate::FolderUpdate(std::filesystem::path folder)
    : folder_(std::move(folder)), aside_(folder_ / fmt::format(".camopt-{}.tmp", process_number())) {
    prepare_folder(folder_);
    remove_leftovers(folder_);
    std::error_code ignored;
    std::filesystem::remove_all(aside_, ignored);  // of a process of the same number, killed
    prepare_folder(aside_);
}

FolderUpdate::~FolderUpdate() {
    std::error_code ignored;
    std::filesystem::remove_all(aside_, ignored);
}

void FolderUpdate::write(const std::string& name, std::string_view text) {
    write_text_file(aside_ / name, text);
    add(name);
}

void FolderUpdate::add(const std::string& name) {
    if (std::ranges::find(names_, name) != names_.end())
        throw ModelError(fmt::format("two files of a result have the name {}", name));
    names_.push_back(name);
}

std::vector<std::filesystem::path> FolderUpdate::finish() {
    std::vector<std::filesystem::path> paths;
    if (names_.empty()) return paths;
    write_text_file(aside_ / incomplete_mark, mark_text);
    move_file(aside_ / incomplete_mark, folder_ / incomplete_mark);
    remove_file(folder_ / names_.back());
    for (const std::string& name : names_) {
        if (name != names_.back()) move_file(aside_ / name, folder_ / name);
        paths.push_back(folder_ / name);
    }
    for (const std::string& name : earlier_)
        if (std::ranges::find(names_, name) == names_.end()) remove_file(folder_ / name);
    move_file(aside_ / names_.back(), folder_ / names_.back());
    remove_file(folder_ / incomplete_mark);
    return paths;
}

}  // namespace camopt
